//! The page and its questions over the loopback address: who may ask, and what is answered.

use crate::http::{self, Head, HttpRefusal};
use crate::outcome::tell;
use contact_web::{Host, Messages, answer, page_of_program};
use std::net::{TcpListener, TcpStream};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Connections at the same time. A browser opens six.
const MOST_CONNECTIONS: usize = 16;

/// Between a connection that could not be taken and the next.
const AGAIN: Duration = Duration::from_millis(20);

/// Most bytes of a request, which comes before the file.
const MOST_REQUEST: usize = 1 << 20;

/// Who may ask, and what is served.
pub(crate) struct Site {
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
    pub(crate) fn new(port: u16, token: String, threads: usize, quiet: bool) -> Self {
        let place = Host::machine(threads);
        let host = format!("127.0.0.1:{port}");
        let origin = format!("http://{host}");
        Self { host, origin, token, place, page: page_of_program(place), quiet }
    }

    pub(crate) fn address(&self) -> String {
        format!("{}/{}/", self.origin, self.token)
    }

    /// Answers until the program is ended. What keeps a connection from being taken passes: the other side has gone, or
    /// there are too many open files until others time out.
    pub(crate) fn serve(self, listener: &TcpListener) -> ! {
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
