//! Which crate of ours may depend on which, and what each brings along.

use crate::shell::{cargo, output};
use std::collections::BTreeSet;

/// The layer picture: each crate of ours, its layer, how many crates from the registry it may pull in with its
/// default features, and which of ours it may depend on.
pub(crate) const LAYERS: &[(&str, u8, usize, &str)] = &[
    ("contact-types", 0, 10, ""),
    ("grid-fft", 0, 20, "contact-types"),
    ("surface-io", 1, 40, "contact-types"),
    ("surface-stats", 1, 20, "contact-types grid-fft"),
    ("gw-closed-form", 1, 10, "contact-types"),
    // Bush-Gibson-Thomas is the Greenwood-Williamson integral averaged over curvatures.
    ("asperity-models", 1, 10, "contact-types gw-closed-form"),
    ("multiscale-models", 1, 10, "contact-types"),
    ("fft-bem-solver", 1, 30, "contact-types grid-fft"),
    ("gap-flow", 1, 50, "contact-types"),
    ("contact-accuracy", 2, 30, "contact-types grid-fft surface-stats fft-bem-solver gap-flow"),
    (
        "contact-compare",
        3,
        50,
        "contact-accuracy contact-types grid-fft surface-stats gw-closed-form asperity-models \
         multiscale-models fft-bem-solver",
    ),
    // Types of results only: nothing is computed there.
    (
        "contact-report",
        4,
        65,
        "contact-accuracy contact-types grid-fft surface-stats contact-compare",
    ),
    // What a front end answers, without its words for options, its tables and its files.
    (
        "contact-front-end",
        5,
        75,
        "contact-accuracy contact-types grid-fft surface-io surface-stats multiscale-models \
         fft-bem-solver contact-compare contact-report",
    ),
    // The page in a browser: the engine and what it shows.
    (
        "contact-web",
        6,
        75,
        "contact-front-end contact-types surface-io surface-stats contact-compare contact-report",
    ),
    // The research programs: their tests and examples reach for every crate.
    (
        "studies",
        6,
        65,
        "contact-types surface-stats contact-accuracy contact-compare contact-report",
    ),
    // The command, which serves the page of `contact-web`.
    (
        "rough-contact",
        7,
        130,
        "contact-front-end contact-accuracy contact-types surface-io surface-stats multiscale-models \
         fft-bem-solver contact-compare contact-report contact-web",
    ),
    ("xtask", 8, 10, ""),
];

/// A line for each crate that `cargo tree` finds below a package and itself: name, version, where it lies if it is ours.
pub(crate) fn tree(package: &str, edges: &str, target: &str) -> Result<String, String> {
    let mut tree = cargo();
    tree.args(["tree", "--locked", "--package", package, "--edges", edges, "--prefix", "none"]);
    output(tree.args(["--format", "{p}", "--target", target]))
}

/// What `package` brings along with default features, without tests: crates of ours, and of the registry. On Linux; the
/// list differs a little between platforms.
pub(crate) fn brought_along(package: &str) -> Result<[BTreeSet<String>; 2], String> {
    let lines = tree(package, "normal", "x86_64-unknown-linux-gnu")?;
    let names = lines.lines().filter_map(|line| line.split_whitespace().next());
    let is_own = |name: &str| LAYERS.iter().any(|row| row.0 == name);
    let names = names.filter(|name| *name != package).map(str::to_owned);
    Ok(names.partition::<BTreeSet<_>, _>(|name| is_own(name)).into())
}
