//! The slope of real area against load: rows of the study `cargo xtask kappa`, and what follows
//! from them.
//!
//! With `x = p/(E* g)`, p the mean pressure and g the rms gradient of the surface as a continuum
//! (from its spectrum, not by differences between points), the area fraction of a random surface
//! under light load is nearly `kappa x`. Persson's theory has kappa = sqrt(8/π), the summit models
//! the limit sqrt(2π) at loads too light for any surface.

use contact_accuracy::round_to_digits;
use std::fmt::Write as _;

/// First line of the table.
pub const HEADER: &str = "periods,breadth,pixels,hurst,seed,bandwidth,closing,load,area,grid,gap";

/// Loads whose mean `A/x` is called kappa: areas of about 0.5 to 3.5 %.
pub const LIGHT: [f64; 5] = [0.0025, 0.004, 0.0063, 0.01, 0.016];

/// One map at one load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Side of the map over its longest self-affine wavelength; longer waves have a flat PSD.
    pub periods: usize,
    /// Longest over shortest self-affine wavelength.
    pub breadth: usize,
    /// Points per shortest wavelength.
    pub pixels: usize,
    /// Hurst exponent.
    pub hurst: f64,
    /// Seed of the map.
    pub seed: u64,
    /// Nayak's parameter of this map, `m0 m4 / m2²`, by its spectrum.
    pub bandwidth: f64,
    /// Load at which the last gap closes, over E* g.
    pub closing: f64,
    /// p/(E* g).
    pub load: f64,
    /// Area fraction corrected for the contact line.
    pub area: f64,
    /// Half width of its grid error: 0.3 of the correction, as area fraction.
    pub grid: f64,
    /// Mean gap over rms height.
    pub gap: f64,
}

impl Row {
    /// As a line of the table, six digits.
    pub fn line(&self) -> String {
        let mut line = format!(
            "{},{},{},{},{}",
            self.periods, self.breadth, self.pixels, self.hurst, self.seed
        );
        for v in [self.bandwidth, self.closing, self.load, self.area, self.grid, self.gap] {
            // Writing to a String cannot fail.
            let _ = write!(line, ",{}", round_to_digits(v, 6));
        }
        line
    }

    fn parse(line: &str) -> Option<Self> {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |k: usize| cells.get(k)?.parse::<f64>().ok();
        let whole = |k: usize| cells.get(k)?.parse::<usize>().ok();
        Some(Self {
            periods: whole(0)?,
            breadth: whole(1)?,
            pixels: whole(2)?,
            hurst: number(3)?,
            seed: cells.get(4)?.parse().ok()?,
            bandwidth: number(5)?,
            closing: number(6)?,
            load: number(7)?,
            area: number(8)?,
            grid: number(9)?,
            gap: number(10)?,
        })
    }
}

/// The rows of a table with its header; lines that begin with `#` are remarks. `None` if a line
/// cannot be read.
pub fn parse(text: &str) -> Option<Vec<Row>> {
    let mut lines = text.lines().filter(|l| !l.starts_with('#'));
    (lines.next()? == HEADER).then_some(())?;
    lines.map(Row::parse).collect()
}

/// The maps of one kind taken together.
#[derive(Debug, Clone, PartialEq)]
pub struct Kind {
    /// As in [`Row`].
    pub periods: usize,
    /// As in [`Row`].
    pub breadth: usize,
    /// As in [`Row`].
    pub pixels: usize,
    /// As in [`Row`].
    pub hurst: f64,
    /// How many maps.
    pub maps: usize,
    /// Mean of their Nayak parameters.
    pub bandwidth: f64,
    /// `A/x` at each load that all maps were solved at, rising.
    pub curve: Vec<Slope>,
    /// Its mean over the [`LIGHT`] loads.
    pub kappa: Slope,
    /// The same of each map, with its seed.
    pub each: Vec<(u64, f64)>,
}

/// A value of `A/x` with its two uncertainties.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slope {
    /// p/(E* g); the mean of several for a mean.
    pub load: f64,
    /// Mean over the maps.
    pub value: f64,
    /// 95 % half width of that mean from the scatter between maps (Student's t).
    pub sampling: f64,
    /// Half width from the grid, the same for every map.
    pub grid: f64,
}

impl Slope {
    /// Both uncertainties.
    pub fn uncertainty(&self) -> f64 {
        self.sampling + self.grid
    }
}

/// 97.5 % point of Student's t for 1 to 9 degrees of freedom (ISO 3534-1 tables).
const STUDENT: [f64; 9] = [12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262];

/// Kinds with at least two maps, in the order of the table; single maps solved on other grids
/// than they were made on are not among them.
pub fn kinds(rows: &[Row]) -> Vec<Kind> {
    let mut names: Vec<[usize; 3]> = Vec::new();
    let mut hursts: Vec<f64> = Vec::new();
    for r in rows {
        let name = [r.periods, r.breadth, r.pixels];
        if !names.iter().zip(&hursts).any(|(n, h)| *n == name && same(*h, r.hurst)) {
            names.push(name);
            hursts.push(r.hurst);
        }
    }
    names.into_iter().zip(hursts).filter_map(|(name, hurst)| kind(rows, name, hurst)).collect()
}

fn kind(rows: &[Row], [periods, breadth, pixels]: [usize; 3], hurst: f64) -> Option<Kind> {
    let of: Vec<&Row> = rows
        .iter()
        .filter(|r| [r.periods, r.breadth, r.pixels] == [periods, breadth, pixels])
        .filter(|r| same(r.hurst, hurst))
        .collect();
    let mut seeds: Vec<u64> = of.iter().map(|r| r.seed).collect();
    seeds.sort_unstable();
    seeds.dedup();
    let maps: Vec<Vec<&Row>> =
        seeds.iter().map(|s| of.iter().copied().filter(|r| r.seed == *s).collect()).collect();
    if maps.len() < 2 {
        return None;
    }
    let first = &maps[0];
    let curve = first
        .iter()
        .filter_map(|r| {
            let at: Vec<&Row> = maps
                .iter()
                .filter_map(|m| m.iter().copied().find(|o| same(o.load, r.load)))
                .collect();
            (at.len() == maps.len())
                .then(|| slope(&at.iter().map(|r| vec![*r]).collect::<Vec<_>>()))
        })
        .collect();
    let light: Vec<Vec<&Row>> = maps
        .iter()
        .map(|m| m.iter().copied().filter(|r| LIGHT.iter().any(|l| same(*l, r.load))).collect())
        .collect();
    Some(Kind {
        periods,
        breadth,
        pixels,
        hurst,
        maps: maps.len(),
        bandwidth: mean(maps.iter().map(|m| m[0].bandwidth)),
        curve,
        kappa: slope(&light),
        each: seeds.into_iter().zip(light.iter().map(|m| mean_slope(m))).collect(),
    })
}

/// Mean over maps of each map's mean `A/x` over its rows.
fn slope(maps: &[Vec<&Row>]) -> Slope {
    let [value, sampling] = student(&maps.iter().map(|m| mean_slope(m)).collect::<Vec<_>>());
    Slope {
        load: mean(maps.iter().map(|m| mean(m.iter().map(|r| r.load)))),
        value,
        sampling,
        grid: mean(maps.iter().map(|m| mean(m.iter().map(|r| r.grid / r.load)))),
    }
}

fn mean_slope(map: &[&Row]) -> f64 {
    mean(map.iter().map(|r| r.area / r.load))
}

/// Mean of a sample and 95 % half width of that mean.
fn student(values: &[f64]) -> [f64; 2] {
    let (n, middle) = (values.len(), mean(values.iter().copied()));
    let square = values.iter().map(|v| (v - middle).powi(2)).sum::<f64>() / (n as f64 - 1.0);
    [middle, quantile(n - 1) * (square / n as f64).sqrt()]
}

/// 97.5 % point of Student's t; beyond the table by its expansion for many degrees of freedom
/// (Abramowitz & Stegun 26.7.5).
fn quantile(freedom: usize) -> f64 {
    let one_over = 1.0 / freedom as f64;
    let expansion = 1.96 * (1.0 + one_over * (1.21 + one_over * 1.44));
    freedom.checked_sub(1).and_then(|k| STUDENT.get(k)).copied().unwrap_or(expansion)
}

/// Mean difference `b - a` of kappa over maps with the same seed, and its 95 % half width: such
/// maps are made of the same noise, so that most of their scatter is common to both.
pub fn difference(a: &Kind, b: &Kind) -> Option<[f64; 2]> {
    let of = |seed: u64| b.each.iter().find(|(s, _)| *s == seed);
    let pairs: Vec<f64> =
        a.each.iter().filter_map(|(seed, value)| Some(of(*seed)?.1 - value)).collect();
    (pairs.len() > 1).then(|| student(&pairs))
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, n) = values.fold((0.0, 0.0), |(s, n), v| (s + v, n + 1.0));
    sum / n
}

fn same(a: f64, b: f64) -> bool {
    (a / b - 1.0).abs() < 1e-9
}

/// `kappa = at_one - fall ln(bandwidth)`, least squares weighted by the sampling error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogLaw {
    /// Value continued to a bandwidth of 1.
    pub at_one: f64,
    /// Fall per unit of the natural logarithm.
    pub fall: f64,
    /// 95 % half width of the fall from the scatter between maps. Maps of the same seed are made of
    /// the same noise in every kind, so that kinds err together: each seed is left out of all kinds
    /// once (jackknife; Student's t).
    pub sampling: f64,
    /// Half width of the fall from the grid: what it is if every map errs by its whole bar.
    pub grid: f64,
    /// Largest distance of a kind from the law.
    pub largest: f64,
}

/// The logarithmic law through the kinds.
pub fn log_law(kinds: &[Kind]) -> LogLaw {
    let [at_one, fall] = line(kinds, |k| k.kappa.value);
    let [_, highest] = line(kinds, |k| k.kappa.value + k.kappa.grid);
    let mut seeds: Vec<u64> = kinds.iter().flat_map(|k| k.each.iter().map(|e| e.0)).collect();
    seeds.sort_unstable();
    seeds.dedup();
    let without = |seed: u64| line(kinds, |k| k.without(seed))[1];
    let falls: Vec<f64> = seeds.into_iter().map(without).collect();
    // Jackknife: (n - 1)² / n times the variance of the falls, which `student` divides by n.
    let n = falls.len() as f64;
    let miss = |k: &Kind| (k.kappa.value - at_one + fall * k.bandwidth.ln()).abs();
    LogLaw {
        at_one,
        fall,
        sampling: if n > 1.0 { (n - 1.0) * student(&falls)[1] } else { f64::NAN },
        grid: (highest - fall).abs(),
        largest: kinds.iter().map(miss).fold(0.0, f64::max),
    }
}

/// Value at a bandwidth of 1 and fall of the line through `value` over ln(bandwidth).
fn line(kinds: &[Kind], value: impl Fn(&Kind) -> f64) -> [f64; 2] {
    let weight = |k: &Kind| k.kappa.sampling.powi(-2);
    let sum = |f: &dyn Fn(&Kind) -> f64| kinds.iter().map(|k| weight(k) * f(k)).sum::<f64>();
    let w = sum(&|_| 1.0);
    let (middle, y) = (sum(&|k| k.bandwidth.ln()) / w, sum(&value) / w);
    let spread = sum(&|k| (k.bandwidth.ln() - middle).powi(2));
    let fall = -sum(&|k| (k.bandwidth.ln() - middle) * (value(k) - y)) / spread;
    [y + fall * middle, fall]
}

impl Kind {
    /// Its slope without the map of this seed.
    fn without(&self, seed: u64) -> f64 {
        let rest = self.each.iter().filter(|e| e.0 != seed);
        mean(rest.map(|e| e.1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(seed: u64, load: f64, area: f64) -> Row {
        Row {
            periods: 4,
            breadth: 16,
            pixels: 8,
            hurst: 0.8,
            seed,
            bandwidth: 10.0 + seed as f64,
            closing: 2.0,
            load,
            area,
            grid: 0.01 * area,
            gap: 1.0,
        }
    }

    #[test]
    fn rows_read_back() {
        let r = row(3, 0.0063, 0.012_345_6);
        let text = format!("# remark\n{HEADER}\n{}\n", r.line());
        assert_eq!(parse(&text), Some(vec![r]));
        assert_eq!(parse("load,area\n1,2\n"), None);
    }

    /// Two maps with A = 2x and A = 2.2x: mean 2.1, standard error 0.1, t = 12.706 of one degree
    /// of freedom.
    #[test]
    fn bars_are_students() {
        let rows: Vec<Row> =
            LIGHT.iter().flat_map(|x| [row(1, *x, 2.0 * x), row(2, *x, 2.2 * x)]).collect();
        let kinds = kinds(&rows);
        assert_eq!(kinds.len(), 1);
        let k = &kinds[0];
        assert!((k.kappa.value - 2.1).abs() < 1e-12 && (k.bandwidth - 11.5).abs() < 1e-12);
        assert!((k.kappa.sampling - 1.2706).abs() < 1e-9 && (k.kappa.grid - 0.021).abs() < 1e-9);
        assert_eq!(k.curve.len(), LIGHT.len());
        // Against a kind whose maps are each 0.1 higher, the scatter between maps is no error.
        let higher =
            Kind { each: k.each.iter().map(|(s, v)| (*s, v + 0.1)).collect(), ..k.clone() };
        let [mean, half] = difference(k, &higher).unwrap();
        assert!((mean - 0.1).abs() < 1e-12 && half < 1e-9);
    }

    /// Kinds on 2.4 - 0.07 ln α whose three maps tilt by -0.01, 0 and 0.01 of ln α: the standard
    /// error of the mean tilt is 0.01/√3, and t = 4.303 of two degrees of freedom. The grid errs by
    /// 0.03 - 0.002 ln α.
    #[test]
    fn a_logarithmic_law_is_found_with_its_bars() {
        let kind = |bandwidth: f64, off: f64| {
            let ln = bandwidth.ln();
            let value = 2.4 - 0.07 * ln + off;
            Kind {
                periods: 1,
                breadth: 1,
                pixels: 1,
                hurst: 0.5,
                maps: 3,
                bandwidth,
                curve: Vec::new(),
                each: vec![(1, value - 0.01 * ln), (2, value), (3, value + 0.01 * ln)],
                kappa: Slope { load: 0.01, value, sampling: 0.02, grid: 0.03 - 0.002 * ln },
            }
        };
        let law = log_law(&[kind(2.0, 0.0), kind(9.0, 0.0), kind(200.0, 0.0)]);
        assert!((law.fall - 0.07).abs() < 1e-12 && (law.at_one - 2.4).abs() < 1e-12);
        assert!((law.sampling - 4.303 * 0.01 / 3f64.sqrt()).abs() < 1e-12, "{}", law.sampling);
        assert!((law.grid - 0.002).abs() < 1e-12 && law.largest < 1e-12);
        assert!(log_law(&[kind(2.0, 0.0), kind(9.0, 0.01), kind(200.0, 0.0)]).largest > 0.005);
    }

    /// 2.228 for 10 degrees of freedom, 2.042 for 30.
    #[test]
    fn students_quantile_goes_on_beyond_its_table() {
        assert!((quantile(9) - 2.262).abs() < 1e-12);
        assert!((quantile(10) - 2.228).abs() < 5e-3 && (quantile(30) - 2.042).abs() < 2e-3);
    }
}
