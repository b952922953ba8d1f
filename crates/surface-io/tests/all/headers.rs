//! What the headers of texts say of sizes, scales and units.

use crate::common::{assert_refused, unaided};

/// 2 rows of 4 heights.
const ROWS: &str = "1 2 3 4\n5 6 7 8\n";

/// `[dy, dx]` and the last height in pm.
fn picometres(text: &str) -> [i64; 3] {
    let found = unaided(text).unwrap_or_else(|e| panic!("{text}: {e}"));
    let [dy, dx] = found.grid().pixel();
    let last = found.heights().last().copied().unwrap();
    [dy, dx, last].map(|metres| (metres * 1e12).round() as i64)
}

/// Gwyddion translates the keys of its export; those of XYZ have the unit of x and y.
#[test]
fn gwyddion_in_its_languages() {
    for [channel, width, height, unit] in [
        ["Channel:", "Width:", "Height:", "Value units:"],
        ["Kanál:", "Šířka:", "Výška:", "Jednotky hodnot:"],
        ["Kanal:", "Breite:", "Höhe:", "Einheiten:"],
        ["Kanal:", "Breite:", "Höhe:", "Werteinheiten:"],
        ["Canal :", "Largeur :", "Hauteur :", "Unités :"],
        ["Canale:", "Larghezza:", "Altezza:", "unità valore:"],
        ["Canal:", "Anchura:", "Altura:", "Unidades de valor:"],
        ["Canal:", "Largura:", "Altura:", "Unidades de valor:"],
        ["チャネル：", "幅:", "高さ：", "値の単位:"],
        ["채널:", "폭:", "높이:", "값 단위:"],
        ["Канал:", "Ширина:", "Высота:", "Единицы измерения:"],
    ] {
        let head = format!("# {channel} Topo\n# {width} 8.0 µm\n# {height} 3.0 µm\n# {unit} nm\n");
        let text = format!("{head}{ROWS}");
        assert_eq!(picometres(&text), [1_500_000, 2_000_000, 8_000], "{head}");
        assert_eq!(unaided(&text).unwrap().channel, "Topo");
    }
    for key in ["Lateral units:", "Laterale Einheiten:", "Unités latérales :"] {
        let text =
            format!("# Channel: Topo\n# {key} um\n# Value units: nm\n0 0 1\n2 0 2\n0 3 3\n2 3 4\n");
        assert_eq!(picometres(&text), [3_000_000, 2_000_000, 4_000], "{key}");
        assert!(unaided(&text).unwrap().ambiguity.is_none());
    }
}

/// SPIP: lengths in nm if no unit says other, `Bit2nm` if no unit of heights does. Nova: factor
/// and offset if it says that they are needed.
#[test]
fn spip_and_nova() {
    let spip = "# File Format = ASCII\n# x-pixels = 4\n# y-pixels = 2\n# x-length = 2000\n\
                # y-length = 500\n";
    for (more, right) in [
        ("# Bit2nm = 0.5\n", [250_000, 500_000, 4_000]),
        ("# z-unit = um\n", [250_000, 500_000, 8_000_000]),
        ("# z-unit = um\n# Bit2nm = 0.5\n", [250_000, 500_000, 8_000_000]),
        ("# x-unit = um\n# y-unit = nm\n# z-unit = nm\n", [250_000, 500_000_000, 8_000]),
    ] {
        assert_eq!(picometres(&format!("{spip}{more}# Start of Data:\n{ROWS}")), right, "{more}");
    }
    let factor = "# x-length = 2000\n# y-length = 2000\n# x-unit = nm\n# y-unit = nm\n\
                  # height conversion factor (-> m)=2.5e-008\n";
    let found = unaided(format!("{factor}{ROWS}")).unwrap();
    assert!((found.heights()[7] / 2e-7 - 1.0).abs() < 1e-12);
    assert_eq!(picometres(&format!("{factor}{ROWS}")), [1_000_000, 500_000, 200_000]);
    let masked = "# Bit2nm = 1\n# voidpixels = 1\n# Start of Data:\n";
    let found = unaided(format!("{spip}{masked}{ROWS}1 1 1 1\n1 0 1 1\n")).unwrap();
    assert_eq!((found.grid().shape(), found.missing()), ([2, 4], 1));
    assert!(found.heights()[5].is_nan());
    let nova = "File Format = ASCII\nCreated by Nova\nNX = 4\nNY = 2\nScale X = 0.5\n\
                Scale Y = -0.25\nUnit X = um\nUnit Data = nm\nScale Data = 0.1\nBias Data = 2\n";
    for (needed, last) in [("yes", 2_800), ("Yes", 2_800), ("no", 8_000)] {
        let text = format!("{nova}DataScaleNeeded = {needed}\nStart of Data :\n{ROWS}");
        assert_eq!(picometres(&text), [250_000, 500_000, last], "{needed}");
    }
}

/// Also with semicolons, decimal commas and in other languages.
#[test]
fn keyence() {
    let english = "\"Measured date\",\"2025-12-10 12:00:00\"\n\"Data type\",\"ImageDataCsv\"\n\
                   \"XY Calibration\",\"277.5\",\"nm\"\n\"Output image data\",\"Height\"\n\
                   \"Horizontal\",\"4\"\n\"Unit\",\"um\"\n\"Reference data name\",\"\"\n\n\
                   \"Height\"\n\"1\",\"2\",\"3\",\"4.5\"\n\"5\",\"6\",\"7\",\"8.25\"\n";
    assert_eq!(picometres(english), [277_500, 277_500, 8_250_000]);
    assert_eq!(unaided(english).unwrap().channel, "Height");
    let german = "\"Data type\";\"ImageDataCsv\"\n\"XY-Kalibrierung\";\"277,5\";\"nm\"\n\
                  \"Einheit\";\"um\"\n\"1\";\"2\";\"3\";\"4,5\"\n\"5\";\"6\";\"7\";\"8,25\"\n";
    assert_eq!(picometres(german), [277_500, 277_500, 8_250_000]);
}

/// What looks like a size, a scale or a unit; in a refusal and with what was read.
#[test]
fn what_is_not_used_is_named() {
    let text = format!("# Sampling = 0.5 um\n# Z calibration: 2.5\n# Speed: 3\n{ROWS}");
    assert_refused(unaided(&text), &["Sampling = 0.5 um; Z calibration = 2.5,"]);
    let text = format!("# Width: 8\n# Height: 2\n# Value units: nm\n{ROWS}");
    assert_refused(unaided(&text), &["Width = 8"]);
    let text = format!("# pixel size: 1 um\n# z unit: nm\n# z calibration: 2.5\n{ROWS}");
    // Thousands where the numbers say so; a mark that can be either is not used. A compound unit is none.
    let thousands = "# pixel size: 1,250 nm\n# z unit: nm\n";
    assert_eq!(picometres(&format!("{thousands}{}", ROWS.replace('8', "8.5")))[0], 1_250_000);
    assert_eq!(picometres(&format!("{thousands}{}", ROWS.replace('8', "8,5")))[0], 1_250);
    assert_refused(unaided(format!("{thousands}{ROWS}")), &["pixel size = 1,250 nm"]);
    assert_refused(
        unaided("x [um];y [um];z [nm/m]\n0;0;1\n1;0;2\n0;1;3\n1;1;4\n"),
        &["no height unit"],
    );
    for (text, said) in [(&text, Some("z calibration = 2.5")), (&text.replace("2.5", "none"), None)]
    {
        let found = unaided(text).unwrap();
        let unused = found.metadata.get("sizes, scales and units not used");
        assert_eq!(unused.map(String::as_str), said);
    }
}

/// A line with a value gives columns neither names nor units, and does not take those of the titles.
#[test]
fn values_are_no_titles() {
    let [profile, pair, list] = ["1\n4\n2", "0,1\n1,4\n2,2", "0,0,1\n1,0,2\n0,1,3\n1,1,4"];
    for (rows, dx, heads) in [
        (profile, None, "@|@Cutoff: 0.8 mm\n|@Lateral unit: mm\n"),
        (profile, Some(500_000), "Height [nm]\n@|Height: nm\n@|Data unit: nm\n@"),
        (profile, Some(500_000), "@Unit: nm\nFilter 2,5 um\nCutoff 8 mm\n"),
        (
            pair,
            Some(1_000_000),
            "x um,z nm\nLc 0.8 mm, Lt 4.8 mm\n|x: um,z1 nm\n|x um,trace 1 (nm)\n",
        ),
        (pair, Some(1_000_000), "Position (um),Height (nm)\nfrom 1 mm,to 2 [mm]\n"),
        (pair, None, "Start: 1 mm, Stop: 2 mm\n|Filter 2.5 um,Cutoff 0.8 (mm)\n"),
        (list, None, "Lens 50x,WD 3 mm,FOV 0.28 mm\n"),
    ] {
        for head in heads.replace('@', "Spacing: 0.5 µm\n").split('|') {
            let text = format!("{head}{rows}\n");
            match dx {
                Some(dx) => assert_eq!(picometres(&text)[1..], [dx, 2_000], "{text}"),
                None => assert_refused(unaided(&text), &["no height unit"]),
            }
        }
    }
}
