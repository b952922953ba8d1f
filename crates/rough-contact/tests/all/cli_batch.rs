//! Several files and folders: one table, one reason for each file without an answer, nothing aborted, and
//! a run that was cut off goes on.

use crate::cli::{TestFolder, folder, has, list, number, timeless};
use serde_json::Value;
use std::path::PathBuf;

/// Two maps of the same name in two folders, and a file that is none.
fn maps() -> TestFolder {
    let at = folder();
    for (part, seed) in [("a", 1), ("b", 2)] {
        std::fs::create_dir_all(at.join(&format!("in/{part}"))).unwrap();
        let recipe = "--shape 32,48 --rolloff 24um --cutoff 6um --rms-height 0.3um --seed";
        at.synth(&format!("in/{part}/map.x3p"), &format!("{recipe} {seed}"));
    }
    at.file("in/b/broken.x3p", "PK\u{3}\u{4} cut off");
    at.file("in/picture.png", "not a surface");
    at.file("in/.hidden.x3p", "not looked at");
    at
}

/// The files of a folder, sorted.
fn files(at: &TestFolder, folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(at.join(folder)).unwrap();
    let mut all: Vec<_> = entries.map(|e| e.unwrap().path()).collect();
    all.sort();
    all
}

#[test]
fn a_folder_is_one_table_with_the_numbers_of_each_file_alone() {
    let at = &maps();
    for (command, heading) in [
        ("info", "format"),
        ("stats", "rms gradient"),
        ("solve --modulus 110GPa --pressure 50MPa,200MPa", "real pressure"),
        (
            "solve --modulus 1GPa --pressure 1MPa --resistivity 1nohm.m --leak y",
            "resistance, leak y",
        ),
    ] {
        let said = at.run(&format!("{command} in --threads 3"));
        assert_eq!(said.status, 1, "{command}: {}", said.err);
        has(&said.out, &heading.split(", ").collect::<Vec<_>>());
        for name in ["a/map.x3p", "b/map.x3p", "no answer: b/broken.x3p: "] {
            assert_eq!(said.out.matches(&format!("\n{name}")).count(), 1, "{name}: {}", said.out);
        }
        has(&said.err, &["in/picture.png", "1 of 3 files"]);
        assert!(!said.err.contains("hidden"), "{}", said.err);

        let said = at.run(&format!("{command} in --threads 3 --quiet --json"));
        assert_eq!(said.status, 1);
        let all = said.json();
        assert_eq!(all["error"]["kind"], "files_failed");
        let all = list(&all["files"]);
        let names: Vec<&str> = all.iter().map(|f| f["file"].as_str().unwrap()).collect();
        assert_eq!(names, ["in/a/map.x3p", "in/b/broken.x3p", "in/b/map.x3p"]);
        has(all[1]["error"]["message"].as_str().unwrap(), &["broken.x3p"]);
        for one in [&all[0], &all[2]] {
            let name = one["file"].as_str().unwrap();
            let alone = at.answer(&format!("{command} {name}"));
            assert_eq!(timeless(one, &["file"]), timeless(&alone, &[]), "{command} {name}");
        }
    }
    // What is wrong with the question and not with the files is said once.
    at.refuses("solve in --pressure 1MPa --quiet", &["modulus"]);
    at.refuses("stats", &["FILE"]);
    at.refuses("stats nowhere", &["nowhere"]);
}

#[test]
fn a_run_goes_on_with_what_is_whole_and_of_the_same_content_and_options() {
    let at = &maps();
    let line = "solve in --modulus 110GPa --pressure 50MPa --maps maps --out out";
    let resumed = |more: &str| at.run(&format!("{line} --resume {more}"));
    let first = at.run(&format!("{line} --json"));
    assert_eq!(first.status, 1, "{}", first.err);
    let before = files(at, "out/answers");
    assert_eq!(before.len(), 2);
    at.refuses(line, &["table.csv", "--force"]);
    let maps = files(at, "maps");
    assert!(maps.len() == 2 && maps.iter().all(|map| map.join("gap-000.npy").exists()), "{maps:?}");

    // Nothing has changed: every answer is kept, to the last digit and second.
    let changed = || {
        before.iter().map(|path| path.metadata().unwrap().modified().unwrap()).collect::<Vec<_>>()
    };
    let times = changed();
    has(&resumed("").out, &["2 of 3 answers were there already"]);
    assert_eq!(times, changed());
    assert_eq!(resumed("--json").json(), first.json());

    // Half an answer, one under its name of the time of writing, and one whose maps are gone.
    let answer =
        || timeless(&serde_json::from_slice(&std::fs::read(&before[0]).unwrap()).unwrap(), &[]);
    let (whole, kept) = (std::fs::read(&before[0]).unwrap(), answer());
    std::fs::write(&before[0], &whole[..whole.len() / 2]).unwrap();
    std::fs::write(at.join("out/answers/map.x3p-0.json.1.partial"), &whole).unwrap();
    has(&resumed("").out, &["1 of 3 answers"]);
    assert_eq!(answer(), kept);
    std::fs::remove_dir_all(at.join("maps")).unwrap();
    // Other options and another content of the same name are other answers; their results are kept.
    let table = at.read("out/table.csv");
    at.refuses(&format!("{line} --resume --level quadratic"), &["same options", "--force"]);
    assert_eq!(at.read("out/table.csv"), table);
    for more in ["", "--level quadratic --force"] {
        let said = resumed(more).out;
        assert!(!said.contains("were there already"), "{said}");
    }
    std::fs::copy(at.join("in/a/map.x3p"), at.join("in/b/map.x3p")).unwrap();
    let all = resumed("--json").json()["files"].clone();
    assert_eq!(all[0]["points"][0]["area_fraction"], all[2]["points"][0]["area_fraction"]);

    let table = at.read("out/table.csv");
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
    let at = &maps();
    at.file("in/b/flat.txt", "0 0 0 0\n0 0 0 0\n0 0 0 0\n"); // refused by the reader: no units
    let line = "compare in --modulus 110GPa --out out --quiet";
    let said = at.run(&format!("{line} --json"));
    assert_eq!(said.status, 1, "{}", said.err);
    let files = said.json()["files"].clone();
    assert_eq!(list(&files).len(), 4);
    let results = at.results("out");
    assert_eq!(list(&results["refused"]).len(), 2);
    assert_eq!(list(&results["surfaces"]).len(), 2);

    // What the table and the page say is what `compare` says of the file alone.
    let alone = "compare in/a/map.x3p --modulus 110GPa --out alone --quiet";
    let alone = at.answer(alone)["surfaces"][0].clone();
    let (one, whole) = (&files[0], &results["surfaces"][0]);
    assert_eq!(whole["statistics"], alone["statistics"]);
    assert_eq!(one["mean_pressure"], alone["headline_pressure"]);
    let error = |surface: &Value, name: &str| {
        let model = list(&surface["models"]).iter().find(|m| m["model"] == name);
        model.unwrap()["area_error"]["headline"].clone()
    };
    for name in ["gw", "persson"] {
        assert_eq!(one["models"][name]["area_error"], error(&alone, name));
        assert_eq!(error(whole, name), error(&alone, name));
    }
    let page = at.read("out/report.html");
    assert_eq!(page.matches("<h2>").count(), 6, "sections of the batch, none of a map");
    has(&page, &["files without: 2", "broken.x3p", "Distributions over the maps", "a/map.x3p"]);
    let table = at.read("out/table.csv");
    assert_eq!(table.lines().count(), 5);

    // Going on changes no number; without the word nothing is overwritten.
    at.refuses(line, &["report.html", "--force"]);
    assert_eq!(at.run(&format!("{line} --resume --json")).json()["files"], files);
    let said = at.run(&format!("{line} --resume"));
    has(&said.out, &["2 of 4 answers were there already"]);
    assert_eq!(at.read("out/table.csv"), table);
}

#[test]
fn of_a_few_files_one_that_fails_costs_the_others_nothing() {
    let at = &maps();
    at.file("tiny.txt", "1 2\n3 5\n");
    let line = "compare in/a/map.x3p in/b/broken.x3p tiny.txt in/b/map.x3p --modulus 110GPa --pressure \
                100MPa --pixel 1um --height-unit nm --quiet --out out --json";
    let said = at.run(line);
    assert_eq!(said.status, 1, "{}", said.err);
    let results = said.json();
    let names = |key: &str| -> Vec<String> {
        list(&results[key]).iter().map(|s| s["name"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(names("surfaces"), ["a/map.x3p", "b/map.x3p"]);
    assert!(names("refused").contains(&"broken.x3p".to_owned()), "{:?}", names("refused"));
    has(&said.err, &names("refused").iter().map(String::as_str).collect::<Vec<_>>());
    has(&at.read("out/report.html"), &["no study", "broken.x3p"]);
    // All refused is refused.
    at.refuses("compare in/b/broken.x3p --modulus 1GPa --out no", &["broken.x3p"]);
}

/// Traces in several files are one sample, as traces beside each other in one file are.
#[test]
fn traces_of_several_files_are_pooled() {
    let at = &folder();
    let height =
        |i: usize, k: usize| ((i * 37 + k * 101) % 29) as f64 * 0.01 + (i as f64 * 0.05).sin();
    let traces = |name: &str, title: &str, columns: &[usize], count: usize| {
        let rows = (0..count).map(|i| {
            let z: Vec<String> = columns.iter().map(|&k| format!("{:.6}", height(i, k))).collect();
            format!("{i} {}\n", z.join(" "))
        });
        at.file(name, &(format!("{title}\n") + &rows.collect::<String>()));
    };
    traces("all.txt", "x z1 z2 z3", &[1, 2, 3], 400);
    for k in 1..=3 {
        traces(&format!("t{k}.txt"), "x z", &[k], 400);
    }
    traces("short.txt", "x z", &[1], 200);
    let units = "--lateral-unit um --height-unit um";
    let pooled = at.answer(&format!("stats t1.txt t2.txt t3.txt --pool {units}"));
    assert_eq!(pooled, at.answer(&format!("stats all.txt {units}")));
    assert_eq!(pooled["traces"], 3);
    at.refuses_each(
        &format!("stats t1.txt {units} --pool"),
        &[
            ("t2.txt --scales", &["--pool", "--scales"]),
            ("short.txt", &["short.txt", "--crop", "400", "200"]),
        ],
    );
}
