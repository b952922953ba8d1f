//! Several files and folders: one table, one reason for each file without an answer, nothing aborted, and
//! a run that was cut off goes on.

use crate::cli;

use cli::{file, folder, number, refused, rough_contact};
use serde_json::Value;
use std::path::Path;

/// Two maps of the same name in two folders, and a file that is none.
fn maps(at: &Path) {
    for (name, seed) in [("in/a/map.x3p", 1), ("in/b/map.x3p", 2)] {
        std::fs::create_dir_all(at.join(name).parent().unwrap()).unwrap();
        let synth = format!(
            "synth --shape 32,48 --pixel 1um --hurst 0.8 --rolloff 24um --cutoff 6um \
             --rms-height 0.3um --seed {seed} --out {name}"
        );
        assert_eq!(rough_contact(at, &synth).status, 0);
    }
    file(at, "in/b/broken.x3p", "PK\u{3}\u{4} cut off");
    file(at, "in/picture.png", "not a surface");
    file(at, "in/.hidden.x3p", "not looked at");
}

/// An answer without what differs between two runs.
fn without_times(value: &Value) -> Value {
    match value {
        Value::Object(map) => {
            let kept = map.iter().filter(|(key, _)| *key != "seconds");
            kept.map(|(key, value)| (key.clone(), without_times(value))).collect()
        }
        Value::Array(items) => items.iter().map(without_times).collect(),
        other => other.clone(),
    }
}

fn changed(path: &Path) -> std::time::SystemTime {
    path.metadata().unwrap().modified().unwrap()
}

fn kept(at: &Path) -> Vec<std::path::PathBuf> {
    let entries = std::fs::read_dir(at.join("out/answers")).unwrap();
    let mut all: Vec<_> = entries.map(|e| e.unwrap().path()).collect();
    all.sort();
    all
}

#[test]
fn a_folder_is_one_table_with_the_numbers_of_each_file_alone() {
    let dir = folder();
    let at = dir.path();
    maps(at);
    for (command, heading) in [
        ("info", "format"),
        ("stats", "rms gradient"),
        ("solve --modulus 110GPa --pressure 50MPa,200MPa", "real pressure"),
    ] {
        let said = rough_contact(at, &format!("{command} in --threads 3"));
        assert_eq!(said.status, 1, "{command}: {}", said.err);
        assert!(said.out.contains(heading), "{}", said.out);
        for name in ["a/map.x3p", "b/map.x3p", "no answer: b/broken.x3p: "] {
            assert_eq!(said.out.matches(&format!("\n{name}")).count(), 1, "{name}: {}", said.out);
        }
        assert!(
            said.err.contains("in/picture.png") && !said.err.contains("hidden"),
            "{}",
            said.err
        );
        assert!(said.err.contains("1 of 3 files"), "{}", said.err);

        let said = rough_contact(at, &format!("{command} in --threads 3 --quiet --json"));
        assert_eq!(said.status, 1);
        let all = said.json();
        assert_eq!(all["error"]["kind"], "files_failed");
        let all = all["files"].as_array().unwrap().clone();
        let names: Vec<&str> = all.iter().map(|f| f["file"].as_str().unwrap()).collect();
        assert_eq!(names, ["in/a/map.x3p", "in/b/broken.x3p", "in/b/map.x3p"]);
        assert!(all[1]["error"]["message"].as_str().unwrap().contains("broken.x3p"));
        for one in [&all[0], &all[2]] {
            let name = one["file"].as_str().unwrap();
            let alone = rough_contact(at, &format!("{command} {name} --json")).answered();
            let mut of_many = without_times(one);
            of_many.as_object_mut().unwrap().remove("file");
            assert_eq!(of_many, without_times(&alone), "{command} {name}");
        }
    }
    // What is wrong with the question and not with the files is said once.
    refused(at, "solve in --pressure 1MPa --quiet", 2, &["modulus"]);
    refused(at, "stats", 2, &["FILE"]);
    refused(at, "stats nowhere", 2, &["nowhere"]);
}

#[test]
fn a_run_goes_on_with_what_is_whole_and_of_the_same_content_and_options() {
    let dir = folder();
    let at = dir.path();
    maps(at);
    let line = "solve in --modulus 110GPa --pressure 50MPa --maps maps --out out";
    let first = rough_contact(at, &format!("{line} --json"));
    assert_eq!(first.status, 1, "{}", first.err);
    let before = kept(at);
    assert_eq!(before.len(), 2);
    refused(at, line, 2, &["table.csv", "--force"]);
    let written = |e: std::io::Result<std::fs::DirEntry>| e.unwrap().path().join("gap-000.npy");
    let maps = std::fs::read_dir(at.join("maps")).unwrap().map(written);
    assert_eq!(maps.filter(|map| map.exists()).count(), 2, "the maps of two files, apart");

    // Nothing has changed: every answer is kept, to the last digit and second.
    let times: Vec<_> = before.iter().map(|p| changed(p)).collect();
    let said = rough_contact(at, &format!("{line} --resume"));
    assert!(said.out.contains("2 of 3 answers were there already"), "{}", said.out);
    assert_eq!(times, before.iter().map(|p| changed(p)).collect::<Vec<_>>());
    let again = rough_contact(at, &format!("{line} --resume --json"));
    assert_eq!(again.json(), first.json());

    // Half an answer, one under its name of the time of writing, and one whose maps are gone.
    let whole = std::fs::read(&before[0]).unwrap();
    std::fs::write(&before[0], &whole[..whole.len() / 2]).unwrap();
    std::fs::write(at.join("out/answers/map.x3p-0.json.1.partial"), &whole).unwrap();
    let said = rough_contact(at, &format!("{line} --resume"));
    assert!(said.out.contains("1 of 3 answers"), "{}", said.out);
    assert_eq!(without_times(&serde_json::from_slice(&whole).unwrap()), {
        without_times(&serde_json::from_slice(&std::fs::read(&before[0]).unwrap()).unwrap())
    });
    std::fs::remove_dir_all(at.join("maps")).unwrap();
    let said = rough_contact(at, &format!("{line} --resume"));
    assert!(!said.out.contains("were there already"), "{}", said.out);

    // Other options and another content of the same name are other answers.
    let said = rough_contact(at, &format!("{line} --resume --level quadratic"));
    assert!(!said.out.contains("were there already"), "{}", said.out);
    std::fs::copy(at.join("in/a/map.x3p"), at.join("in/b/map.x3p")).unwrap();
    let said = rough_contact(at, &format!("{line} --resume --json"));
    let all = said.json()["files"].clone();
    assert_eq!(all[0]["points"][0]["area_fraction"], all[2]["points"][0]["area_fraction"]);

    let table = std::fs::read_to_string(at.join("out/table.csv")).unwrap();
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!(rows.len(), 4);
    assert!(rows[0].starts_with("file,") && rows[0].contains("mean_gap (m)"), "{}", rows[0]);
    let column = rows[0].split(',').position(|head| head == "area_fraction").unwrap();
    let cell: f64 = rows[1].split(',').nth(column).unwrap().parse().unwrap();
    assert!((cell - number(&all[0]["points"][0]["area_fraction"])).abs() < 1e-15);
    assert!(rows[2].starts_with("in/b/broken.x3p,,") && !rows[2].ends_with(','), "{}", rows[2]);
}

#[test]
fn a_folder_compared_is_a_page_of_distributions() {
    let dir = folder();
    let at = dir.path();
    maps(at);
    file(at, "in/b/flat.txt", "0 0 0 0\n0 0 0 0\n0 0 0 0\n"); // refused by the reader: no units
    let line = "compare in --modulus 110GPa --out out --quiet --json";
    let said = rough_contact(at, line);
    assert_eq!(said.status, 1, "{}", said.err);
    let all = said.json()["files"].as_array().unwrap().clone();
    assert_eq!(all.len(), 4);
    let read = |name: &str| std::fs::read_to_string(at.join("out").join(name)).unwrap();
    let results: Value = serde_json::from_str(&read("results.json")).unwrap();
    assert_eq!(results["refused"].as_array().unwrap().len(), 2);
    assert_eq!(results["surfaces"].as_array().unwrap().len(), 2);

    // What the table and the page say is what `compare` says of the file alone.
    let alone = "compare in/a/map.x3p --modulus 110GPa --out alone --quiet --json";
    let alone = rough_contact(at, alone).answered()["surfaces"][0].clone();
    let (one, whole) = (&all[0], &results["surfaces"][0]);
    assert_eq!(whole["statistics"], alone["statistics"]);
    assert_eq!(one["mean_pressure"], alone["headline_pressure"]);
    let error = |surface: &Value, name: &str| {
        let models = surface["models"].as_array().unwrap();
        models.iter().find(|m| m["model"] == name).unwrap()["area_error"]["headline"].clone()
    };
    for name in ["gw", "persson"] {
        assert_eq!(one["models"][name]["area_error"], error(&alone, name));
        assert_eq!(error(whole, name), error(&alone, name));
    }
    let page = read("report.html");
    assert_eq!(page.matches("<h2>").count(), 6, "sections of the batch, none of a map");
    for part in ["files without: 2", "broken.x3p", "Distributions over the maps", "a/map.x3p"] {
        assert!(page.contains(part), "{part}");
    }
    assert_eq!(read("table.csv").lines().count(), 5);

    // Going on changes no number; without the word nothing is overwritten.
    refused(at, "compare in --modulus 110GPa --out out --quiet", 2, &["report.html", "--force"]);
    let again = rough_contact(at, &format!("{line} --resume"));
    assert_eq!(again.json()["files"], said.json()["files"]);
    let names = read("table.csv");
    let said = rough_contact(at, "compare in --modulus 110GPa --out out --quiet --resume");
    assert!(said.out.contains("2 of 4 answers were there already"), "{}", said.out);
    assert_eq!(read("table.csv"), names);
}

#[test]
fn of_a_few_files_one_that_fails_costs_the_others_nothing() {
    let dir = folder();
    let at = dir.path();
    maps(at);
    std::fs::write(at.join("tiny.txt"), "1 2\n3 5\n").unwrap();
    let line = "compare in/a/map.x3p in/b/broken.x3p tiny.txt in/b/map.x3p --modulus 110GPa --pressure \
                100MPa --pixel 1um --height-unit nm --quiet --out out --json";
    let said = rough_contact(at, line);
    assert_eq!(said.status, 1, "{}", said.err);
    let results = said.json();
    let names = |key: &str| -> Vec<String> {
        let list = results[key].as_array().unwrap();
        list.iter().map(|s| s["name"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(names("surfaces"), ["a/map.x3p", "b/map.x3p"]);
    assert!(names("refused").contains(&"broken.x3p".to_owned()), "{:?}", names("refused"));
    for name in names("refused") {
        assert!(said.err.contains(&name), "{name}: {}", said.err);
    }
    let page = std::fs::read_to_string(at.join("out/report.html")).unwrap();
    assert!(page.contains("no study") && page.contains("broken.x3p"));
    // All refused is refused.
    refused(at, "compare in/b/broken.x3p --modulus 1GPa --out no", 2, &["broken.x3p"]);
}

/// Traces in several files are one sample, as traces beside each other in one file are.
#[test]
fn traces_of_several_files_are_pooled() {
    let dir = folder();
    let at = dir.path();
    let height =
        |i: usize, k: usize| ((i * 37 + k * 101) % 29) as f64 * 0.01 + (i as f64 * 0.05).sin();
    let table = |columns: &[usize], count: usize| -> String {
        let rows = (0..count).map(|i| {
            let z: Vec<String> = columns.iter().map(|&k| format!("{:.6}", height(i, k))).collect();
            format!("{} {}\n", i, z.join(" "))
        });
        rows.collect()
    };
    let names = ["x z1 z2 z3\n", "x z\n"];
    file(at, "all.txt", &(names[0].to_owned() + &table(&[1, 2, 3], 400)));
    for k in 1..=3 {
        file(at, &format!("t{k}.txt"), &(names[1].to_owned() + &table(&[k], 400)));
    }
    file(at, "short.txt", &(names[1].to_owned() + &table(&[1], 200)));
    let units = "--lateral-unit um --height-unit um";
    let one = rough_contact(at, &format!("stats all.txt {units} --json")).answered();
    let pooled =
        rough_contact(at, &format!("stats t1.txt t2.txt t3.txt --pool {units} --json")).answered();
    assert_eq!(pooled, one);
    assert_eq!(pooled["traces"], 3);
    let scales = format!("stats t1.txt t2.txt --pool --scales {units}");
    refused(at, &scales, 2, &["--pool", "--scales"]);
    refused(
        at,
        &format!("stats t1.txt short.txt --pool {units}"),
        2,
        &["short.txt", "--crop", "400", "200"],
    );
}
