//! A reader that closes its end, as `| head -1` does, ends the command quietly.

use crate::cli;

use cli::{folder, matrix};
use std::io::pipe;
use std::process::{Command, Stdio};

/// The exit status with standard output closed, or both streams.
fn status(folder: &std::path::Path, line: &str, both: bool) -> Option<i32> {
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
    let folder = folder();
    matrix(folder.path(), "map.txt", 8, 8, |iy, ix| (iy * ix % 5) as f64);
    let stats = "stats map.txt --pixel 1um --height-unit um --json";
    let solve = "solve map.txt --pixel 1um --height-unit um --modulus 1GPa --pressure 1MPa,2MPa";
    for both in [false, true] {
        assert_eq!(status(folder.path(), "--help", both), Some(0));
        assert_eq!(status(folder.path(), "--version", both), Some(0));
        assert_eq!(status(folder.path(), stats, both), Some(0));
        assert_eq!(status(folder.path(), "stats nothing.txt", both), Some(2));
        assert_ne!(status(folder.path(), solve, both), Some(101));
    }
}
