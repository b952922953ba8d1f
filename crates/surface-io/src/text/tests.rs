//! Encodings, separators, headers and the ends of tables.

use super::*;

fn table(text: &str) -> NumberTable<'_> {
    NumberTable::parse(text).unwrap()
}

#[test]
fn separators_and_decimal_marks() {
    for text in [
        "1.5 2\n3 4.25\n",
        "1.5\t2\r\n3\t4.25",
        "1.5,2\n3,4.25",
        "1,5;2\n3;4,25",
        "1,5 2\n3 4,25",
        "  1.5,   2\n  3,   4.25\n",
        "1.5;2;\n3;4.25;\n",
        "1.5 2\r3 4.25\r\n\r\n",
    ] {
        let t = table(text);
        assert_eq!((t.columns, &t.values[..]), (2, &[1.5, 2.0, 3.0, 4.25][..]), "{text:?}");
    }
}

#[test]
fn missing_cells_keep_their_place() {
    let t = table(";;;\n1;;NaN;\n2;3;4;\n");
    assert_eq!((t.rows(), t.columns), (3, 3)); // the last separator is no column
    assert_eq!(t.values.iter().filter(|v| v.is_nan()).count(), 5);
    assert_eq!(table("1\t\t3\n4\t5\t6\n").values.len(), 6);
}

#[test]
fn a_border_of_missing_points_is_kept() {
    assert_eq!(table("1;;\n2;;\n").columns, 3);
    assert_eq!(table("1;2;;\n2;3;;\n").columns, 2);
}

#[test]
fn header_ends_where_two_rows_agree() {
    let t = table("Title 5\n23\num um\n1 2\n3 4\n");
    assert_eq!(t.header.len(), 3);
    assert_eq!(t.rows(), 2);
}

/// Found with a real file: rows before a bad one vanished without a word.
#[test]
fn a_bad_row_at_the_start_is_no_header() {
    for (text, line) in [
        ("1 2 x3 4\n5 6 7 8\n9 1 2 3\n", "line 1"),
        ("1 2 3 4\n5 6 7,,1 8\n9 1 2 3\n4 5 6 7\n", "line 2"),
        ("# map\n1 2 3 4\n@ @ @ @\n9 1 2 3\n4 5 6 7\n", "line 2"),
        ("1 2 3 4 5\n5 6 7 8\n9 1 2 3\n", "line 1"),
        ("0 0 1\n0.l 1 2\n1 0 3\n1 1 4\n", "line 2"),
        ("0.1;1.O\n0.2;2\n0.3;3\n", "line 1"),
    ] {
        let error = NumberTable::parse(text).unwrap_err().to_string();
        assert!(error.contains(line), "{text:?}: {error}");
    }
    for text in ["Points 5 7\n1 2 3\n4 5 6\n", "5 7\na b\n1 2\n3 4\n", "1 um\n1 2\n3 4\n"] {
        assert_eq!(table(text).rows(), 2, "{text:?}");
    }
}

#[test]
fn counts_before_the_rows_are_header() {
    let t = table("title\n3\n2\n1 2 3\n4 5 6\n");
    assert_eq!((t.header.len(), t.columns, t.rows()), (3, 3, 2));
    assert_eq!(table("1\n2\n3\n").columns, 1);
}

#[test]
fn wrong_rows_name_their_line() {
    for (text, line) in [("1 2\n3 4\n5\n", "line 3"), ("1 2\n\n3 4\n5 x\n", "line 4")] {
        let e = NumberTable::parse(text).unwrap_err().to_string();
        assert!(e.contains(line), "{e}");
    }
}

#[test]
fn mixed_decimal_marks_are_refused() {
    assert!(NumberTable::parse("1,5;2.5\n1;2\n").is_err());
}

#[test]
fn encodings() {
    let utf16: Vec<u8> = "\u{feff}1 \u{b5}m".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(decode(&utf16), "1 \u{b5}m");
    assert_eq!(decode(b"1 \xb5m"), "1 \u{b5}m");
    assert_eq!(decode("\u{feff}1 \u{b5}m".as_bytes()), "1 \u{b5}m");
}

#[test]
fn printed_precision() {
    for (texts, largest, quantum) in [
        (&["0.0", "0.2", "1499.8"][..], 1499.8, 0.1),
        (&["4", "4.5", "9"], 9.0, 0.1),
        (&["1.6655563e-08", "4.997e-05"], 4.997e-5, 1e-12),
        (&["12", "7"], 12.0, 1.0),
    ] {
        let mut digits = Digits::NONE;
        for text in texts {
            digits.add(text);
        }
        assert!((digits.quantum(largest) / quantum - 1.0).abs() < 1e-9, "{texts:?}");
    }
}
