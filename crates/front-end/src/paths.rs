//! Where files lie, as a run file and a report say it; and surfaces named by it.

use crate::failure::Failure;
use contact_compare::{FileOrigin, Level, Origin, Placing, RunFile, Surface};
use std::path::{Component, Path};

/// A run file as it stands in a folder: its files are named from there, so that it can be repeated from anywhere and
/// says nothing of the folders above.
#[must_use]
pub fn run_file_in(mut run: RunFile, folder: &Path) -> RunFile {
    fn set(origin: &mut Origin, folder: &Path) {
        match origin {
            Origin::File(FileOrigin { path, .. }) => *path = from(folder, Path::new(path)),
            Origin::Pair(pair) => pair.bodies.iter_mut().for_each(|body| set(body, folder)),
            _ => {}
        }
    }
    run.surfaces.iter_mut().for_each(|surface| set(&mut surface.origin, folder));
    run
}

/// The way to a file from a folder; the file as it is where there is none, as between two drives.
fn from(folder: &Path, file: &Path) -> String {
    let way = || {
        let (from, to) = (whole(folder)?, whole(file)?);
        let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
        if shared == 0 {
            return None;
        }
        let up = from[shared..].iter().map(|_| "..".to_owned());
        let down = to[shared..].iter().map(|part| part.to_string_lossy().into_owned());
        Some(up.chain(down).collect::<Vec<_>>().join("/"))
    };
    way().unwrap_or_else(|| file.display().to_string())
}

/// The parts of a path from the root, without `.` and `..`.
fn whole(path: &Path) -> Option<Vec<std::ffi::OsString>> {
    let mut parts = Vec::new();
    for part in std::path::absolute(path).ok()?.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => drop(parts.pop()),
            other => parts.push(other.as_os_str().to_owned()),
        }
    }
    Some(parts)
}

/// The first surface with the second on it, as one. Files of one name are told apart by where they lie.
///
/// # Errors
/// [`Failure`] of surfaces that make no pair.
pub fn pressed(
    mut first: Surface,
    mut second: Surface,
    placing: &Placing,
    level: Level,
) -> Result<Surface, Failure> {
    if first.name == second.name
        && let (Origin::File(a), Origin::File(b)) = (&first.origin, &second.origin)
    {
        let mut names = told_apart(&[&a.path, &b.path]);
        (first.name, second.name) = (names.swap_remove(0), names.swap_remove(0));
    }
    if first.name == second.name {
        second.name += " (2)";
    }
    let pressed = first.against(&second, placing, level);
    pressed.map_err(|e| Failure::refused("no_pair", e.to_string()))
}

/// Names that tell files apart: of each path the last parts, as few as it takes.
pub fn told_apart(paths: &[&str]) -> Vec<String> {
    let last = |path: &str, count: usize| {
        let parts: Vec<&str> = path.split(['/', '\\']).collect();
        parts[parts.len().saturating_sub(count)..].join("/")
    };
    let most = paths.iter().map(|path| path.split(['/', '\\']).count()).max().unwrap_or(0);
    let alone = |count: &usize| {
        paths.iter().all(|a| paths.iter().all(|b| a == b || last(a, *count) != last(b, *count)))
    };
    let count = (1..most).find(alone).unwrap_or(most);
    paths.iter().map(|path| last(path, count)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_named_from_the_folder_of_the_run() {
        let way = |folder: &str, file: &str| from(Path::new(folder), Path::new(file));
        assert_eq!(way("out", "a.x3p"), "../a.x3p");
        assert_eq!(way("out/b", "./out/a.x3p"), "../a.x3p");
        assert_eq!(way(".", "maps/a.x3p"), "maps/a.x3p");
        assert_eq!(way("/data/out", "/data/maps/../a.x3p"), "../a.x3p");
    }

    #[test]
    fn as_much_of_a_path_as_tells_it_apart() {
        let names = told_apart(&["/home/me/a/s.stp", "/home/me/b/s.stp", "/home/me/a/s.stp"]);
        assert_eq!(names, ["a/s.stp", "b/s.stp", "a/s.stp"]);
        assert_eq!(told_apart(&["s.stp", "b/s.stp"]), ["s.stp", "b/s.stp"]);
        assert_eq!(told_apart(&["a/x", "b/y"]), ["x", "y"]);
    }
}
