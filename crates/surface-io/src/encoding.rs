//! Text of a file, whatever its encoding and line ends.

use std::borrow::Cow;

/// The text of a file: UTF-8, UTF-16 with a byte order mark, or else Latin-1.
pub(crate) fn decode(bytes: &[u8]) -> Cow<'_, str> {
    match bytes {
        [0xff, 0xfe, rest @ ..] => Cow::Owned(utf16(rest, u16::from_le_bytes)),
        [0xfe, 0xff, rest @ ..] => Cow::Owned(utf16(rest, u16::from_be_bytes)),
        _ => {
            let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
            match std::str::from_utf8(bytes) {
                Ok(text) => Cow::Borrowed(text),
                Err(_) => Cow::Owned(latin1(bytes)),
            }
        }
    }
}

/// Text in UTF-16, of numbers in this order.
pub(crate) fn utf16(bytes: &[u8], order: fn([u8; 2]) -> u16) -> String {
    let units = bytes.chunks_exact(2).map(|pair| order([pair[0], pair[1]]));
    char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
}

pub(crate) fn latin1(bytes: &[u8]) -> String {
    bytes.iter().map(|&byte| char::from(byte)).collect()
}

/// True if `bytes` can be the start of a text file: no control characters in the first 4 KiB.
pub(crate) fn is_text(bytes: &[u8]) -> bool {
    let start = &bytes[..bytes.len().min(4096)];
    if start.starts_with(b"\xff\xfe") || start.starts_with(b"\xfe\xff") {
        return true;
    }
    start.iter().all(|&b| b >= 0x20 || matches!(b, b'\t' | b'\n' | b'\r' | 0x0c | 0x1a))
}

/// Lines with their numbers from 1. `\n`, `\r\n` and a lone `\r` end a line, also mixed.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let ended = text.split('\n').map(|line| line.strip_suffix('\r').unwrap_or(line));
    (1..).zip(ended.flat_map(|line| line.split('\r')))
}
