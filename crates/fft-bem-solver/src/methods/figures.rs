//! Draws the fields of one chord iteration for the book:
//!
//! ```console
//! $ cargo test -p fft-bem-solver --lib -- --ignored draw_the_fields
//! ```
//! writes `docs/src/figures/chord-fields.png`; an ordinary test holds the committed file to what would
//! be drawn now.

use super::ceiling::{Elastic, Top};
use super::chord::{Chord, Kind, Known, Run};
use super::contract::{ContactMethod, Start, State, Target, Task};
use crate::HalfSpace;
use crate::problem::{self, Problem};
use contact_types::{ContactModulus, Grid, HeightMap};
use std::io::{Read, Write};
use std::ops::ControlFlow;

const N: usize = 96;
const ZOOM: usize = 3;
const MARGIN: usize = 12;

/// A few hills of several sizes, periodic.
fn surface() -> Problem<f64> {
    let grid = Grid::new([N, N], [1.0, 1.0]).unwrap();
    let q = std::f64::consts::TAU / N as f64;
    let map = HeightMap::from_fn(grid, |y, x| {
        let wave = |ky: f64, kx: f64, phase: f64| (q * (ky * y + kx * x) + phase).cos();
        wave(1.0, 2.0, 0.3)
            + wave(-2.0, 1.0, 1.0)
            + 0.6 * wave(3.0, 2.0, 2.0)
            + 0.35 * wave(-4.0, 5.0, 0.5)
            + 0.2 * wave(9.0, 4.0, 4.0)
            + 0.15 * wave(-6.0, 11.0, 1.0)
    })
    .unwrap();
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    Problem::new(&map, problem::scaled_grid(grid).unwrap(), modulus).unwrap()
}

const PICTURE: &str =
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/src/figures/chord-fields.png");
/// Side of a panel, width and height of the picture, in its pixels.
const SIDE: usize = N * ZOOM;
const WIDTH: usize = 3 * SIDE + 2 * MARGIN;
const HEIGHT: usize = 2 * SIDE + MARGIN;

#[test]
#[ignore = "writes docs/src/figures/chord-fields.png"]
fn draw_the_fields() {
    std::fs::write(PICTURE, png(&picture())).unwrap();
}

/// The sine and the rounding of another platform may move a colour by a level or two, and a pixel
/// that is about to lose contact to the other side.
#[test]
fn the_committed_picture_is_what_the_code_draws() {
    let (committed, drawn) = (pixels(&std::fs::read(PICTURE).unwrap()), picture());
    assert_eq!(committed.len(), drawn.len(), "another size");
    let differ = committed.iter().zip(&drawn).filter(|(a, b)| a.abs_diff(**b) > 2).count();
    assert!(
        differ < drawn.len() / 1000,
        "{differ} of {} colours differ; look at what `cargo xtask figures` draws",
        drawn.len()
    );
}

/// Six fields of one iteration, as red, green and blue.
fn picture() -> Vec<u8> {
    let problem = surface();
    let h = &problem.heights;
    let load = 0.008;
    let mut half_space = HalfSpace::new(problem.grid, ContactModulus::from_pascals(1.0).unwrap());
    let mut chord = Chord::<f64>::new(problem.grid);
    chord.force = Some(Kind::Chord); // the step after the first: with guesses little is left to see
    let mut state = State::new(N * N);
    let target = Target::Pressure(load);
    let task =
        Task { problem: &problem, target, ceiling: Top::NONE, tolerance: 1e-9, max_iterations: 1 };
    let mut watch = |_: &super::contract::Step<'_, f64>| ControlFlow::Continue(());
    chord.solve(&task, &mut half_space, Start::Cold, &mut state, &mut watch);

    // The passes of the next iteration, one by one.
    let p = state.pressure.clone();
    let mut run =
        Run::new(Elastic, &mut chord.work, &task, &mut half_space, Start::Warm, None, &mut state);
    let (_, found) = run.look(Known::Nothing, 0.0);
    let set = run.work.nodes.clone();
    let residual = run.work.residual.clone();
    let extended = run.work.pairs.spare().to_vec();
    run.precondition();
    run.make_trial(1.0, found);
    let shift = f64::from(run.work.sweep.shift);
    let made = &run.work.pairs.trial.pressure;
    let shifted = made.iter().zip(&set).map(|(p, m)| if m.is_in() { p + shift } else { *p });
    let trial: Vec<f32> = shifted.map(|p| p as f32).collect();
    let step: Vec<f32> = p.iter().zip(&trial).map(|(p, t)| *p as f32 - t).collect();
    run.sweep_trial(found, 1.0);
    assert!(run.end_trial(0.0).is_some());
    let swept: Vec<f32> = run.work.pairs.trial.pressure.iter().map(|p| *p as f32).collect();

    let heights: Vec<f32> = h.iter().map(|h| *h as f32).collect();
    let largest = |x: &[f32]| x.iter().fold(0.0_f32, |m, x| m.max(x.abs()));
    let (gap, pressure) = (largest(&extended), largest(&trial));
    // Signed fields: blue below, white at zero, red above; outside the contact set grey.
    let off = |x: &[f32], scale: f32| -> Vec<Option<f32>> {
        x.iter().zip(&set).map(|(x, m)| (m.is_in()).then_some(x / scale)).collect()
    };
    let all = |x: &[f32], scale: f32| x.iter().map(|x| Some(x / scale)).collect::<Vec<_>>();
    let centred: Vec<f32> = heights.iter().map(|h| h + 0.5).collect();
    let panels = [
        all(&centred, 0.5),
        off(&residual, gap),
        all(&extended, gap),
        off(&step, largest(&step)),
        all(&trial, 0.5 * pressure),
        all(&swept, 0.5 * pressure),
    ];
    compose(&panels)
}

/// Two rows of three panels.
fn compose(panels: &[Vec<Option<f32>>; 6]) -> Vec<u8> {
    let mut pixels = vec![255; 3 * WIDTH * HEIGHT];
    for (k, panel) in panels.iter().enumerate() {
        let (top, left) = (k / 3 * (SIDE + MARGIN), k % 3 * (SIDE + MARGIN));
        for y in 0..SIDE {
            for x in 0..SIDE {
                let value = panel[y / ZOOM * N + x / ZOOM];
                let at = 3 * ((top + y) * WIDTH + left + x);
                pixels[at..at + 3].copy_from_slice(&value.map_or([225; 3], colour));
            }
        }
    }
    pixels
}

/// Blue, white, red for -1, 0, 1.
fn colour(value: f32) -> [u8; 3] {
    let v = value.clamp(-1.0, 1.0);
    let mix = |end: f32| (255.0 + (end - 255.0) * v.abs().powf(0.7)) as u8;
    if v < 0.0 { [mix(33.0), mix(90.0), mix(172.0)] } else { [mix(178.0), mix(24.0), mix(43.0)] }
}

/// The picture as PNG (ISO/IEC 15948).
fn png(pixels: &[u8]) -> Vec<u8> {
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut chunk = |kind: &[u8; 4], data: &[u8]| {
        let mut crc = flate2::Crc::new();
        crc.update(kind);
        crc.update(data);
        file.extend((data.len() as u32).to_be_bytes());
        file.extend(kind);
        file.extend(data);
        file.extend(crc.sum().to_be_bytes());
    };
    let mut header = [(WIDTH as u32).to_be_bytes(), (HEIGHT as u32).to_be_bytes()].concat();
    header.extend([8, 2, 0, 0, 0]); // 8 bits, RGB
    chunk(b"IHDR", &header);
    let mut packed = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
    for row in pixels.chunks_exact(3 * WIDTH) {
        packed.write_all(&[0]).unwrap();
        packed.write_all(row).unwrap();
    }
    chunk(b"IDAT", &packed.finish().unwrap());
    chunk(b"IEND", &[]);
    file
}

/// The pixels of a PNG written by [`png`]: one chunk of data, whose rows begin with filter 0.
fn pixels(file: &[u8]) -> Vec<u8> {
    let data = 8 + 25; // behind the signature and the header
    let length = u32::from_be_bytes(file[data..data + 4].try_into().unwrap()) as usize;
    assert_eq!(&file[data + 4..data + 8], b"IDAT");
    let mut rows = Vec::new();
    let packed = &file[data + 8..data + 8 + length];
    flate2::read::ZlibDecoder::new(packed).read_to_end(&mut rows).unwrap();
    rows.chunks_exact(1 + 3 * WIDTH).flat_map(|row| row[1..].iter().copied()).collect()
}
