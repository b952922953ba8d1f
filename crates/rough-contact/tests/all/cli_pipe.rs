//! A reader that closes its end, as `| head -1` does, ends the command quietly.

use crate::cli::{UNITS, folder};
use std::io::pipe;
use std::path::Path;
use std::process::{Command, Stdio};

/// The exit status with standard output closed, or both streams.
fn status(folder: &Path, line: &str, both: bool) -> Option<i32> {
    let closed = || {
        let (reader, writer) = pipe().unwrap();
        drop(reader);
        Stdio::from(writer)
    };
    let mut command = Command::new(env!("CARGO_BIN_EXE_rough-contact"));
    command.current_dir(folder).args(line.split_whitespace()).stdout(closed());
    command.stderr(if both { closed() } else { Stdio::null() });
    command.status().unwrap().code()
}

#[test]
fn a_closed_pipe_is_no_reason_to_panic() {
    let at = &folder();
    at.matrix("map.txt", 8, 8, |iy, ix| (iy * ix % 5) as f64);
    let stats = format!("stats map.txt {UNITS} --json");
    let solve = format!("solve map.txt {UNITS} --modulus 1GPa --pressure 1MPa,2MPa");
    for both in [false, true] {
        for (line, expected) in
            [("--help", 0), ("--version", 0), (&stats, 0), ("stats nothing.txt", 2)]
        {
            assert_eq!(status(at.path(), line, both), Some(expected), "{line}");
        }
        assert_ne!(status(at.path(), &solve, both), Some(101));
    }
}
