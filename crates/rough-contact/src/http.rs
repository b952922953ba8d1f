//! As much of HTTP/1.1 as one page on this machine needs: one question for each connection, its length before it.

use std::io::{ErrorKind, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::time::{Duration, Instant};

/// Most bytes before the body.
const MOST_HEAD: usize = 16 << 10;

/// Most lines before the body.
const MOST_HEADERS: usize = 64;

/// What comes before the body has to be there within this time.
const HEAD_WITHIN: Duration = Duration::from_secs(10);

/// A body may pause, and a reader may keep us waiting, for this long.
const PAUSE: Duration = Duration::from_secs(60);

/// A refused body is listened to for this long, so that its sender reads why before the connection breaks.
const LINGER: Duration = Duration::from_millis(300);

#[derive(Debug)]
pub(crate) struct Head {
    pub(crate) method: String,
    pub(crate) path: String,
    pub(crate) host: Option<String>,
    pub(crate) origin: Option<String>,
    pub(crate) content_type: Option<String>,
    pub(crate) length: Option<u64>,
    /// What came with it of the body.
    rest: Vec<u8>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct HttpRefusal(pub(crate) u16, pub(crate) &'static str);

const MALFORMED: HttpRefusal = HttpRefusal(400, "This is not a question in HTTP/1.1.");

/// What comes before the body; nothing if nothing came. Browsers open connections that they may need, and would take a
/// refusal for the answer to what they ask next.
pub(crate) fn head(stream: &mut TcpStream) -> Result<Option<Head>, HttpRefusal> {
    let late = HttpRefusal(408, "The question took too long to come.");
    let end = Instant::now() + HEAD_WITHIN;
    let mut bytes = Vec::new();
    loop {
        if let Some(head) = parse(&bytes)? {
            return Ok(Some(head));
        }
        if bytes.len() >= MOST_HEAD {
            return Err(HttpRefusal(431, "The question has too long a head."));
        }
        let mut piece = [0; 4096];
        match read_until(stream, end, &mut piece) {
            Err(e) if e.kind() == ErrorKind::Interrupted => {}
            Ok(0) | Err(_) if bytes.is_empty() => return Ok(None),
            Ok(0) => return Err(MALFORMED),
            Ok(count) => bytes.extend_from_slice(&piece[..count]),
            Err(_) => return Err(late),
        }
    }
}

/// Reads what comes before `end`.
fn read_until(stream: &mut TcpStream, end: Instant, into: &mut [u8]) -> std::io::Result<usize> {
    let left = end.saturating_duration_since(Instant::now());
    // Refuses a time of nothing.
    stream.set_read_timeout(Some(left))?;
    stream.read(into)
}

/// The head, if it is complete.
fn parse(bytes: &[u8]) -> Result<Option<Head>, HttpRefusal> {
    let mut headers = [httparse::EMPTY_HEADER; MOST_HEADERS];
    let mut request = httparse::Request::new(&mut headers);
    let end = match request.parse(bytes) {
        Ok(httparse::Status::Complete(end)) => end,
        Ok(httparse::Status::Partial) => return Ok(None),
        Err(httparse::Error::TooManyHeaders) => {
            return Err(HttpRefusal(431, "The question has too many headers."));
        }
        Err(_) => return Err(MALFORMED),
    };
    // A header that is said twice could mean one thing to us and another to who let it through.
    let once = |name: &str| {
        let mut found = request.headers.iter().filter(|h| h.name.eq_ignore_ascii_case(name));
        match (found.next(), found.next()) {
            (None, _) => Ok(None),
            (Some(header), None) => {
                let text = std::str::from_utf8(header.value).map_err(|_| MALFORMED)?;
                Ok(Some(text.trim().to_owned()))
            }
            (Some(_), Some(_)) => Err(HttpRefusal(400, "The question says a header twice.")),
        }
    };
    if once("transfer-encoding")?.is_some() {
        return Err(HttpRefusal(501, "A body has to say its length."));
    }
    let length = match once("content-length")? {
        None => None,
        Some(digits) if digits.bytes().all(|b| b.is_ascii_digit()) => {
            Some(digits.parse().map_err(|_| MALFORMED)?)
        }
        Some(_) => return Err(MALFORMED),
    };
    Ok(Some(Head {
        method: request.method.unwrap_or_default().to_owned(),
        path: request.path.unwrap_or_default().to_owned(),
        host: once("host")?,
        origin: once("origin")?,
        content_type: once("content-type")?,
        length,
        rest: bytes[end..].to_vec(),
    }))
}

/// The body, of the length announced and of at most `most` bytes. No memory is taken for what is only announced.
pub(crate) fn body(stream: &mut TcpStream, head: Head, most: u64) -> Result<Vec<u8>, HttpRefusal> {
    let length = head.length.ok_or(HttpRefusal(411, "A body has to say its length."))?;
    if length > most {
        return Err(HttpRefusal(413, "The file is larger than the program takes."));
    }
    let mut body = head.rest;
    let cut = HttpRefusal(400, "The body does not have the length that was announced.");
    let missing = length.checked_sub(body.len() as u64).ok_or(cut)?;
    stream.set_read_timeout(Some(PAUSE)).map_err(|_| cut)?;
    stream.take(missing).read_to_end(&mut body).map_err(|_| cut)?;
    if body.len() as u64 == length { Ok(body) } else { Err(cut) }
}

/// Begins an answer, whose body ends with the connection. Nothing of it is kept, guessed at or shown inside another page.
pub(crate) fn begin(stream: &mut TcpStream, status: u16, content: &str) -> std::io::Result<()> {
    stream.set_write_timeout(Some(PAUSE))?;
    stream.set_nodelay(true)?;
    let head = format!(
        "HTTP/1.1 {status} \r\nContent-Type: {content}; charset=utf-8\r\nConnection: close\r\nCache-Control: no-store\r\n\
         X-Content-Type-Options: nosniff\r\nReferrer-Policy: same-origin\r\nCross-Origin-Resource-Policy: same-origin\r\n\
         Cross-Origin-Opener-Policy: same-origin\r\n\
         Content-Security-Policy: frame-ancestors 'none'; base-uri 'none'; form-action 'none'\r\n\r\n"
    );
    stream.write_all(head.as_bytes())
}

pub(crate) fn answer(stream: &mut TcpStream, content: &str, text: &str) -> std::io::Result<()> {
    begin(stream, 200, content)?;
    stream.write_all(text.as_bytes())
}

/// Says why there is none. Who still sends is heard for a moment: an unread rest would break the connection before the
/// reason is read.
pub(crate) fn refuse(
    stream: &mut TcpStream,
    HttpRefusal(status, why): HttpRefusal,
) -> std::io::Result<()> {
    begin(stream, status, "text/plain")?;
    stream.write_all(why.as_bytes())?;
    stream.shutdown(Shutdown::Write)?;
    let end = Instant::now() + LINGER;
    let mut ignored = [0; 1 << 12];
    while read_until(stream, end, &mut ignored).is_ok_and(|count| count > 0) {}
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_head_is_read_when_it_is_complete() {
        let text = b"POST /x HTTP/1.1\r\nHost: a:1\r\nContent-Length: 3\r\n\r\nab";
        for end in 0..text.len() - 2 {
            assert!(matches!(parse(&text[..end]), Ok(None)), "{end}");
        }
        let head = parse(text).unwrap().unwrap();
        let (method, path) = (head.method.as_str(), head.path.as_str());
        assert_eq!((method, path, head.length), ("POST", "/x", Some(3)));
        assert_eq!((head.host.as_deref(), head.rest.as_slice()), (Some("a:1"), &b"ab"[..]));
    }
}
