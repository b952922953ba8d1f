//! Completions and manual pages, as a shell and `man` take them.

use crate::cli;

use cli::{folder, refused, rough_contact};
use std::path::Path;
use std::process::{Command, Stdio};

/// Commands as `--help` lists them.
fn commands(dir: &Path) -> Vec<String> {
    let help = rough_contact(dir, "--help").out;
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
fn options(dir: &Path, command: &str) -> Vec<String> {
    let help = rough_contact(dir, &format!("{command} --help")).out;
    let lines = help.lines().map(str::trim_start).filter(|line| line.starts_with('-'));
    let words = lines.flat_map(|line| line.split([' ', ','])).filter(|w| w.starts_with("--"));
    words.map(str::to_owned).collect()
}

#[test]
fn every_command_and_option_is_completed_and_has_its_line_in_a_manual_page() {
    let dir = folder();
    let said = rough_contact(dir.path(), "man --out pages");
    assert_eq!(said.status, 0, "{}", said.err);
    let scripts = ["bash", "zsh", "fish", "powershell"]
        .map(|shell| (shell, rough_contact(dir.path(), &format!("completions {shell}")).out));
    for command in commands(dir.path()) {
        let page = dir.path().join(format!("pages/rough-contact-{command}.1"));
        let page = std::fs::read_to_string(page).expect("a page for each command");
        assert_eq!(page, rough_contact(dir.path(), &format!("man {command}")).out);
        for option in options(dir.path(), &command) {
            assert!(page.contains(&option.replace('-', "\\-")), "{command}: no {option} in man");
            for (shell, script) in &scripts {
                // fish names options without their dashes.
                let named = if *shell == "fish" { option.trim_start_matches('-') } else { &option };
                assert!(script.contains(named), "{shell}: no {option} of {command}");
            }
        }
    }
    refused(dir.path(), "man --out pages", 2, &["exists", "--force"]);
    refused(dir.path(), "man nothing", 2, &["rough-contact-nothing.1"]);
    refused(dir.path(), "completions csh", 2, &["csh", "bash"]);
}

/// `program` with these arguments, if it is there.
#[cfg(unix)]
fn run(dir: &Path, program: &str, args: &[&str]) -> Option<(String, String)> {
    let output =
        Command::new(program).args(args).current_dir(dir).stdin(Stdio::null()).output().ok()?;
    let text = |bytes| String::from_utf8(bytes).expect("text");
    Some((text(output.stdout), text(output.stderr)))
}

#[test]
#[cfg(unix)]
fn bash_completes_commands_options_and_values() {
    let dir = folder();
    let script = rough_contact(dir.path(), "completions bash").out;
    std::fs::write(dir.path().join("completions"), script).expect("a file");
    // What bash itself does at the key: it calls the function that `complete` was given.
    let asked = |words: &str| {
        let line = format!(
            "source ./completions && f=$(complete -p rough-contact | sed 's/.* -F \\([^ ]*\\) .*/\\1/') && \
             COMP_WORDS=({words}) && COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)) && \
             $f rough-contact \"${{COMP_WORDS[COMP_CWORD]}}\" \"${{COMP_WORDS[COMP_CWORD-1]}}\" && echo \"${{COMPREPLY[@]}}\""
        );
        run(dir.path(), "bash", &["--norc", "-c", &line])
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
    let dir = folder();
    rough_contact(dir.path(), "man --out pages");
    let pages = std::fs::read_dir(dir.path().join("pages")).expect("pages");
    for page in pages.flatten() {
        let page = page.path();
        let args = [
            "-man",
            "-ww",
            "-Kutf8",
            "-Tutf8",
            "-P-c",
            "-P-b",
            "-P-u",
            page.to_str().expect("a plain name"),
        ];
        let Some((set, complaint)) = run(dir.path(), "groff", &args) else { return };
        assert_eq!(complaint, "", "{}", page.display());
        assert!(set.contains("--force"), "{set}");
        assert!(set.contains(concat!("rough-contact ", env!("CARGO_PKG_VERSION"))), "{set}");
    }
}
