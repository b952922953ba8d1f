//! `rough-contact app`: the page in a browser, with this program as its engine; who may ask, and what is answered.

use crate::args::CommonOptions;
use crate::http::{self, Head, HttpRefusal};
use crate::outcome::{self, Failure, Reply, tell};
use clap::Args;
use contact_web::{Host, Messages, answer, page_of_program};
use serde_json::json;
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::time::{Duration, Instant};

#[derive(Args)]
pub(crate) struct App {
    /// Print the address only, and open no browser
    #[arg(long)]
    no_open: bool,
}

impl App {
    /// Serves the page on the loopback address until it is ended.
    pub(crate) fn run(&self, common: &CommonOptions) -> Result<Reply, Failure> {
        let refused = |e: std::io::Error| {
            let message = format!("no port of 127.0.0.1 can be listened to: {e}");
            Failure::incomplete("io", message)
        };
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).map_err(refused)?;
        let port = listener.local_addr().map_err(refused)?.port();
        let (token, place) = (secret()?, Host::machine(common.threads()));
        let host = format!("127.0.0.1:{port}");
        let origin = format!("http://{host}");
        let address = format!("{origin}/{token}/");
        let line =
            if common.json { json!({ "address": address }).to_string() } else { address.clone() };
        outcome::show(&format!("{line}\n"));
        if !common.quiet {
            tell(
                "The page at this address computes with this program, on this machine only. Ctrl-C ends it.",
            );
        }
        if !self.no_open && !open(&address) {
            tell("rough-contact: no browser could be opened; open the address above in one");
        }
        let (page, quiet) = (page_of_program(place), common.quiet);
        Site { host, origin, token, place, page, quiet }.serve(&listener)
    }
}

/// 128 bits that nobody can guess.
fn secret() -> Result<String, Failure> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(|e| {
        Failure::incomplete("io", format!("the system gives no random numbers: {e}"))
    })?;
    Ok(format!("{:032x}", u128::from_ne_bytes(bytes)))
}

/// Opens the address as the system opens one. True if that could be started.
fn open(address: &str) -> bool {
    let mut command = if cfg!(target_os = "macos") {
        Command::new("open")
    } else if cfg!(windows) {
        // `start` would have the shell read the address.
        let mut command = Command::new("rundll32");
        command.arg("url.dll,FileProtocolHandler");
        command
    } else {
        Command::new("xdg-open")
    };
    command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().is_ok()
}

/// Connections at the same time. A browser opens six.
const MOST_CONNECTIONS: usize = 16;

/// Between a connection that could not be taken and the next.
const AGAIN: Duration = Duration::from_millis(20);

/// Most bytes of a request, which comes before the file.
const MOST_REQUEST: usize = 1 << 20;

/// Who may ask, and what is served.
struct Site {
    /// What a browser that asks us names as its host; another name that leads here is another's.
    host: String,
    /// What it says where a question comes from: our page.
    origin: String,
    /// A secret that only who has opened the page knows.
    token: String,
    place: Host,
    page: String,
    /// Nothing is told in the terminal.
    quiet: bool,
}

impl Site {
    /// Answers until the program is ended. What keeps a connection from being taken passes: the other side has gone, or
    /// there are too many open files until others time out.
    fn serve(self, listener: &TcpListener) -> ! {
        // One clone for each connection that is open.
        let (site, open) = (Arc::new(self), Arc::new(()));
        loop {
            let Ok((mut stream, _)) = listener.accept() else {
                std::thread::sleep(AGAIN);
                continue;
            };
            let (site, taken) = (Arc::clone(&site), Arc::clone(&open));
            let count = Arc::strong_count(&open) - 1;
            // A thread that cannot be started drops the connection; the browser says so.
            let _ = std::thread::Builder::new().spawn(move || {
                let done = if count > MOST_CONNECTIONS {
                    http::refuse(&mut stream, HttpRefusal(503, "Too many questions at once."))
                } else {
                    site.connection(&mut stream)
                };
                // Who has gone does not wait for an answer.
                drop((done, taken));
            });
        }
    }

    fn connection(&self, stream: &mut TcpStream) -> std::io::Result<()> {
        let head = match http::head(stream) {
            Ok(Some(head)) => head,
            Ok(None) => return Ok(()),
            Err(refused) => return http::refuse(stream, refused),
        };
        let question = match self.allowed(&head) {
            Ok(None) => return http::answer(stream, "text/html", &self.page),
            Ok(Some(question)) => question,
            Err(refused) => return http::refuse(stream, refused),
        };
        let most = self.place.most_bytes().saturating_add(MOST_REQUEST as u64);
        let body = match http::body(stream, head, most) {
            Ok(body) => body,
            Err(refused) => return http::refuse(stream, refused),
        };
        let Some((request, file)) = split(&body) else {
            let why = "The first line of a question is its request.";
            return http::refuse(stream, HttpRefusal(400, why));
        };
        http::begin(stream, 200, "application/x-ndjson")?;
        self.ask(&question, request, file, stream);
        Ok(())
    }

    /// The question that is asked; none of the page itself. A page of another site can make a browser ask here, under our
    /// name or its own; it knows neither the secret, nor can it name our origin or send this type of content.
    fn allowed(&self, head: &Head) -> Result<Option<String>, HttpRefusal> {
        if head.host.as_deref() != Some(&self.host) {
            return Err(HttpRefusal(403, "This program answers to its own address only."));
        }
        let unknown = HttpRefusal(404, "There is nothing at this address.");
        let rest = head.path.strip_prefix('/').and_then(|path| path.split_once('/'));
        let (token, name) = rest.ok_or(unknown)?;
        if !same(token, &self.token) {
            return Err(unknown);
        }
        let is = |method| head.method == method;
        match name {
            "" if is("GET") => Ok(None),
            "" => Err(HttpRefusal(405, "The page can be read.")),
            _ => {
                let question = name.strip_prefix("ask/").ok_or(unknown)?;
                if !is("POST") {
                    return Err(HttpRefusal(405, "Questions are posted."));
                }
                if head.origin.as_deref() != Some(&self.origin) {
                    return Err(HttpRefusal(403, "Only the page of this program may ask."));
                }
                if head.content_type.as_deref() != Some("application/octet-stream") {
                    return Err(HttpRefusal(415, "A question is an octet-stream."));
                }
                Ok(Some(question.to_owned()))
            }
        }
    }

    /// Answers, and says in the terminal what a computation came to.
    fn ask(&self, question: &str, request: &str, file: &[u8], stream: &mut TcpStream) {
        let begun = Instant::now();
        let mut messages = Messages::new(stream);
        answer(question, request, file, self.place, &mut messages);
        let heard = messages.end();
        if question == "run" && !self.quiet {
            let seconds = begun.elapsed().as_secs_f64();
            match heard {
                Ok(()) => tell(&format!("computed in {seconds:.1} s")),
                Err(_) => tell(&format!("stopped after {seconds:.1} s: the page waits no longer")),
            }
        }
    }
}

/// The request, which is the first line, and the file behind it.
fn split(body: &[u8]) -> Option<(&str, &[u8])> {
    let end = body.iter().take(MOST_REQUEST).position(|&b| b == b'\n')?;
    Some((std::str::from_utf8(&body[..end]).ok()?, &body[end + 1..]))
}

/// Compares in a time that does not say where two secrets differ.
fn same(one: &str, other: &str) -> bool {
    let differ = one.bytes().zip(other.bytes()).fold(0, |differ, (a, b)| differ | (a ^ b));
    one.len() == other.len() && differ == 0
}
