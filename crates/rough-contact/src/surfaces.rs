//! What a study is given: files, read and named, or the surfaces of a run file.

use crate::input::{One, from_file};
use crate::outcome::{Failure, unfit};
use rough_contact::compare::{
    FileOrigin, Level, Origin, PairOrigin, ProfileSurface, RunFile, RunSurface, Settings,
    StudyError, Surface,
};
use rough_contact::front_end::{self, told_apart};
use rough_contact::surface_io::Cut;
use std::path::Path;

/// Maps or profiles; the two make different reports.
pub(crate) fn parted(all: Vec<One>) -> Result<(Vec<Surface>, Vec<ProfileSurface>), Failure> {
    let (mut maps, mut profiles) = (Vec::new(), Vec::new());
    for one in all {
        match one {
            One::Map(map) => maps.push(*map),
            One::Profile(profile) => profiles.push(*profile),
        }
    }
    if let (Some(map), Some(profile)) = (maps.first(), profiles.first()) {
        let message = format!(
            "{} is a map and {} a profile: a map is solved, a profile is not; compare them in \
             two runs",
            map.name, profile.name
        );
        return Err(Failure::refused("profile", message));
    }
    Ok((maps, profiles))
}

/// Settings and surfaces of a run file. A file whose content has changed is refused.
pub(crate) fn repeat(path: &Path) -> Result<(Settings, Vec<One>), Failure> {
    let text = std::fs::read_to_string(path).map_err(|e| unfit(path, "io", e))?;
    let run = RunFile::parse(&text).map_err(|e| Failure::in_file(path, &e))?;
    let mut surfaces = Vec::new();
    for RunSurface { name, origin } in run.surfaces {
        let mut surface = made_again(path, &name, origin, run.settings.level)?;
        *surface.named().0 = name;
        surfaces.push(surface);
    }
    Ok((run.settings, surfaces))
}

fn made_again(path: &Path, name: &str, origin: Origin, level: Level) -> Result<One, Failure> {
    Ok(match origin {
        Origin::Recipe(recipe) => One::Map(Box::new(recipe.make().map_err(|e| Failure::from(&e))?)),
        Origin::Given(_) => return Err(Failure::from(&StudyError::Given(name.to_owned()))),
        Origin::File(file) => again(path, &file)?,
        Origin::Pair(PairOrigin { names, placing, bodies, .. }) => {
            let body = |name: String, origin| match made_again(path, &name, origin, level)? {
                One::Map(map) => Ok(Surface { name, ..*map }),
                One::Profile(_) => Err(unfit(path, "profile", format!("{name} is a profile"))),
            };
            let ([first, second], [one, other]) = (names, *bodies);
            let (first, second) = (body(first, one)?, body(second, other)?);
            One::Map(Box::new(front_end::pressed(first, second, &placing, level)?))
        }
    })
}

fn again(run_file: &Path, file: &FileOrigin) -> Result<One, Failure> {
    front_end::reading(file).map_err(|e| unfit(run_file, "syntax", e))?;
    // From the folder of the run file; as it is written, where nothing lies there.
    let beside = run_file.parent().unwrap_or(Path::new("")).join(&file.path);
    let path = if beside.exists() { beside.as_path() } else { Path::new(&file.path) };
    let asked = FileOrigin { path: path.display().to_string(), ..file.clone() };
    let mut surface = from_file(path, asked, file.crop.map(Cut::Rectangle), true)?;
    match surface.named().1 {
        Origin::File(now) if now.sha256 != file.sha256 => {
            let message = format!(
                "{} has changed since {} was written (SHA-256 {} instead of {}); compare it anew \
                 without --from",
                path.display(),
                run_file.display(),
                now.sha256,
                file.sha256
            );
            Err(Failure::refused("changed_file", message))
        }
        _ => Ok(surface),
    }
}

/// Names that tell the surfaces apart: of files with the same name, as much of the path as it takes; the same file
/// twice is numbered.
pub(crate) fn distinct(surfaces: &mut [One]) {
    let mut surfaces: Vec<_> = surfaces.iter_mut().map(One::named).collect();
    let names: Vec<String> = surfaces.iter().map(|(name, _)| (*name).clone()).collect();
    let path_of = |(_, origin): &(&mut String, &Origin)| match origin {
        Origin::File(file) => Some(file.path.clone()),
        _ => None,
    };
    let paths: Vec<Option<String>> = surfaces.iter().map(path_of).collect();
    let mut given: Vec<String> = Vec::with_capacity(names.len());
    for (i, (name, _)) in surfaces.iter_mut().enumerate() {
        let alike = |k: &usize| names[*k] == names[i] && paths[*k].is_some();
        let group: Vec<usize> = (0..names.len()).filter(alike).collect();
        if let Some(at) = group.iter().position(|k| *k == i) {
            let paths: Vec<&str> = group.iter().filter_map(|k| paths[*k].as_deref()).collect();
            name.clone_from(&told_apart(&paths)[at]);
        }
        let before = given.iter().filter(|n| *n == *name).count();
        given.push(name.clone());
        if before > 0 {
            **name = format!("{name} ({})", before + 1);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_the_same_name_are_told_apart() {
        let grid = contact_types::Grid::new([2, 2], [1e-6; 2]).expect("a grid");
        let heights = contact_types::HeightMap::new(grid, vec![0.0; 4]).expect("a map");
        let surface = |(path, name): (&str, &str)| {
            let origin =
                Origin::File(FileOrigin { path: path.to_owned(), ..FileOrigin::default() });
            let (name, heights) = (name.to_owned(), heights.clone());
            One::Map(Box::new(Surface { name, origin, heights }))
        };
        let mut list =
            [("a/s.stp", "s.stp"), ("b/s.stp", "s.stp"), ("t.stp", "t.stp"), ("a/s.stp", "s.stp")]
                .map(surface);
        distinct(&mut list);
        let names = list.each_mut().map(|one| one.named().0.clone());
        assert_eq!(names, ["a/s.stp", "b/s.stp", "t.stp", "a/s.stp (2)"]);
    }
}
