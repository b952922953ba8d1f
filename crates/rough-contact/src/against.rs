//! A second body, pressed on the first.

use crate::args;
use crate::input::{FileOptions, One};
use crate::outcome::{Failure, unfit};
use clap::{Args, Parser};
use rough_contact::compare::{Body, Flip, Level, PairOrigin, Placing, Settings, Surface};
use rough_contact::{compare, front_end, report};
use std::path::{Path, PathBuf};

#[derive(Args, Clone, Debug)]
pub(crate) struct Against {
    /// Surface file of a second body that lies face down on FILE: the sum of both heights is solved
    #[arg(long = "against", id = "against", value_name = "FILE2")]
    second: Option<PathBuf>,
    /// How it is turned over: columns, as a book is closed; rows, as a page of a wall calendar is
    /// turned; none, its map already stands as it lies [default: columns]
    #[arg(long, value_name = "HOW", value_parser = args::one_of::<Flip>())]
    flip: Option<Flip>,
    /// Move it then along columns and rows, in whole points
    #[arg(long, value_name = "DX,DY", value_parser = shift, allow_hyphen_values = true)]
    shift: Option<[f64; 2]>,
    /// File and cleaning options of the second body, such as "--fill harmonic --crop 0,0,99,99", in
    /// place of those of FILE [default: those of FILE]
    #[arg(long = "against-options", id = "against_options", value_name = "OPTIONS")]
    #[arg(value_parser = own, allow_hyphen_values = true)]
    own: Option<Own>,
}

const FOR_MAPS: &str = "this is a profile, and --against presses two maps on each other; a line of one body says \
                        nothing of where the other meets it";

#[derive(Parser, Clone, Debug)]
#[command(no_binary_name = true, disable_help_flag = true)]
struct Own {
    #[command(flatten)]
    how: FileOptions,
}

fn own(text: &str) -> Result<Own, String> {
    Own::try_parse_from(words(text)?).map_err(|e| {
        let message = e.to_string();
        let first = message.lines().next().unwrap_or_default();
        first.trim_start_matches("error: ").to_owned()
    })
}

/// The words of a line; quotes keep spaces together.
fn words(text: &str) -> Result<Vec<String>, String> {
    let (mut words, mut word, mut quote) = (Vec::new(), None::<String>, None);
    for c in text.chars() {
        match quote {
            Some(open) if c == open => quote = None,
            None if c == '"' || c == '\'' => {
                quote = Some(c);
                word.get_or_insert_default();
            }
            None if c.is_whitespace() => words.extend(word.take()),
            _ => word.get_or_insert_default().push(c),
        }
    }
    if quote.is_some() {
        return Err("a quotation mark is not closed".to_owned());
    }
    words.extend(word);
    Ok(words)
}

/// `DX,DY` as `[dy, dx]` in metres.
fn shift(text: &str) -> Result<[f64; 2], String> {
    match args::lengths(text)?[..] {
        [dx, dy] => Ok([dy, dx]),
        _ => Err(format!("'{text}' is not DX,DY; write for example 10um,0um")),
    }
}

impl Against {
    /// The file of the second body; its options without one are a mistake.
    pub(crate) fn given(&self) -> Result<Option<&Path>, Failure> {
        let alone = [
            ("--flip", self.flip.is_some()),
            ("--shift", self.shift.is_some()),
            ("--against-options", self.own.is_some()),
        ];
        if let (None, Some((name, _))) = (&self.second, alone.iter().find(|(_, given)| *given)) {
            let message = format!("{name} is for a second body; give --against FILE too");
            return Err(Failure::refused("usage", message));
        }
        Ok(self.second.as_deref())
    }

    /// What is in the file, with the second body on it if there is one; with its hash, for a run that is to be repeated.
    pub(crate) fn measured(
        &self,
        path: &Path,
        how: &FileOptions,
        level: Level,
        hashed: bool,
    ) -> Result<One, Failure> {
        let Some(second) = self.given()? else {
            return how.measured(path, hashed);
        };
        let map = |path: &Path, how: &FileOptions| match how.measured(path, true)? {
            One::Map(map) => Ok(*map),
            One::Profile(_) => Err(unfit(path, "profile", FOR_MAPS)),
        };
        let own = self.own.as_ref().map_or(how, |own| &own.how);
        let (first, second): (Surface, Surface) = (map(path, how)?, map(second, own)?);
        let placing =
            Placing { flip: self.flip.unwrap_or_default(), shift: self.shift.unwrap_or_default() };
        front_end::pressed(first, second, &placing, level).map(|map| One::Map(Box::new(map)))
    }

    /// What the answer depends on beside the first file and the options.
    pub(crate) fn content(&self) -> String {
        let content = self.second.as_ref().and_then(|path| std::fs::read(path).ok());
        content.map_or_else(String::new, |content| compare::sha256_hex(&content))
    }
}

/// The lines of a terminal on a pair; on the modulus its bodies make, which those of one body have too.
pub(crate) fn lines(pair: Option<&PairOrigin>, made_of: Option<(f64, Vec<Body>)>) -> String {
    let Some(pair) = pair else {
        return made_of.map_or_else(String::new, |(modulus, bodies)| {
            format!("bodies: {}\n", report::bodies_line(modulus, &bodies))
        });
    };
    let settings =
        made_of.map(|(modulus, bodies)| Settings { modulus, bodies, ..Settings::default() });
    report::pair_lines(pair, settings.as_ref()).join("\n") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use rough_contact::contact_types::Named;

    #[test]
    fn options_of_the_second_body_are_read_as_those_of_the_first() {
        let said = own("--fill harmonic --channel 'Z Axis' --outliers 8").unwrap();
        assert_eq!(said.how.reading.channel.as_deref(), Some("Z Axis"));
        assert_eq!(said.how.reading.fill.name(), "harmonic");
        assert_eq!(said.how.cleaning.asked().outliers, Some(8.0));
        for bad in ["--fill some", "--channel 'Z", "--pressure 1MPa", "b.x3p"] {
            assert!(own(bad).is_err(), "{bad}");
        }
        assert_eq!(shift("10um,-2um").unwrap().map(|d| (1e9 * d).round() as i32), [-2000, 10_000]);
        assert!(shift("10um").is_err());
    }
}
