//! Ways in which numbers are packed. None returns more than it is asked for.

/// PackBits (TIFF 6.0, section 9): a count, then that many bytes, or one to be repeated.
pub(crate) fn packbits(packed: &[u8], most: usize) -> Option<Vec<u8>> {
    let (mut unpacked, mut at) = (Vec::new(), 0);
    while unpacked.len() < most && at < packed.len() {
        let count = packed[at].cast_signed();
        at += 1;
        if count >= 0 {
            let length = usize::from(count.cast_unsigned()) + 1;
            unpacked.extend_from_slice(packed.get(at..at + length)?);
            at += length;
        } else if count != i8::MIN {
            let length = usize::from(count.unsigned_abs()) + 1;
            unpacked.resize(unpacked.len() + length, *packed.get(at)?);
            at += 1;
        }
    }
    unpacked.truncate(most);
    Some(unpacked)
}

/// LZW as TIFF has it (TIFF 6.0, section 13): codes of 9 to 12 bits, highest bit first, 256 clears
/// the table, 257 ends; the width grows one code early.
pub(crate) fn lzw(packed: &[u8], most: usize) -> Option<Vec<u8>> {
    const CLEAR: usize = 256;
    const END: usize = 257;
    let mut unpacked = Vec::new();
    // A string of the table is a piece of what was unpacked: start and length.
    let mut table: Vec<(usize, usize)> = Vec::new();
    let (mut width, mut previous) = (9, None::<(usize, usize)>);
    let (mut bits, mut held, mut next) = (0u32, 0u32, packed.iter());
    while unpacked.len() < most {
        while held < width {
            let Some(&byte) = next.next() else { return Some(unpacked) };
            bits = bits << 8 | u32::from(byte);
            held += 8;
        }
        held -= width;
        let code = (bits >> held & ((1 << width) - 1)) as usize;
        let start = unpacked.len();
        match (code, previous) {
            (END, _) => break,
            (CLEAR, _) => {
                table.clear();
                (width, previous) = (9, None);
                continue;
            }
            (0..256, _) => unpacked.push(code as u8),
            (_, Some(before)) => {
                // The code after the last one is the string before with its own first byte.
                let (from, length) = table
                    .get(code - 258)
                    .copied()
                    .or((code - 258 == table.len()).then_some((before.0, before.1 + 1)))?;
                for i in 0..length {
                    let byte = *unpacked.get(from + i)?;
                    unpacked.push(byte);
                }
            }
            (_, None) => return None,
        }
        if let Some((from, length)) = previous {
            // The string before and the first byte of this one stand side by side already.
            table.push((from, length + 1));
            width = (table.len() + 259).ilog2().clamp(8, 11) + 1;
            if table.len() > 4096 - 258 {
                return None;
            }
        }
        previous = Some((start, unpacked.len() - start));
    }
    unpacked.truncate(most);
    Some(unpacked)
}

/// At most `most` bytes of what a reader gives; `what` is packed so.
#[cfg(feature = "zip")]
pub(crate) fn read(what: &str, from: impl std::io::Read, most: u64) -> Result<Vec<u8>, String> {
    use std::io::Read as _;
    let mut unpacked = Vec::new();
    from.take(most).read_to_end(&mut unpacked).map_err(|e| format!("{what}{e}"))?;
    Ok(unpacked)
}

/// A zlib stream, at most `most` bytes of it.
#[cfg(feature = "zip")]
pub(crate) fn zlib(packed: &[u8], most: usize) -> Result<Vec<u8>, String> {
    read("deflate: ", flate2::read::ZlibDecoder::new(packed), most as u64)
}

#[cfg(not(feature = "zip"))]
pub(crate) fn zlib(_: &[u8], _: usize) -> Result<Vec<u8>, String> {
    Err("deflate needs the feature `zip`".into())
}

/// Zstandard frames, at most `most` bytes of what they hold.
#[cfg(feature = "zip")]
pub(crate) fn zstd(packed: &[u8], most: u64) -> Result<Vec<u8>, String> {
    let frames = ruzstd::decoding::StreamingDecoder::new(packed);
    read("zstd: ", frames.map_err(|e| format!("zstd: {e}"))?, most)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The example of TIFF 6.0, section 9.
    #[test]
    fn packbits_of_the_specification() {
        let packed = [
            0xfe, 0xaa, 0x02, 0x80, 0x00, 0x2a, 0xfd, 0xaa, 0x03, 0x80, 0x00, 0x2a, 0x22, 0xf7,
            0xaa,
        ];
        let mut expected = vec![
            0xaa, 0xaa, 0xaa, 0x80, 0x00, 0x2a, 0xaa, 0xaa, 0xaa, 0xaa, 0x80, 0x00, 0x2a, 0x22,
        ];
        expected.extend([0xaa; 10]);
        assert_eq!(packbits(&packed, 100).unwrap(), expected);
        assert_eq!(packbits(&packed, 5).unwrap().len(), 5);
        assert_eq!(packbits(&packed[..4], 100), None);
    }

    /// The example of TIFF 6.0, section 13: 7 7 7 8 8 7 7 6 6.
    #[test]
    fn lzw_of_the_specification() {
        let codes: [usize; 9] = [256, 7, 258, 8, 8, 258, 6, 6, 257];
        let bits: Vec<usize> =
            codes.iter().flat_map(|code| (0..9).rev().map(move |i| code >> i & 1)).collect();
        let packed = bytes(&bits);
        assert_eq!(lzw(&packed, 100).unwrap(), [7, 7, 7, 8, 8, 7, 7, 6, 6]);
        assert_eq!(lzw(&packed, 4).unwrap(), [7, 7, 7, 8]);
    }

    /// Codes as they come, through all widths and a full table, beside the strings that the definition gives.
    #[test]
    fn lzw_through_all_widths() {
        let (mut bits, mut data) = (Vec::new(), Vec::<u8>::new());
        let (mut table, mut previous) = (Vec::<Vec<u8>>::new(), Vec::new());
        for i in 0..9_000usize {
            let width = [511, 1023, 2047].iter().filter(|last| table.len() + 258 >= **last).count();
            // A string of the table now and then, the newest ones too, else a byte.
            let known = i * i / 7 % (table.len() + 1);
            let (code, string) = match table.get(known).filter(|string| string.len() < 99) {
                _ if i % 3_839 == 0 => (256, Vec::new()),
                Some(string) if i % 3 == 0 => (258 + known, string.clone()),
                _ => (i * 31 % 251, vec![(i * 31 % 251) as u8]),
            };
            bits.extend((0..9 + width).rev().map(|bit| code >> bit & 1));
            if code == 256 {
                table.clear();
            } else if !previous.is_empty() {
                table.push([&previous[..], &string[..1]].concat());
            }
            data.extend(&string);
            previous = string;
        }
        assert_eq!(lzw(&bytes(&bits), data.len()).unwrap(), data);
    }

    /// Bits, the highest of a byte first.
    fn bytes(bits: &[usize]) -> Vec<u8> {
        let byte =
            |bits: &[usize]| bits.iter().enumerate().map(|(i, bit)| bit << (7 - i)).sum::<usize>();
        bits.chunks(8).map(|bits| byte(bits) as u8).collect()
    }
}
