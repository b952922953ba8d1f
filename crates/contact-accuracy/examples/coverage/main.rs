//! How often do the uncertainties hold? Surfaces given by formulas, on 128² points, against 512² points of the same
//! formula, at five loads each; and how often the sampling variability holds the mean of twenty maps of a family.
//!
//! ```console
//! $ cargo run --release -p contact-accuracy --example coverage                  # all of it: minutes
//! $ cargo run --release -p contact-accuracy --example coverage -- waves, long   # one family: a second
//! ```

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program of its own")]

mod cases;
mod families;
mod rows;

use cases::{Case, Coverage, sampling, solved};
use families::{FAMILIES, Half, family};
use std::sync::Mutex;

/// Realisations of each family.
const SEEDS: u64 = 4;

fn main() {
    let name = std::env::args().skip(1).collect::<Vec<_>>().join(" ");
    let realised = |name: &str, case: Case| {
        let mut sum = Coverage::default();
        (0..SEEDS).for_each(|seed| sum.add(&solved(&family(name, seed).unwrap(), case)));
        sum
    };
    if !name.is_empty() {
        println!("{}", rows::row(&name, &realised(&name, Case::Pressure)));
        return;
    }
    // Families are independent: as many at a time as there are cores.
    let jobs: Vec<(usize, Case)> = (0..FAMILIES.len())
        .flat_map(|i| Case::all(FAMILIES[i].0).into_iter().map(move |case| (i, case)))
        .collect();
    let next = Mutex::new(jobs.iter());
    let found = Mutex::new(Vec::new());
    let work = || {
        while let Some(&(i, case)) = { next.lock().unwrap().next() } {
            let sum = realised(FAMILIES[i].0, case);
            found.lock().unwrap().push((i, case, sum));
        }
    };
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| (0..cores).for_each(|_| drop(scope.spawn(work))));
    let mut found = found.into_inner().unwrap();
    found.sort_by_key(|(i, case, _)| (*case as usize, *i));
    let of = |half: Half, case: Case| {
        let mut sum = Coverage::default();
        let is_it = |i: usize| FAMILIES[i].1 == half;
        found.iter().filter(|f| f.1 == case && is_it(f.0)).for_each(|f| sum.add(&f.2));
        sum
    };
    let of_case = |case: Case| {
        let mut sum = of(Half::Training, case);
        sum.add(&of(Half::Validation, case));
        sum
    };
    println!("{}", rows::HEADER);
    for half in [Half::Training, Half::Validation] {
        let count = FAMILIES.iter().filter(|f| f.1 == half).count();
        let name = format!("{count} families, {half:?}");
        println!("{}", rows::row(&name.to_lowercase(), &of(half, Case::Pressure)));
    }
    for (case, shown) in [
        (Case::Gap, "at a given gap, all"),
        (Case::Yielding, "yielding, 8 families"),
        (Case::Oblong, "pixels 1 × 2.7, 8 families"),
        (Case::Odd, "127² points, 8 families"),
        (Case::Rounded, "heights rounded to Sq/20, 8 families"),
        (Case::Fast, "every second point (`--fast`), all"),
    ] {
        println!("{}", rows::row(shown, &of_case(case)));
    }
    println!("\n{}", rows::ladder(&of_case(Case::Fast), &of_case(Case::Pressure)));
    println!("\n{}", rows::gaps(&of_case(Case::Gaps)));
    println!("\nFamilies in which an answer was missed:\n\n{}", rows::HEADER);
    for (i, case, sum) in &found {
        if *case == Case::Pressure && sum.held.iter().any(|held| held.share() < 1.0) {
            println!("{}", rows::row(FAMILIES[*i].0, sum));
        }
    }
    println!("\n{}", sampling());
}
