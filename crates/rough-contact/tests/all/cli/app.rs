//! `rough-contact app`, asked over a socket as its page asks.

use serde_json::Value;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, ChildStderr, Command, Stdio};

/// The program, ended with the test.
pub(crate) struct RunningApp {
    child: Child,
    pub(crate) stderr: BufReader<ChildStderr>,
    pub(crate) host: String,
    pub(crate) token: String,
}

impl RunningApp {
    pub(crate) fn start(dir: &Path) -> Self {
        Self::of(Command::new(env!("CARGO_BIN_EXE_rough-contact")), dir)
    }

    /// By a line of the shell, which has the command and its arguments as "$0" and "$@".
    pub(crate) fn start_by(dir: &Path, line: &str) -> Self {
        let mut shell = Command::new("sh");
        shell.args(["-c", line, env!("CARGO_BIN_EXE_rough-contact")]);
        Self::of(shell, dir)
    }

    fn of(mut command: Command, dir: &Path) -> Self {
        let mut child = command
            .current_dir(dir)
            .args(["app", "--no-open", "--json", "--threads", "1"])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command is built");
        let mut line = String::new();
        let stdout = child.stdout.take().expect("a pipe");
        BufReader::new(stdout).read_line(&mut line).expect("its address");
        let said: Value = serde_json::from_str(&line).expect("one object");
        let address = said["address"].as_str().expect("an address").to_owned();
        let rest = address.strip_prefix("http://").expect("HTTP");
        let (host, path) = rest.split_once('/').expect("a path");
        let token = path.trim_end_matches('/').to_owned();
        assert!(host.starts_with("127.0.0.1:"), "{host}: loopback only");
        assert_eq!(token.len(), 32);
        let stderr = BufReader::new(child.stderr.take().expect("a pipe"));
        Self { child, stderr, host: host.to_owned(), token }
    }

    pub(crate) fn connection(&self) -> TcpStream {
        TcpStream::connect(&self.host).expect("it listens")
    }

    /// Sends bytes, and reads the answer: status, head, body.
    pub(crate) fn sent(&self, bytes: &[u8]) -> (u16, String, Vec<u8>) {
        self.answered(bytes).expect("an answer")
    }

    /// The same, if there is an answer.
    pub(crate) fn answered(&self, bytes: &[u8]) -> Option<(u16, String, Vec<u8>)> {
        let mut stream = TcpStream::connect(&self.host).ok()?;
        // What is refused may be answered before all of it is written.
        let _ = stream.write_all(bytes);
        let mut all = Vec::new();
        stream.read_to_end(&mut all).ok()?;
        let end = all.windows(4).position(|w| w == b"\r\n\r\n")?;
        let head = String::from_utf8(all[..end].to_vec()).ok()?;
        let status = head.split(' ').nth(1)?.parse().ok()?;
        Some((status, head, all[end + 4..].to_vec()))
    }

    /// A question as the page asks it.
    pub(crate) fn question(&self, question: &str, request: &str, file: &[u8]) -> Vec<u8> {
        let mut text = format!(
            "POST /{0}/ask/{question} HTTP/1.1\r\nHost: {1}\r\nOrigin: http://{1}\r\n\
             Content-Type: application/octet-stream\r\nContent-Length: {2}\r\n\r\n{request}\n",
            self.token,
            self.host,
            request.len() + 1 + file.len()
        )
        .into_bytes();
        text.extend_from_slice(file);
        text
    }

    /// The last message of an answer.
    pub(crate) fn asked(&self, question: &str, request: &str, file: &[u8]) -> Value {
        let (status, _, body) = self.sent(&self.question(question, request, file));
        assert_eq!(status, 200);
        let text = String::from_utf8(body).expect("text");
        serde_json::from_str(text.lines().last().expect("a message")).expect("JSON")
    }

    pub(crate) fn status(&self, bytes: &str) -> u16 {
        self.sent(bytes.as_bytes()).0
    }
}

impl Drop for RunningApp {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
