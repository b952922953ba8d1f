//! What a study is given: files, read and named, or the surfaces of a run file.

use crate::input::{Complete, MapOrTraces, ReadingOptions};
use crate::outcome::Failure;
use crate::profiles::Traces;
use rough_contact::compare;
use rough_contact::compare::{
    Cleaning, FileOrigin, Level, Origin, PairOrigin, Placing, ProfileSurface, RunFile, RunSurface,
    Settings, Surface, sha256_hex,
};
use rough_contact::contact_types::Named;
use rough_contact::front_end::told_apart;
use rough_contact::surface_io::Cut;
use std::path::Path;

/// What the files hold.
pub(crate) enum Given {
    Maps(Vec<Surface>),
    Profiles(Vec<ProfileSurface>),
}

/// What one file holds.
pub(crate) enum One {
    Map(Box<Surface>),
    Profile(Box<ProfileSurface>),
}

impl Given {
    /// Maps or profiles; the two make different reports.
    pub(crate) fn of(all: Vec<One>) -> Result<Self, Failure> {
        let (mut maps, mut profiles) = (Vec::new(), Vec::new());
        for one in all {
            match one {
                One::Map(map) => maps.push(*map),
                One::Profile(profile) => profiles.push(*profile),
            }
        }
        match (maps.first(), profiles.first()) {
            (Some(map), Some(profile)) => {
                let message = format!(
                    "{} is a map and {} a profile: a map is solved, a profile is not; compare them in \
                     two runs",
                    map.name, profile.name
                );
                Err(Failure::refused("profile", message))
            }
            (None, Some(_)) => Ok(Self::Profiles(profiles)),
            _ => Ok(Self::Maps(maps)),
        }
    }

    /// Gives the surfaces names that tell them apart.
    pub(crate) fn distinct(&mut self) {
        match self {
            Self::Maps(all) => distinct(all.iter_mut().map(|s| (&mut s.name, &s.origin)).collect()),
            Self::Profiles(all) => {
                distinct(all.iter_mut().map(|s| (&mut s.name, &s.origin)).collect());
            }
        }
    }
}

pub(crate) fn from_file(
    path: &Path,
    reading: &ReadingOptions,
    cleaning: Cleaning,
) -> Result<One, Failure> {
    let measured = reading.measured(path, cleaning)?;
    let bytes = std::fs::read(path).map_err(|e| Failure::refused("io", e.to_string()))?;
    let file = FileOrigin { sha256: sha256_hex(&bytes), ..reading.origin(path, cleaning) };
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    Ok(match measured {
        MapOrTraces::Map(complete) => {
            let Complete { map, missing, cleaned, height_step, format, crop } = complete;
            let origin = FileOrigin { format, crop, missing, cleaned, height_step, ..file };
            One::Map(Box::new(Surface { name, origin: Origin::File(origin), heights: map }))
        }
        MapOrTraces::Traces(traces) => {
            let origin = of_traces(file, &traces);
            let Traces { each, uneven, .. } = traces;
            One::Profile(Box::new(ProfileSurface { name, origin, traces: each, uneven }))
        }
    })
}

/// Where traces come from: their file, and what was done with it.
pub(crate) fn of_traces(file: FileOrigin, traces: &Traces) -> Origin {
    let Traces { missing, height_step, crop, .. } = *traces;
    let (cleaned, format) = (traces.cleaned.clone(), traces.format.clone());
    Origin::File(FileOrigin { format, crop, missing, cleaned, height_step, ..file })
}

/// Settings and surfaces of a run file. A file whose content has changed is refused.
pub(crate) fn repeat(path: &Path) -> Result<(Settings, Given), Failure> {
    let text = std::fs::read_to_string(path)
        .map_err(|e| Failure::refused("io", format!("{}: {e}", path.display())))?;
    let run = RunFile::parse(&text).map_err(|e| Failure::in_file(path, &e))?;
    let mut surfaces = Vec::new();
    for RunSurface { name, origin } in run.surfaces {
        let surface = made_again(path, &name, origin, run.settings.level)?;
        surfaces.push(match surface {
            One::Map(map) => One::Map(Box::new(Surface { name, ..*map })),
            One::Profile(profile) => One::Profile(Box::new(ProfileSurface { name, ..*profile })),
        });
    }
    Ok((run.settings, Given::of(surfaces)?))
}

/// Two surfaces as one.
pub(crate) fn pressed(
    first: &Surface,
    second: &Surface,
    placing: &Placing,
    level: Level,
) -> Result<Surface, Failure> {
    first.against(second, placing, level).map_err(|e| Failure::refused("no_pair", e.to_string()))
}

/// A surface from where it came.
fn made_again(path: &Path, name: &str, origin: Origin, level: Level) -> Result<One, Failure> {
    Ok(match origin {
        Origin::Recipe(recipe) => {
            One::Map(Box::new(recipe.make().map_err(|e| Failure::from_error(&e))?))
        }
        Origin::Given(_) => {
            let error = compare::RunFileError::Given(name.to_owned());
            return Err(Failure::from_error(&error));
        }
        Origin::File(file) => again(path, &file)?,
        Origin::Pair(PairOrigin { names, placing, bodies, .. }) => {
            let mut made = Vec::with_capacity(2);
            for (name, origin) in names.into_iter().zip(*bodies) {
                match made_again(path, &name, origin, level)? {
                    One::Map(map) => made.push(Surface { name, ..*map }),
                    One::Profile(_) => {
                        let message = format!("{}: {name} is a profile", path.display());
                        return Err(Failure::refused("profile", message));
                    }
                }
            }
            One::Map(Box::new(pressed(&made[0], &made[1], &placing, level)?))
        }
    })
}

/// The choice that a run file names.
fn choice<T: Named>(run_file: &Path, key: &str, name: &str) -> Result<T, Failure> {
    T::of_name(name).ok_or_else(|| {
        let names: Vec<&str> = T::all().map(T::name).collect();
        let (file, names) = (run_file.display(), names.join(", "));
        let message = format!("{file}: {key} = \"{name}\" is none of {names}");
        Failure::refused("syntax", message)
    })
}

fn again(run_file: &Path, file: &FileOrigin) -> Result<One, Failure> {
    let fill = choice(run_file, "fill", &file.fill)?;
    let layout = file.layout.as_deref().map(|name| choice(run_file, "layout", name));
    let decimal = file.decimal.as_deref().map(|name| choice(run_file, "decimal", name));
    let reading = ReadingOptions {
        channel: file.channel.clone(),
        pixel: file.pixel,
        lateral_unit: file.lateral_unit,
        height_unit: file.height_unit,
        override_height_unit: file.override_height_unit,
        layout: layout.transpose()?,
        decimal: decimal.transpose()?,
        missing: file.missing_marks.clone(),
        fill,
        crop: file.crop.map(Cut::Rectangle),
    };
    // From the folder of the run file; as it is written, where nothing lies there.
    let beside = run_file.parent().unwrap_or(Path::new("")).join(&file.path);
    let path = if beside.exists() { beside.as_path() } else { Path::new(&file.path) };
    let surface = from_file(path, &reading, file.cleaning)?;
    let origin = match &surface {
        One::Map(map) => &map.origin,
        One::Profile(profile) => &profile.origin,
    };
    match origin {
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
fn distinct(surfaces: Vec<(&mut String, &Origin)>) {
    let names: Vec<String> = surfaces.iter().map(|(name, _)| (*name).clone()).collect();
    let path_of = |(_, origin): &(&mut String, &Origin)| match origin {
        Origin::File(file) => Some(file.path.clone()),
        _ => None,
    };
    let paths: Vec<Option<String>> = surfaces.iter().map(path_of).collect();
    let mut given: Vec<String> = Vec::with_capacity(names.len());
    for (i, (name, _)) in surfaces.into_iter().enumerate() {
        let alike = |k: &usize| names[*k] == names[i] && paths[*k].is_some();
        let group: Vec<usize> = (0..names.len()).filter(alike).collect();
        if let Some(at) = group.iter().position(|k| *k == i) {
            let paths: Vec<&str> = group.iter().filter_map(|k| paths[*k].as_deref()).collect();
            name.clone_from(&told_apart(&paths)[at]);
        }
        let before = given.iter().filter(|n| **n == *name).count();
        given.push(name.clone());
        if before > 0 {
            *name = format!("{name} ({})", before + 1);
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
        let surface = |path: &str, name: &str| Surface {
            name: name.to_owned(),
            origin: Origin::File(FileOrigin { path: path.to_owned(), ..FileOrigin::default() }),
            heights: heights.clone(),
        };
        let mut list =
            [("a/s.stp", "s.stp"), ("b/s.stp", "s.stp"), ("t.stp", "t.stp"), ("a/s.stp", "s.stp")]
                .map(|(path, name)| surface(path, name));
        distinct(list.iter_mut().map(|s| (&mut s.name, &s.origin)).collect());
        let names = list.map(|s| s.name);
        assert_eq!(names, ["a/s.stp", "b/s.stp", "t.stp", "a/s.stp (2)"]);
    }
}
