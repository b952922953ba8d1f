//! Documents of Mountains: what is not of the plain form is refused with the way out.

use crate::common::mountains::{contents, document, ole};
use crate::common::{assert_refused, replace, unaided};

#[test]
fn what_is_not_plain_is_refused_with_the_way_out() {
    for (contents, words) in [
        (contents(9063, None, 306), "9063"),
        (contents(9062, Some([9, 23]), 306), "the mark 23"),
        (contents(9062, None, 307), "-100 to 306, the file says -100 to 307"),
    ] {
        for shift in [9, 12] {
            assert_refused(unaided(document(&contents, shift)), &[words, "SUR"]);
        }
    }
    // A ratio that is not that of the units, a part of the points, another class of heights.
    let last = |n: u8| vec![3, 0, 4, 0, 0, 0, 0, 0, 0, 0, n, 0, 0, 0];
    let [thousand, fewer] = [1000f64, 999.0].map(|ratio| ratio.to_le_bytes().to_vec());
    let [class, other] = [9049u32, 9050].map(|class| class.to_le_bytes().to_vec());
    for (from, to, words) in [
        (thousand, fewer, "shown in 999 mm"),
        (last(6), last(5), "points 0 to 5 of 7"),
        (class, other, "class 9050"),
    ] {
        let mut contents = contents(9062, Some([9, 22]), 306);
        replace(&mut contents, &from, &to);
        assert_refused(unaided(document(&contents, 9)), &[words, "SUR"]);
    }
}

/// A spreadsheet is an OLE document too.
#[test]
fn other_compound_documents_have_their_own_message() {
    assert_refused(unaided(ole(&[("Workbook", b"x")], 9)), &["spreadsheet", "CSV"]);
    assert_refused(unaided(ole(&[("WordDocument", &[1; 5000])], 9)), &["WordDocument", "SUR"]);
}

/// Chains that bite their tails, in the table, the directory and the small sectors, end.
#[test]
fn chains_without_an_end_are_refused() {
    for shift in [9, 12] {
        let size = 1 << shift;
        let sound = document(&contents(9062, None, 306), shift);
        let mut file = sound.clone();
        file[size + 4..size + 8].copy_from_slice(&1u32.to_le_bytes());
        assert_refused(unaided(&file), &["never end"]);
        let mut file = sound.clone();
        // The further list of table sectors: a sector that names itself last.
        let at = file.len() as u32 >> shift;
        file[68..72].copy_from_slice(&(at - 1).to_le_bytes());
        file.extend([0xff; 4096]);
        let end = (at as usize + 1) * size;
        file[end - 4..end].copy_from_slice(&(at - 1).to_le_bytes());
        assert_refused(unaided(&file), &["sector table"]);
    }
    // The first sector of small ones follows itself: the stream is not what it was.
    let mut file = document(&contents(9062, None, 306), 9);
    let small = u32::from_le_bytes(file[60..64].try_into().unwrap());
    let at = (small as usize + 1) * 512 + 4;
    assert_eq!(file[at..at + 4], 2u32.to_le_bytes());
    file[at..at + 4].copy_from_slice(&1u32.to_le_bytes());
    assert_refused(unaided(&file), &["SUR"]);
}
