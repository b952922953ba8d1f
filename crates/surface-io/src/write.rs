//! Files out: NPY, X3P, SDF, text, and fields as VTK images and HDF5.

use contact_types::{Grid, HeightMap};
use std::io::{self, Write};

pub use crate::hdf5::hdf5;

/// Writes an array of `shape = [ny, nx]` numbers as NPY, f64, little endian. The format has no place for the
/// pixel size and the unit: reading heights back needs both.
///
/// # Errors
/// Whatever `out` reports; `InvalidInput` if the number of values is not `ny nx`.
pub fn npy(out: &mut impl Write, [ny, nx]: [usize; 2], values: &[f64]) -> io::Result<()> {
    if ny.checked_mul(nx) != Some(values.len()) {
        return Err(invalid(format!("{} values for {ny} x {nx} points", values.len())));
    }
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({ny}, {nx}), }}");
    // The data start at a multiple of 64 bytes.
    let width = (10 + header.len() + 1).next_multiple_of(64) - 10 - 1;
    let header = format!("{header:width$}\n");
    let length = u16::try_from(header.len()).map_err(io::Error::other)?;
    out.write_all(b"\x93NUMPY\x01\x00")?;
    out.write_all(&length.to_le_bytes())?;
    out.write_all(header.as_bytes())?;
    numbers(out, values)
}

/// Something that cannot be written.
pub(crate) fn invalid(what: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, what)
}

pub(crate) fn numbers(out: &mut impl Write, values: &[f64]) -> io::Result<()> {
    let mut buffer = Vec::with_capacity(8 * 4096);
    for chunk in values.chunks(4096) {
        buffer.clear();
        buffer.extend(chunk.iter().flat_map(|v| v.to_le_bytes()));
        out.write_all(&buffer)?;
    }
    Ok(())
}

/// Writes SDF (ISO 25178-71), binary: heights in metres as f64, spacings in metres. Nothing is
/// lost: reading it back gives the same bits. No date is written, so equal surfaces give equal
/// files.
///
/// # Errors
/// Whatever `out` reports; `InvalidInput` if a side has more than the 65535 points the format
/// can count.
pub fn sdf(out: &mut impl Write, map: &HeightMap) -> io::Result<()> {
    let [ny, nx] = map.grid().shape();
    let [dy, dx] = map.grid().pixel();
    let side = |n: usize| {
        u16::try_from(n).map_err(|_| {
            invalid(format!("SDF counts at most 65535 points along a side, this map has {n}"))
        })
    };
    let mut header = b"bISO-1.0roughc-io 000000000000000000000000".to_vec();
    header.extend(side(nx)?.to_le_bytes());
    header.extend(side(ny)?.to_le_bytes());
    for number in [dx, dy, 1.0, 0.0] {
        header.extend(number.to_le_bytes()); // Xscale, Yscale, Zscale, Zresolution (unknown)
    }
    header.extend([0, 7, 0]); // not compressed, f64, no checksum
    out.write_all(&header)?;
    numbers(out, map.heights())
}

/// Writes a matrix of heights in metres as text, rows of `nx` numbers between tabs, with the size and the
/// unit in a header as Gwyddion writes it. Every height of two columns or more reads back to the
/// same bits, the pixel size to the last place.
///
/// # Errors
/// Whatever `out` reports.
pub fn text(out: &mut impl Write, map: &HeightMap) -> io::Result<()> {
    let nx = map.grid().shape()[1];
    let [height, width] = map.grid().size();
    writeln!(out, "# Channel: Height\n# Width: {width:e} m\n# Height: {height:e} m")?;
    writeln!(out, "# Value units: m")?;
    for row in map.heights().chunks(nx) {
        let row: Vec<String> = row.iter().map(|z| format!("{z:e}")).collect();
        writeln!(out, "{}", row.join("\t"))?;
    }
    Ok(())
}

/// Writes VTK image data (`.vti`): each field as an array of points, f64, by its name. x runs along the rows,
/// y from row to row, both from 0 in metres. Format:
/// <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>, `ImageData`, arrays appended raw.
///
/// # Errors
/// Whatever `out` reports; `InvalidInput` if a field has not `ny nx` values, or its name is not made of letters,
/// digits and underscores.
pub fn vti(out: &mut impl Write, grid: Grid, fields: &[(&str, &[f64])]) -> io::Result<()> {
    let ([ny, nx], [dy, dx]) = (grid.shape(), grid.pixel());
    let refused = |what: String| Err(invalid(what));
    for (name, values) in fields {
        if values.len() != grid.len() {
            return refused(format!("{name}: {} values for {ny} x {nx} points", values.len()));
        }
        if name.is_empty() || !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
            return refused(format!("{name:?} is no name of letters, digits and underscores"));
        }
    }
    let extent = format!("0 {} 0 {} 0 0", nx - 1, ny - 1);
    writeln!(
        out,
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" \
         byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<ImageData WholeExtent=\"{extent}\" \
         Origin=\"0 0 0\" Spacing=\"{dx:e} {dy:e} 1\">\n<Piece Extent=\"{extent}\">\n<PointData{}>",
        fields.first().map_or(String::new(), |(name, _)| format!(" Scalars=\"{name}\""))
    )?;
    let bytes = 8 * grid.len() as u64;
    for (i, (name, _)) in fields.iter().enumerate() {
        let offset = i as u64 * (8 + bytes);
        writeln!(
            out,
            "<DataArray type=\"Float64\" Name=\"{name}\" format=\"appended\" offset=\"{offset}\"/>"
        )?;
    }
    write!(out, "</PointData>\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_")?;
    for (_, values) in fields {
        out.write_all(&bytes.to_le_bytes())?;
        numbers(out, values)?;
    }
    out.write_all(b"\n</AppendedData>\n</VTKFile>\n")
}

/// Writes X3P (ISO 25178-72): heights in metres as binary f64, increments in metres, checksums.
/// Nothing is lost: reading it back gives the same bits.
///
/// `comment` goes into Record2. No date is written, so equal surfaces give equal files.
///
/// # Errors
/// Whatever `out` reports.
#[cfg(feature = "zip")]
pub fn x3p(out: &mut (impl Write + io::Seek), map: &HeightMap, comment: &str) -> io::Result<()> {
    use zip::write::SimpleFileOptions;

    let mut data = Vec::with_capacity(8 * map.heights().len());
    numbers(&mut data, map.heights())?;
    let main = main_xml(map, comment, &format!("{:X}", md5::compute(&data)));
    let checksum = format!("{:x} *main.xml\n", md5::compute(&main));

    let mut archive = zip::ZipWriter::new(out);
    let options = SimpleFileOptions::default()
        .compression_method(zip::CompressionMethod::Deflated)
        .large_file(data.len() > 1 << 31);
    for (name, content) in [
        ("main.xml", main.as_bytes()),
        ("bindata/data.bin", &data),
        ("md5checksum.hex", checksum.as_bytes()),
    ] {
        archive.start_file(name, options)?;
        archive.write_all(content)?;
    }
    archive.finish()?;
    Ok(())
}

#[cfg(feature = "zip")]
fn main_xml(map: &HeightMap, comment: &str, checksum: &str) -> String {
    let [ny, nx] = map.grid().shape();
    let [dy, dx] = map.grid().pixel();
    let comment = quick_xml::escape::escape(comment);
    let version = env!("CARGO_PKG_VERSION");
    // Increments: the shortest decimal that reads back to the same f64.
    format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2">
  <Record1>
    <Revision>ISO5436 - 2000</Revision>
    <FeatureType>SUR</FeatureType>
    <Axes>
      <CX><AxisType>I</AxisType><DataType>D</DataType><Increment>{dx:e}</Increment><Offset>0</Offset></CX>
      <CY><AxisType>I</AxisType><DataType>D</DataType><Increment>{dy:e}</Increment><Offset>0</Offset></CY>
      <CZ><AxisType>A</AxisType><DataType>D</DataType><Increment>1</Increment><Offset>0</Offset></CZ>
    </Axes>
  </Record1>
  <Record2>
    <Date>1970-01-01T00:00:00</Date>
    <Instrument><Manufacturer>rough-contact</Manufacturer><Model>surface-io</Model><Serial>not available</Serial><Version>{version}</Version></Instrument>
    <CalibrationDate>1970-01-01T00:00:00</CalibrationDate>
    <ProbingSystem><Type>Software</Type><Identification>not available</Identification></ProbingSystem>
    <Comment>{comment}</Comment>
  </Record2>
  <Record3>
    <MatrixDimension><SizeX>{nx}</SizeX><SizeY>{ny}</SizeY><SizeZ>1</SizeZ></MatrixDimension>
    <DataLink><PointDataLink>bindata/data.bin</PointDataLink><MD5ChecksumPointData>{checksum}</MD5ChecksumPointData></DataLink>
  </Record3>
  <Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4>
</p:ISO5436_2>
"#
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The arrays lie where the header says; VTK 9.7.2 read the same bits from a file of `solve --maps`.
    #[test]
    fn arrays_are_found_at_their_offsets() {
        let grid = Grid::new([2, 3], [2e-6, 1e-6]).unwrap();
        let (a, b) = ([1.0, 2.0, 3.0, 4.0, 5.0, 6.0], [0.5; 6]);
        let mut out = Vec::new();
        vti(&mut out, grid, &[("pressure", &a), ("gap", &b)]).unwrap();
        let start = out.windows(2).position(|w| w == b"\n_").unwrap() + 2;
        let head = std::str::from_utf8(&out[..start]).unwrap();
        assert!(
            head.contains("WholeExtent=\"0 2 0 1 0 0\"")
                && head.contains("Spacing=\"1e-6 2e-6 1\"")
        );
        for (name, values) in [("pressure", a), ("gap", b)] {
            let at = head.split(&format!("Name=\"{name}\"")).nth(1).unwrap();
            let offset: usize =
                at.split("offset=\"").nth(1).unwrap().split('"').next().unwrap().parse().unwrap();
            let number = |i: usize| {
                u64::from_le_bytes(out[start + offset + 8 * i..][..8].try_into().unwrap())
            };
            assert_eq!(number(0), 48);
            let read: Vec<f64> = (1..=6).map(|i| f64::from_bits(number(i))).collect();
            assert_eq!(read, values);
        }
        assert!(vti(&mut Vec::new(), grid, &[("gap", &b[..5])]).is_err());
        assert!(vti(&mut Vec::new(), grid, &[("a\"b", &b)]).is_err());
    }
}
