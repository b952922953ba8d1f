//! Colours by role, line styles by series, and the two colour ramps of the maps.
//!
//! The light value is written into every mark, so a figure file stands alone; the class beside
//! it lets the report's stylesheet put the dark value in its place.

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Colour {
    /// Name of the CSS variable and end of the class name.
    pub(crate) class: &'static str,
    pub(crate) light: &'static str,
    pub(crate) dark: &'static str,
}

const fn colour(class: &'static str, light: &'static str, dark: &'static str) -> Colour {
    Colour { class, light, dark }
}

pub(crate) const PAPER: Colour = colour("paper", "#FFFFFF", "#15181B");
pub(crate) const INK: Colour = colour("ink", "#111418", "#F2F4F5");
/// Ticks and notes.
pub(crate) const INK2: Colour = colour("ink2", "#4A5259", "#B4BCC3");
pub(crate) const LINE: Colour = colour("line", "#868F97", "#5D676F");
pub(crate) const GRID: Colour = colour("grid", "#E3E6E9", "#2A3035");
pub(crate) const BAND: Colour = colour("band", "#EEF1F3", "#20262A");
pub(crate) const WARN: Colour = colour("warn", "#9A4B00", "#FFB066");
pub(crate) const DETERMINISTIC: Colour = colour("det", "#111418", "#FFFFFF");
/// Greenwood–Williamson. Colours of two models are at least 8 OKLab units (ΔE in hundredths) apart, also for readers without
/// red, green or blue cones, and have a contrast of 4.5:1 on the page.
pub(crate) const GW: Colour = colour("gw", "#8C001A", "#F86237");
pub(crate) const BGT: Colour = colour("bgt", "#3C26AE", "#909FFA");
/// Greenwood's simplified elliptical model.
pub(crate) const ELLIPTICAL: Colour = colour("sge", "#13836F", "#30E4F5");
pub(crate) const PERSSON: Colour = colour("per", "#B542B5", "#EC83B7");
pub(crate) const STACKED: Colour = colour("stk", "#835C00", "#F9C379");
pub(crate) const MAJUMDAR_BHUSHAN: Colour = colour("mb", "#5A2D69", "#B46987");
/// Jackson–Streator multiscale.
pub(crate) const MULTISCALE: Colour = colour("js", "#780FFF", "#6978F0");
pub(crate) const EQUATION: Colour = colour("eq", "#00665C", "#B4F0C8");

/// Every colour, in the order of the stylesheet: what is no series, and the solution with the models.
pub(crate) const ROLES: [Colour; 7] = [PAPER, INK, INK2, LINE, GRID, BAND, WARN];
pub(crate) const SERIES: [Colour; 9] =
    [DETERMINISTIC, GW, BGT, ELLIPTICAL, PERSSON, STACKED, MAJUMDAR_BHUSHAN, MULTISCALE, EQUATION];

/// Shape that marks a series where colour is not seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Marker {
    Dot,
    Ring,
    Square,
    TriangleUp,
    TriangleDown,
    Diamond,
    Cross,
    Plus,
    Hexagon,
}

#[derive(Debug, Clone, Copy)]
pub(crate) struct Stroke {
    pub(crate) colour: Colour,
    pub(crate) width: f64,
    pub(crate) dash: &'static str,
}

impl Stroke {
    pub(crate) const fn solid(colour: Colour, width: f64) -> Self {
        Self { colour, width, dash: "" }
    }
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Style {
    pub(crate) colour: Colour,
    /// Line width in figure units.
    pub(crate) width: f64,
    /// SVG dash pattern; empty for a solid line.
    pub(crate) dash: &'static str,
    pub(crate) marker: Marker,
    /// The marker sits on loads `i` with `i % 4 == marker_offset`.
    pub(crate) marker_offset: usize,
}

impl Style {
    pub(crate) const fn model(
        colour: Colour,
        dash: &'static str,
        marker: Marker,
        marker_offset: usize,
    ) -> Self {
        Self { colour, width: 1.35, dash, marker, marker_offset }
    }

    pub(crate) fn stroke(self) -> Stroke {
        Stroke { colour: self.colour, width: self.width, dash: self.dash }
    }
}

/// The deterministic solution: the heaviest line, a dot at every computed load.
pub(crate) const DETERMINISTIC_STYLE: Style =
    Style { colour: DETERMINISTIC, width: 2.0, dash: "", marker: Marker::Dot, marker_offset: 0 };

/// The solution of elastic bodies beside that of bodies that yield: thin.
pub(crate) const ELASTIC_LOOK: Style =
    Style { colour: INK2, width: 0.8, dash: "", marker: Marker::Ring, marker_offset: 2 };

/// Height: dark low, light high, lightness linear in the value.
pub(crate) const HEIGHT_RAMP: [u32; 9] =
    [0x1F2D4C, 0x234560, 0x2A5F71, 0x3B797D, 0x569286, 0x79A98D, 0xA1C096, 0xCBD4A1, 0xF6E8B3];

/// Pressure: light low, dark high, lightness linear in the value.
pub(crate) const PRESSURE_RAMP: [u32; 9] =
    [0xFCBE62, 0xF7983D, 0xEB7230, 0xD74F38, 0xBB3045, 0x9A164D, 0x75064E, 0x500247, 0x2D0236];

/// Flux: light low, dark high, lightness linear in the value.
pub(crate) const FLOW_RAMP: [u32; 9] =
    [0xF4F8FB, 0xD6E6F2, 0xB8D3E8, 0x98C0DD, 0x76ABD1, 0x5595C2, 0x377DB0, 0x1E6399, 0x08467C];

/// A colour as OKLab lightness and the two opponent axes (Ottosson 2020).
#[derive(Debug, Clone, Copy)]
pub(crate) struct OkLab(pub f64, pub f64, pub f64);

fn linear(channel: u32) -> f64 {
    let c = f64::from(channel & 0xFF) / 255.0;
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}

impl OkLab {
    pub(crate) fn from_rgb(rgb: u32) -> Self {
        Self::from_linear(linear(rgb >> 16), linear(rgb >> 8), linear(rgb))
    }

    fn from_linear(r: f64, g: f64, b: f64) -> Self {
        let l = (0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b).cbrt();
        let m = (0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b).cbrt();
        let s = (0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b).cbrt();
        Self(
            0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s,
        )
    }

    /// To 8-bit sRGB; colours outside it are clipped.
    pub(crate) fn to_rgb(self) -> [u8; 3] {
        let Self(lightness, a, b) = self;
        let l = (lightness + 0.3963377774 * a + 0.2158037573 * b).powi(3);
        let m = (lightness - 0.1055613458 * a - 0.0638541728 * b).powi(3);
        let s = (lightness - 0.0894841775 * a - 1.2914855480 * b).powi(3);
        [
            4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s,
        ]
        .map(|c: f64| {
            let c = c.clamp(0.0, 1.0);
            let encoded =
                if c <= 0.0031308 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 };
            (255.0 * encoded).round() as u8
        })
    }

    /// The same in six hexadecimal digits.
    pub(crate) fn hex(self) -> String {
        self.to_rgb().iter().map(|v| format!("{v:02X}")).collect()
    }
}

/// A ramp resampled to `N` colours in OKLab, for fast look-up.
pub(crate) fn ramp_table<const N: usize>(stops: &[u32; 9]) -> [OkLab; N] {
    let labs = stops.map(OkLab::from_rgb);
    std::array::from_fn(|i| {
        let x = i as f64 / (N - 1) as f64 * 8.0;
        let k = (x as usize).min(7);
        let t = x - k as f64;
        let mix = |of: fn(&OkLab) -> f64| of(&labs[k]) + t * (of(&labs[k + 1]) - of(&labs[k]));
        OkLab(mix(|c| c.0), mix(|c| c.1), mix(|c| c.2))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn oklab_round_trip_and_known_values() {
        for rgb in HEIGHT_RAMP.into_iter().chain(PRESSURE_RAMP).chain([0, 0xFFFFFF, 0xFF0000]) {
            let [r, g, b] = OkLab::from_rgb(rgb).to_rgb().map(u32::from);
            assert_eq!(r << 16 | g << 8 | b, rgb, "{rgb:06X}");
        }
        // Ottosson's published value for sRGB red.
        let OkLab(l, a, b) = OkLab::from_rgb(0xFF0000);
        assert!((l - 0.62796).abs() < 1e-4 && (a - 0.22486).abs() < 1e-4);
        assert!((b - 0.12585).abs() < 1e-4);
    }

    /// What people with all cones and without the red, green or blue ones see of linear RGB (Machado, Oliveira,
    /// Fernandes 2009, severity 1).
    const SIGHTS: [[[f64; 3]; 3]; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ],
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
    ];

    fn rgb(hex: &str) -> u32 {
        u32::from_str_radix(&hex[1..], 16).expect("a colour")
    }

    /// OKLab distance, in hundredths, for whoever tells the two apart worst.
    fn apart(one: &str, other: &str) -> f64 {
        let seen = |sight: &[[f64; 3]; 3], hex: &str| {
            let c = [16, 8, 0].map(|shift| linear(rgb(hex) >> shift));
            let [r, g, b] = sight.map(|row| {
                let light: f64 = row.iter().zip(c).map(|(a, x)| a * x).sum();
                light.clamp(0.0, 1.0)
            });
            OkLab::from_linear(r, g, b)
        };
        let distance = |sight| {
            let (a, b) = (seen(sight, one), seen(sight, other));
            100.0 * ((a.0 - b.0).powi(2) + (a.1 - b.1).powi(2) + (a.2 - b.2).powi(2)).sqrt()
        };
        SIGHTS.iter().map(distance).fold(f64::INFINITY, f64::min)
    }

    fn contrast(one: &str, other: &str) -> f64 {
        let luminance = |hex: &str| {
            let [r, g, b] = [16, 8, 0].map(|shift| linear(rgb(hex) >> shift));
            0.05 + 0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        let (a, b) = (luminance(one), luminance(other));
        a.max(b) / a.min(b)
    }

    /// Persson and the equation, which are often the two nearest to the solution, are farther apart than others.
    #[test]
    fn models_are_told_apart_without_red_green_or_blue_cones() {
        for of in [|c: Colour| c.light, |c: Colour| c.dark] {
            for (i, one) in SERIES.iter().enumerate() {
                assert!(contrast(of(*one), of(PAPER)) >= 4.5, "{}", one.class);
                for other in &SERIES[..i] {
                    let found = apart(of(*one), of(*other));
                    assert!(found >= 8.0, "{} and {}: {found:.1}", one.class, other.class);
                }
            }
            assert!(apart(of(PERSSON), of(EQUATION)) >= 14.0);
        }
        assert!(apart("#B542B5", "#005A9C") < 5.0, "two that look alike");
    }

    #[test]
    fn ramps_print_in_grey() {
        for (ramp, sign) in [(HEIGHT_RAMP, 1.0), (PRESSURE_RAMP, -1.0)] {
            let l: Vec<f64> = ramp.iter().map(|&c| sign * OkLab::from_rgb(c).0).collect();
            let step = (l[8] - l[0]) / 8.0;
            assert!(l.windows(2).all(|w| (w[1] - w[0] - step).abs() < 0.2 * step), "{l:?}");
        }
    }
}
