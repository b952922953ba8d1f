//! How often do the uncertainties hold? Surfaces given by formulas on 128² points against 1024² of the same formula.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program of its own")]
mod families;
use contact_accuracy::{
    Boundary, Coarser, ContactModulus, HeightMap, Load, Numbers, Solver, indicator, regrid, thinned,
};
use families::{FAMILIES, family, map};
use fft_bem_solver::Maps;

fn numbers(solver: &mut Solver, load: Load) -> (Numbers, fft_bem_solver::Solution) {
    let s = solver.solve_again(load).unwrap();
    let set = solver.contact_stiffness().unwrap();
    (Numbers::of(&s, Some(&set)), s)
}
fn solver(map: HeightMap, tol: f64, maps: Maps) -> Solver {
    let m = ContactModulus::from_pascals(1.0).unwrap();
    let mut s = Solver::builder()
        .tolerance(tol)
        .maps(maps)
        .threads(1)
        .boundary(Boundary::Periodic)
        .build(map.grid(), m)
        .unwrap();
    s.take_surface(map).unwrap();
    s
}
/// pressure at which the corrected area on the map is `a`
fn pressure_for(s: &mut Solver, a: f64, guess: f64) -> f64 {
    let f = |s: &mut Solver, p: f64| {
        s.solve_again(Load::MeanPressure(p)).unwrap().diagnostics.area_fraction_corrected
    };
    let (mut lo, mut hi) = (guess, guess);
    while f(s, lo) > a {
        lo *= 0.3;
        if lo < 1e-9 * guess {
            return lo;
        }
    }
    while f(s, hi) < a {
        hi *= 2.0;
        if hi > 1e3 * guess {
            return hi;
        }
    }
    for _ in 0..7 {
        let m = (lo * hi).sqrt();
        if f(s, m) < a { lo = m } else { hi = m }
    }
    (lo * hi).sqrt()
}
fn main() {
    let arg = |k: usize, e: usize| std::env::args().nth(k).map_or(e, |s| s.parse().unwrap());
    let (seeds, first) = (arg(1, 1), arg(2, 0));
    let m = ContactModulus::from_pascals(1.0).unwrap();
    println!(
        "family,half,seed,target,p,A,raw,S,Ax,G,K,hrms,n,ind,A1,G1,K1,A2,G2,K2,A3,G3,K3,Af,Sf,Gf,Kf,At,St,Gt,Kt,Ah,Sh,Gh,repeats"
    );
    for (name, half) in FAMILIES {
        for seed in first..first + seeds {
            let h = family(name, seed as u64).unwrap();
            let given = map(128, &h);
            let fine = map(512, &h);
            let repeats = !name.starts_with("crop");
            let mut s = solver(given.clone(), 1e-4, Maps::Pressure);
            let mut co =
                Coarser::of(&given, &Solver::builder().threads(1).maps(Maps::None), m).unwrap();
            let mut finer = solver(regrid(&given, [256, 256], repeats).unwrap(), 1e-4, Maps::None);
            let mut exact = solver(fine.clone(), 1e-5, Maps::None);
            let mut half_exact = solver(thinned(&fine, [0, 0]).unwrap(), 1e-5, Maps::None);
            let rms = {
                let mean = given.mean();
                (given.heights().iter().map(|z| (z - mean).powi(2)).sum::<f64>()
                    / given.heights().len() as f64)
                    .sqrt()
            };
            let mut probe = solver(thinned(&given, [0, 0]).unwrap(), 1e-3, Maps::None);
            let mut ps = vec![];
            for a in [0.005, 0.03, 0.15, 0.5, 0.95] {
                ps.push((a, pressure_for(&mut probe, a, rms * 10.0)));
            }
            for (a, p) in ps {
                let load = Load::MeanPressure(p);
                let (n, sol) = numbers(&mut s, load);
                let c = co.solve(load, true, |_| ()).unwrap();
                let ind = indicator(&given, repeats, &sol.pressure, m).unwrap_or(f64::NAN);
                // edges across x alone
                let nn = 128;
                let on = |y: usize, x: usize| sol.pressure[y * nn + x] > 0.0;
                let ex = (0..nn * nn)
                    .filter(|i| {
                        let (y, x) = (i / nn, i % nn);
                        on(y, x) != on(y, (x + 1) % nn)
                    })
                    .count() as f64
                    / (nn * nn) as f64;
                let (f, fs) = numbers(&mut finer, load);
                let (t, ts) = numbers(&mut exact, load);
                let hs = half_exact.solve_again(load).unwrap();
                let o = |x: Option<f64>| x.map_or("".into(), |x| format!("{x:e}"));
                println!(
                    "{name},{half:?},{seed},{a},{p:e},{:e},{:e},{:e},{ex:e},{},{},{rms:e},{},{ind:e},{:e},{},{},{:e},{},{},,,,{:e},{:e},{},{},{:e},{:e},{},{},{:e},{:e},{},{repeats}",
                    n.area,
                    sol.state.area_fraction,
                    sol.diagnostics.contact_perimeter,
                    o(n.mean_gap),
                    o(n.stiffness),
                    given.grid().len(),
                    c[0].area,
                    o(c[0].mean_gap),
                    o(c[0].stiffness),
                    c[1].area,
                    o(c[1].mean_gap),
                    o(c[1].stiffness),
                    f.area,
                    fs.diagnostics.contact_perimeter,
                    o(f.mean_gap),
                    o(f.stiffness),
                    t.area,
                    ts.diagnostics.contact_perimeter,
                    o(t.mean_gap),
                    o(t.stiffness),
                    hs.diagnostics.area_fraction_corrected,
                    hs.diagnostics.contact_perimeter,
                    o(hs.state.mean_gap)
                );
            }
        }
    }
}
