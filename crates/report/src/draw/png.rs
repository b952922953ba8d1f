//! Pictures as text: RGB pixels to PNG to a `data:` address.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

/// Fields: neighbours differ little.
const FIELD: png::Filter = png::Filter::Adaptive;

/// Few classes, mostly none.
const CLASSES: png::Filter = png::Filter::NoFilter;

/// How hard deflate searches: on the pictures of a page the middle level, 6, takes three times as long for 3 % fewer
/// bytes.
const EFFORT: png::DeflateCompression = png::DeflateCompression::Level(3);

/// An 8-bit RGB picture, row-major from the upper left.
#[derive(Debug, Clone)]
pub struct Picture {
    pub(crate) width: usize,
    pub(crate) height: usize,
    /// Three bytes per pixel.
    pub(crate) rgb: Vec<u8>,
}

impl Picture {
    /// The PNG file.
    pub(crate) fn png(&self) -> Result<Vec<u8>, png::EncodingError> {
        encoded([self.width, self.height], png::ColorType::Rgb, FIELD, &self.rgb)
    }

    /// `data:image/png;base64,…`.
    ///
    /// # Errors
    /// If the number of bytes does not fit the size.
    pub fn data_address(&self) -> Result<String, png::EncodingError> {
        Ok(address(&self.png()?))
    }
}

/// An 8-bit grey picture, row-major from the upper left.
#[derive(Debug, Clone)]
pub(crate) struct Grey {
    pub(crate) width: usize,
    pub(crate) height: usize,
    /// One byte per pixel.
    pub(crate) values: Vec<u8>,
}

impl Grey {
    /// `data:image/png;base64,…`.
    pub(crate) fn data_address(&self) -> Result<String, png::EncodingError> {
        self.address(FIELD)
    }

    /// The same of classes, whose neighbours are alike or not: no difference of theirs is shorter.
    pub(crate) fn data_address_of_classes(&self) -> Result<String, png::EncodingError> {
        self.address(CLASSES)
    }

    fn address(&self, filter: png::Filter) -> Result<String, png::EncodingError> {
        let size = [self.width, self.height];
        encoded(size, png::ColorType::Grayscale, filter, &self.values).map(|file| address(&file))
    }
}

fn encoded(
    [width, height]: [usize; 2],
    colour: png::ColorType,
    filter: png::Filter,
    bytes: &[u8],
) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_color(colour);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_deflate_compression(EFFORT);
    encoder.set_filter(filter);
    encoder.write_header()?.write_image_data(bytes)?;
    Ok(file)
}

fn address(file: &[u8]) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(file))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn png_reads_back() {
        let rgb: Vec<u8> = (0..5 * 3 * 3).map(|i| (i * 5) as u8).collect();
        let picture = Picture { width: 5, height: 3, rgb: rgb.clone() };
        let file = picture.png().unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
        let mut back = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut back).unwrap();
        assert_eq!((info.width, info.height), (5, 3));
        assert_eq!(back, rgb);
    }

    #[test]
    fn bytes_that_do_not_fit_are_an_error() {
        assert!(Picture { width: 2, height: 2, rgb: vec![0; 3] }.data_address().is_err());
    }
}
