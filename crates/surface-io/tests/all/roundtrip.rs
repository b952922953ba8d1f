//! Written and read back: the same bits.

use crate::common::binary::complete_map;
use crate::common::{SayMore as _, scaled, unaided};
use contact_types::{Grid, HeightMap};
use proptest::prelude::*;
use std::io::Cursor;
use surface_io::{Fill, HeightUnit, Measurement, ReadOptions, read_bytes, write};

fn x3p(map: &HeightMap) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    write::x3p(&mut file, map, "round <trip> & \"more\"").expect("memory takes it");
    file.into_inner()
}

#[test]
fn comment_and_instrument_come_back() {
    let found = unaided(x3p(&complete_map())).unwrap();
    assert_eq!(found.metadata["Comment"], "round <trip> & \"more\"");
    assert_eq!(found.metadata["Instrument/Model"], "surface-io");
    assert_eq!(x3p(&complete_map()), x3p(&complete_map()));
}

#[test]
fn npy_data_start_is_aligned() {
    let mut file = Vec::new();
    write::npy(&mut file, [5, 7], complete_map().heights()).unwrap();
    assert_eq!((file.len() - 35 * 8) % 64, 0);
    assert!(write::npy(&mut file, [2, 3], &[0.0; 5]).is_err());
}

#[test]
fn heights_of_a_program_are_those_of_an_array_file() {
    for shape in [[5, 7], [1, 35]] {
        let grid = Grid::new(shape, [1e-6; 2]).unwrap();
        let mut heights = complete_map().into_heights();
        heights[11] = f64::NAN;
        let mut file = Vec::new();
        write::npy(&mut file, shape, &heights).unwrap();
        let mut options = ReadOptions::default();
        (options.pixel, options.height_unit) = (Some([1e-6; 2]), Some(HeightUnit::Always(1.0)));
        let (read, made) = (read_bytes(&file, &options).unwrap(), Measurement::new(grid, heights));
        let made = made.unwrap();
        assert_eq!((made.grid(), made.missing()), (read.grid(), 1));
        assert_eq!(made.is_profile(), read.is_profile());
        assert_eq!(made.fill(Fill::Nearest).unwrap(), read.fill(Fill::Nearest).unwrap());
    }
    let infinite = vec![f64::INFINITY; 35];
    assert!(Measurement::new(complete_map().grid(), infinite).is_err());
}

#[test]
fn sdf_refuses_more_points_than_it_can_count() {
    let grid = Grid::new([1, 65536], [1e-6, 1e-6]).unwrap();
    let map = HeightMap::new(grid, vec![0.0; 65536]).unwrap();
    let error = write::sdf(&mut Vec::new(), &map).unwrap_err();
    assert!(error.to_string().contains("65535"), "{error}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn same_bits(
        ny in 1usize..9, nx in 2usize..9, dy in 1e-10..1e-2f64, dx in 1e-10..1e-2f64,
        offset in -1.0..1.0f64, seed in proptest::collection::vec(-1e-3..1e-3f64, 64),
    ) {
        let grid = Grid::new([ny, nx], [dy, dx]).unwrap();
        let heights: Vec<f64> = (0..ny * nx).map(|i| offset + seed[i]).collect();
        let map = HeightMap::new(grid, heights).unwrap();
        let back = unaided(x3p(&map)).unwrap();
        prop_assert_eq!(&back.fill(Fill::Refuse).unwrap(), &map);
        let mut file = Vec::new();
        write::sdf(&mut file, &map).unwrap();
        let back = unaided(&file).unwrap();
        prop_assert_eq!(&back.fill(Fill::Refuse).unwrap(), &map);
        file.clear();
        write::npy(&mut file, [ny, nx], map.heights()).unwrap();
        let options = scaled(1.0, 1.0).and(|o| o.pixel = Some([dy, dx]));
        let back = read_bytes(&file, &options).unwrap();
        prop_assert_eq!(&back.fill(Fill::Refuse).unwrap(), &map);
    }
}
