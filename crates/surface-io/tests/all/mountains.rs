//! Documents of Mountains: what is not of the plain form is refused with the way out.

use crate::common::mountains::{contents, document, ole};
use crate::common::unaided;

fn refusal(file: &[u8]) -> String {
    unaided(file).expect_err("refused").to_string()
}

#[test]
fn what_is_not_plain_is_refused_with_the_way_out() {
    for (contents, words) in [
        (contents(9063, None, 306), "9063"),
        (contents(9062, Some([9, 23]), 306), "the mark 23"),
        (contents(9062, None, 307), "-100 to 306, the file says -100 to 307"),
    ] {
        for shift in [9, 12] {
            let error = refusal(&document(&contents, shift));
            assert!(error.contains(words) && error.contains("SUR"), "{error}");
        }
    }
    let changed = |from: &[u8], to: &[u8]| {
        let mut contents = contents(9062, Some([9, 22]), 306);
        let at = contents.windows(from.len()).position(|w| w == from).unwrap();
        contents[at..at + from.len()].copy_from_slice(to);
        refusal(&document(&contents, 9))
    };
    // A ratio that is not that of the units, a part of the points, another class of heights.
    let error = changed(&1000f64.to_le_bytes(), &999f64.to_le_bytes());
    assert!(error.contains("shown in 999 mm") && error.contains("SUR"), "{error}");
    let last = |n: u8| [3, 0, 4, 0, 0, 0, 0, 0, 0, 0, n, 0, 0, 0];
    let error = changed(&last(6), &last(5));
    assert!(error.contains("points 0 to 5 of 7") && error.contains("SUR"), "{error}");
    let error = changed(&9049u32.to_le_bytes(), &9050u32.to_le_bytes());
    assert!(error.contains("class 9050") && error.contains("SUR"), "{error}");
}

/// A spreadsheet is an OLE document too.
#[test]
fn other_compound_documents_have_their_own_message() {
    let error = refusal(&ole(&[("Workbook", b"x")], 9));
    assert!(error.contains("spreadsheet") && error.contains("CSV"), "{error}");
    let error = refusal(&ole(&[("WordDocument", &[1; 5000])], 9));
    assert!(error.contains("WordDocument") && error.contains("SUR"), "{error}");
}

/// Chains that bite their tails, in the table, the directory and the small sectors, end.
#[test]
fn chains_without_an_end_are_refused() {
    for shift in [9, 12] {
        let size = 1 << shift;
        let sound = document(&contents(9062, None, 306), shift);
        let mut file = sound.clone();
        file[size + 4..size + 8].copy_from_slice(&1u32.to_le_bytes());
        assert!(refusal(&file).contains("never end"), "{}", refusal(&file));
        let mut file = sound.clone();
        // The further list of table sectors: a sector that names itself last.
        let at = file.len() as u32 >> shift;
        file[68..72].copy_from_slice(&(at - 1).to_le_bytes());
        file.extend([0xff; 4096]);
        let end = (at as usize + 1) * size;
        file[end - 4..end].copy_from_slice(&(at - 1).to_le_bytes());
        assert!(refusal(&file).contains("sector table"), "{}", refusal(&file));
    }
    // The first sector of small ones follows itself: the stream is not what it was.
    let mut file = document(&contents(9062, None, 306), 9);
    let small = u32::from_le_bytes(file[60..64].try_into().unwrap());
    let at = (small as usize + 1) * 512 + 4;
    assert_eq!(file[at..at + 4], 2u32.to_le_bytes());
    file[at..at + 4].copy_from_slice(&1u32.to_le_bytes());
    assert!(refusal(&file).contains("SUR"), "{}", refusal(&file));
}
