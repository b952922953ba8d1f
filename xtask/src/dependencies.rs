//! Which crate of ours may depend on which, and what each brings along.

use crate::shell::{cargo, output};
use std::collections::BTreeSet;

/// The layer picture: which crate of ours may depend on which, and how many crates from the
/// registry it may pull in with its default features.
pub(crate) const LAYERS: &[(&str, u8, &[&str], usize)] = &[
    ("contact-types", 0, &[], 10),
    ("grid-fft", 0, &["contact-types"], 20),
    ("surface-io", 1, &["contact-types"], 40),
    ("surface-stats", 1, &["contact-types", "grid-fft"], 20),
    ("gw-closed-form", 1, &["contact-types"], 10),
    // Bush-Gibson-Thomas is the Greenwood-Williamson integral averaged over curvatures.
    ("asperity-models", 1, &["contact-types", "gw-closed-form"], 10),
    ("multiscale-models", 1, &["contact-types"], 10),
    ("fft-bem-solver", 1, &["contact-types", "grid-fft"], 30),
    ("gap-flow", 1, &["contact-types"], 50),
    (
        "contact-accuracy",
        2,
        &["contact-types", "grid-fft", "surface-stats", "fft-bem-solver", "gap-flow"],
        30,
    ),
    (
        "contact-compare",
        3,
        &[
            "contact-accuracy",
            "contact-types",
            "grid-fft",
            "surface-stats",
            "gw-closed-form",
            "asperity-models",
            "multiscale-models",
            "fft-bem-solver",
        ],
        50,
    ),
    // Types of results only: nothing is computed there.
    (
        "contact-report",
        4,
        &["contact-accuracy", "contact-types", "grid-fft", "surface-stats", "contact-compare"],
        65,
    ),
    // What a front end answers, without its words for options, its tables and its files.
    (
        "contact-front-end",
        5,
        &[
            "contact-accuracy",
            "contact-types",
            "grid-fft",
            "surface-io",
            "surface-stats",
            "multiscale-models",
            "fft-bem-solver",
            "contact-compare",
            "contact-report",
        ],
        75,
    ),
    // The page in a browser: the engine and what it shows.
    (
        "contact-web",
        6,
        &[
            "contact-front-end",
            "contact-types",
            "surface-io",
            "surface-stats",
            "contact-compare",
            "contact-report",
        ],
        75,
    ),
    // The research programs: their tests and examples reach for every crate.
    (
        "studies",
        6,
        &[
            "contact-types",
            "surface-stats",
            "contact-accuracy",
            "contact-compare",
            "contact-report",
        ],
        65,
    ),
    // The command, which serves the page of `contact-web`.
    (
        "rough-contact",
        7,
        &[
            "contact-front-end",
            "contact-accuracy",
            "contact-types",
            "surface-io",
            "surface-stats",
            "multiscale-models",
            "fft-bem-solver",
            "contact-compare",
            "contact-report",
            "contact-web",
        ],
        130,
    ),
    ("xtask", 8, &[], 10),
];

/// The crates that come with one of ours, with default features, without tests.
pub(crate) struct BroughtAlong {
    pub(crate) own: BTreeSet<String>,
    pub(crate) from_registry: BTreeSet<String>,
}

/// What `package` brings along on Linux; the list differs a little between platforms.
pub(crate) fn brought_along(package: &str) -> Result<BroughtAlong, String> {
    let mut tree = cargo();
    tree.args(["tree", "--locked", "--package", package, "--edges", "normal", "--prefix", "none"]);
    tree.args(["--format", "{p}", "--target", "x86_64-unknown-linux-gnu"]);
    let lines = output(&mut tree)?;
    let names = lines.lines().filter_map(|line| line.split_whitespace().next());
    let is_own = |name: &str| LAYERS.iter().any(|row| row.0 == name);
    let (own, from_registry) = names
        .map(str::to_owned)
        .filter(|name| name != package)
        .partition(|name| is_own(name.as_str()));
    Ok(BroughtAlong { own, from_registry })
}
