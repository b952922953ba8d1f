//! `rough-contact app`, asked over a socket as its page asks, and as others would.

use crate::cli::app::RunningApp;
use crate::cli::{folder, has};
use serde_json::Value;
use std::io::{BufRead, BufReader, Write};
use std::net::TcpStream;

/// The status of `whole` with one part of it changed.
fn changed(app: &RunningApp, whole: &str, from: &str, to: &str) -> u16 {
    assert!(whole.contains(from), "{from}");
    app.status(&whole.replacen(from, to, 1))
}

/// That its answers are those of the command is tested in `front_ends.rs`.
#[test]
fn the_page_is_served_and_nothing_is_written() {
    let at = &folder();
    let app = RunningApp::start(at.path());
    let get = format!("GET /{}/ HTTP/1.1\r\nHost: {}\r\n\r\n", app.token, app.host);
    let (status, head, page) = app.sent(get.as_bytes());
    let page = String::from_utf8(page).expect("text");
    assert_eq!(status, 200);
    has(&head, &["frame-ancestors 'none'", "no-store"]);
    has(&page, &["default-src 'none'", "connect-src 'self'"]);
    assert!(!page.contains("<!--policy-->") && !page.contains("wasm-unsafe-eval"));
    let wave = |i: i32| (0.1 * f64::from(i * i % 97)).sin().to_string();
    let row = |iy: i32| (0..48).map(|ix| wave(48 * iy + ix)).collect::<Vec<_>>().join(" ");
    let map = (0..48).map(row).collect::<Vec<_>>().join("\n");
    let load = r#"{"name": "a.txt", "reading": {"pixel": "1um", "height_unit": "nm"}, "load": {"by": "pressure", "list": "5MPa"}}"#;
    let done = app.asked("run", load, map.as_bytes());
    assert!(done["files"]["results.json"].is_string(), "{done}");
    assert_eq!(std::fs::read_dir(at.path()).expect("a folder").count(), 0);
}

#[test]
fn who_does_not_come_from_the_page_is_refused() {
    let at = &folder();
    let app = RunningApp::start(at.path());
    let (host, token) = (&app.host, &app.token);
    let get = |path: &str, host: &str| {
        app.status(&format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n"))
    };
    assert_eq!(get(&format!("/{token}/"), host), 200);
    let port = host.rsplit(':').next().expect("a port");
    let [evil, local] = ["evil.example", "localhost"].map(|name| format!("{name}:{port}"));
    for other in ["evil.example", &evil, &local, "127.0.0.1", ""] {
        assert_eq!(get(&format!("/{token}/"), other), 403, "a name that was led here: {other:?}");
    }
    let wrong = "0".repeat(32);
    for path in [
        "/",
        "/favicon.ico",
        &format!("/{wrong}/"),
        &format!("/{}/", &token[..31]),
        &format!("/{token}"),
        &format!("/{token}/x"),
    ] {
        assert_eq!(get(path, host), 404, "{path}");
    }
    assert_eq!(app.status(&format!("GET /{token}/ HTTP/1.1\r\n\r\n")), 403, "no host at all");
    let whole = String::from_utf8(app.question("start", "{}", b"")).expect("text");
    assert_eq!(app.status(&whole), 200);
    let changed = |from: &str, to: &str| changed(&app, &whole, from, to);
    let origin = format!("Origin: http://{host}\r\n");
    for other in ["", "Origin: null\r\n", "Origin: http://evil.example\r\n"] {
        assert_eq!(changed(&origin, other), 403, "{other}");
    }
    assert_eq!(changed(&origin, &format!("{origin}{origin}")), 400);
    assert_eq!(changed("application/octet-stream", "text/plain"), 415);
    assert_eq!(changed(token, &wrong), 404);
    assert_eq!(changed("POST", "GET"), 405);
    assert_eq!(changed("POST", "OPTIONS"), 405, "no leave for other sites");
}

#[test]
fn hostile_questions_are_refused_and_the_next_is_answered() {
    let at = &folder();
    let app = RunningApp::start(at.path());
    let whole = String::from_utf8(app.question("start", "{}", b"")).expect("text");
    let changed = |from: &str, to: &str| changed(&app, &whole, from, to);
    let length = "Content-Length: 3\r\n";
    assert_eq!(changed(length, ""), 411);
    assert_eq!(changed(length, "Content-Length: -3\r\n"), 400);
    assert_eq!(changed(length, "Content-Length: +3\r\n"), 400);
    assert_eq!(changed(length, "Content-Length: 2\r\n"), 400, "more than was announced");
    assert_eq!(changed(length, "Transfer-Encoding: chunked\r\n"), 501);
    assert_eq!(changed(length, "Content-Length: 18446744073709551615\r\n"), 413);
    assert_eq!(changed(length, "Content-Length: 5000000000\r\n"), 413, "more than 4 GB");
    assert_eq!(changed("{}\n", "{} "), 400, "no line");
    assert_eq!(app.status("\0\0\0\r\n\r\n"), 400);
    assert_eq!(app.status(&format!("GET /{}", "a".repeat(20_000))), 431);
    assert_eq!(app.status(&format!("GET / HTTP/1.1\r\n{}", "A: b\r\n".repeat(100))), 431);

    // A gigabyte that is only announced: no memory for it, and no answer held up by it.
    let announced = whole.replacen(length, "Content-Length: 1000000000\r\n", 1);
    let mut waiting = app.connection();
    waiting.write_all(announced.as_bytes()).expect("it listens");
    let message = app.asked("inspect", "{}", b"no height map");
    assert_eq!(message["kind"], "error");
    let claims = b"\x93NUMPY\x01\x00\x76\x00{'descr': '<f8', 'fortran_order': False, 'shape': (4000000, 4000000), }";
    let mut hostile = claims.to_vec();
    hostile.resize(127, b' ');
    hostile.push(b'\n');
    let message = app.asked("inspect", r#"{"name": "a.npy"}"#, &hostile);
    assert_eq!(message["kind"], "error");
    assert_eq!(message["failure"]["kind"], "limit", "{message}");
    let message = app.asked("inspect", r#"{"place": {}}"#, b"");
    // Where it is answered is not the page's to say.
    assert_eq!(message["failure"]["kind"], "internal");
    assert_eq!(app.asked("run", "not JSON", b"")["kind"], "error");

    // Silent connections take all places, and give them back.
    drop(waiting);
    let silent: Vec<TcpStream> = (0..20).map(|_| app.connection()).collect();
    assert_eq!(app.status(&whole), 503);
    drop(silent);
    for attempt in 0.. {
        match app.status(&whole) {
            200 => break,
            503 if attempt < 200 => std::thread::sleep(std::time::Duration::from_millis(50)),
            other => panic!("{other}"),
        }
    }
}

#[test]
fn a_run_stops_when_the_page_waits_no_longer() {
    let at = &folder();
    let mut app = RunningApp::start(at.path());
    let mut stream = app.connection();
    stream.write_all(&app.question("run", r#"{"example": "ground"}"#, b"")).expect("it listens");
    let mut answer = BufReader::new(stream);
    let mut line = String::new();
    while !line.contains("\"stage\":\"load\"") {
        line.clear();
        assert!(answer.read_line(&mut line).expect("it goes on") > 0);
    }
    let first: Value = serde_json::from_str(&line).expect("JSON");
    assert!(first["count"].as_u64() > Some(10), "a study of many loads: {first}");
    drop(answer);
    let mut said = String::new();
    while !said.contains("stopped after") {
        assert!(!said.contains("computed in"), "it went on to the end");
        said.clear();
        assert!(app.stderr.read_line(&mut said).expect("it says so") > 0);
    }
    assert_eq!(app.asked("plan", "{}", b"")["kind"], "done", "and the next is answered");
}

/// More connections than the program may open files: those it has time out, and the next question is answered.
#[cfg(unix)]
#[test]
fn more_connections_than_files_do_not_end_it() {
    let at = &folder();
    let app = RunningApp::start_by(at.path(), "ulimit -n 40; exec \"$0\" \"$@\"");
    let idle: Vec<TcpStream> = (0..80).map(|_| app.connection()).collect();
    std::thread::sleep(std::time::Duration::from_millis(500));
    let get = format!("GET /{}/ HTTP/1.1\r\nHost: {}\r\n\r\n", app.token, app.host);
    // Sixteen are kept waiting for ten seconds; nobody has to close them.
    let answered = (0..150).any(|_| {
        std::thread::sleep(std::time::Duration::from_millis(100));
        app.answered(get.as_bytes()).is_some_and(|(status, ..)| status == 200)
    });
    assert!(answered, "idle connections keep the page out");
    drop(idle);
}
