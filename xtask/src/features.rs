//! Every library crate builds without its default features and with each feature alone.

use crate::shell::{self, TaskResult, cargo, packages};

/// Checks each crate of the workspace that has features, one combination after the other.
pub(crate) fn run() -> TaskResult {
    let mut checked = 0;
    for package in packages(&["--no-deps"])? {
        let features: Vec<&String> =
            package["features"].as_object().into_iter().flat_map(|all| all.keys()).collect();
        let mut targets = package["targets"].as_array().into_iter().flatten();
        let is_library = targets.any(|target| target["kind"][0] == "lib");
        let Some(name) = package["name"].as_str().filter(|_| is_library && !features.is_empty())
        else {
            continue;
        };
        let alone =
            features.iter().filter(|feature| **feature != "default").map(|f| Some(f.as_str()));
        for feature in std::iter::once(None).chain(alone) {
            let mut check = cargo();
            check.args(["check", "--quiet", "--locked", "--lib", "--no-default-features"]);
            check
                .args(["-p", name])
                .args(feature.iter().flat_map(|feature| ["--features", feature]));
            shell::run(&mut check)?;
            checked += 1;
        }
    }
    println!("features: {checked} combinations build");
    Ok(())
}
