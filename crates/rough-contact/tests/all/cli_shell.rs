//! Completions and manual pages as a shell and `man` take them, and a reader that closes its end.

use crate::cli::{TestFolder, UNITS, folder};
use std::io::pipe;
use std::path::Path;
use std::process::{Command, Stdio};

/// Commands as `--help` lists them.
fn commands(at: &TestFolder) -> Vec<String> {
    let help = at.run("--help").out;
    let listed = help.lines().skip_while(|line| !line.starts_with("Commands:")).skip(1);
    let names: Vec<String> = listed
        .take_while(|line| line.starts_with("  "))
        .filter_map(|line| line.split_whitespace().next().map(str::to_owned))
        .filter(|name| name != "help")
        .collect();
    assert!(names.len() > 9, "{help}");
    names
}

/// Long options as the help of a command lists them.
fn options(at: &TestFolder, command: &str) -> Vec<String> {
    let help = at.run(&format!("{command} --help")).out;
    let lines = help.lines().map(str::trim_start).filter(|line| line.starts_with('-'));
    let words = lines.flat_map(|line| line.split([' ', ','])).filter(|w| w.starts_with("--"));
    words.map(str::to_owned).collect()
}

#[test]
fn every_command_and_option_is_completed_and_has_its_line_in_a_manual_page() {
    let at = &folder();
    at.done("man --out pages");
    let scripts = ["bash", "zsh", "fish", "powershell"]
        .map(|shell| (shell, at.run(&format!("completions {shell}")).out));
    for command in commands(at) {
        let page = at.read(&format!("pages/rough-contact-{command}.1"));
        assert_eq!(page, at.run(&format!("man {command}")).out);
        let entries: Vec<Vec<&str>> = page.split(".TP\n").map(|e| e.lines().collect()).collect();
        for option in options(at, &command) {
            let line = option.replace('-', "\\-");
            let is_told = |entry: &Vec<&str>| entry.len() > 1 && entry[0].contains(&line);
            assert!(entries.iter().any(is_told), "{command}: no {option} with its text in man");
            for (shell, script) in &scripts {
                // fish names options without their dashes.
                let named = if *shell == "fish" { option.trim_start_matches('-') } else { &option };
                assert!(script.contains(named), "{shell}: no {option} of {command}");
            }
        }
    }
    at.refuses("man --out pages", &["exists", "--force"]);
    at.refuses("man nothing", &["rough-contact-nothing.1"]);
    at.refuses("completions csh", &["csh", "bash"]);
}

/// `program` with these arguments, if it is there.
#[cfg(unix)]
fn run(at: &TestFolder, program: &str, args: &[&str]) -> Option<(String, String)> {
    let mut command = Command::new(program);
    let output = command.args(args).current_dir(at.path()).stdin(Stdio::null()).output().ok()?;
    let text = |bytes| String::from_utf8(bytes).expect("text");
    Some((text(output.stdout), text(output.stderr)))
}

#[test]
#[cfg(unix)]
fn bash_completes_commands_options_and_values() {
    let at = &folder();
    at.file("completions", &at.run("completions bash").out);
    // What bash itself does at the key: it calls the function that `complete` was given.
    let asked = |words: &str| {
        let line = format!(
            "source ./completions && f=$(complete -p rough-contact | sed 's/.* -F \\([^ ]*\\) .*/\\1/') && \
             COMP_WORDS=({words}) && COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)) && \
             $f rough-contact \"${{COMP_WORDS[COMP_CWORD]}}\" \"${{COMP_WORDS[COMP_CWORD-1]}}\" && echo \"${{COMPREPLY[@]}}\""
        );
        run(at, "bash", &["--norc", "-c", &line])
    };
    let Some((found, complaint)) = asked("rough-contact so") else { return };
    assert_eq!((found.as_str(), complaint.as_str()), ("solve\n", ""));
    let found = |words: &str| asked(words).expect("bash was there").0;
    assert_eq!(found("rough-contact solve --tol"), "--tolerance\n");
    assert_eq!(found("rough-contact solve --edges ''"), "periodic mirrored\n");
    assert!(found("rough-contact completions ''").contains("bash zsh fish powershell"));
}

#[test]
#[cfg(unix)]
fn groff_sets_every_page_without_a_warning() {
    let at = &folder();
    at.run("man --out pages");
    for page in std::fs::read_dir(at.join("pages")).expect("pages").flatten() {
        let page = page.path();
        let name = page.to_str().expect("a plain name");
        let args = ["-man", "-ww", "-Kutf8", "-Tutf8", "-P-c", "-P-b", "-P-u", name];
        let Some((set, complaint)) = run(at, "groff", &args) else { return };
        assert_eq!(complaint, "", "{}", page.display());
        assert!(set.contains("--force"), "{set}");
        assert!(set.contains(concat!("rough-contact ", env!("CARGO_PKG_VERSION"))), "{set}");
    }
}

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
fn a_closed_pipe_ends_the_command_quietly() {
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
