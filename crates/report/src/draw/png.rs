//! Pictures as text: 8-bit pixels, row-major from the upper left, to PNG to a `data:` address.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use png::{ColorType, Filter};

/// How hard deflate searches: the middle level, 6, takes three times as long for 3 % fewer bytes.
const EFFORT: png::DeflateCompression = png::DeflateCompression::Level(3);

/// Of red, green and blue, three bytes per pixel, or of grey, one.
pub(crate) fn shades(shape: [usize; 2], bytes: &[u8]) -> String {
    let is_grey = bytes.len() == shape[0] * shape[1];
    let colour = if is_grey { ColorType::Grayscale } else { ColorType::Rgb };
    address(shape, colour, Filter::Adaptive, bytes)
}

/// Of classes, whose neighbours are alike or not: no difference of theirs is shorter.
pub(crate) fn classes(shape: [usize; 2], bytes: &[u8]) -> String {
    address(shape, ColorType::Grayscale, Filter::NoFilter, bytes)
}

fn address([height, width]: [usize; 2], colour: ColorType, filter: Filter, bytes: &[u8]) -> String {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_color(colour);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_deflate_compression(EFFORT);
    encoder.set_filter(filter);
    let written = encoder.write_header().and_then(|mut out| out.write_image_data(bytes));
    written.expect("a picture has pixels, and as many bytes as they take");
    format!("data:image/png;base64,{}", STANDARD.encode(file))
}
