//! Fields on a grid as VTK image data, which ParaView opens.
//!
//! Format: <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>, `ImageData`, arrays appended raw.

use contact_types::Grid;
use std::io::{self, Write};

/// Writes VTK image data (`.vti`): each field as an array of points, f64, by its name. x runs along the rows,
/// y from row to row, both from 0 in metres.
///
/// # Errors
/// Whatever `out` reports; `InvalidInput` if a field has not `ny nx` values, or its name is not made of letters,
/// digits and underscores.
pub fn vti(out: &mut impl Write, grid: Grid, fields: &[(&str, &[f64])]) -> io::Result<()> {
    let ([ny, nx], [dy, dx]) = (grid.shape(), grid.pixel());
    let refused = |what: String| Err(crate::write::invalid(what));
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
        crate::write::numbers(out, values)?;
    }
    out.write_all(b"\n</AppendedData>\n</VTKFile>\n")
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
        assert!(head.contains("WholeExtent=\"0 2 0 1 0 0\""), "{head}");
        assert!(head.contains("Spacing=\"1e-6 2e-6 1\""), "{head}");
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
