//! The columns of a table of numbers: which are coordinates, running numbers, marks or heights.

use super::super::scattered::{self, Line};
use crate::cells::Digits;
use crate::header::{HEIGHTS, Header};
use crate::meaning::Meaning;
use crate::text::{NumberTable, Title, is_monotone};
use crate::{Layout, Limits, Need, ReadError};

/// Titles of columns with running numbers.
pub(super) const INDEX: [&str; 17] = [
    "index", "idx", "no", "no.", "nr", "nr.", "n", "i", "#", "id", "point", "pt", "number",
    "nummer", "count", "counter", "sample",
];

impl NumberTable<'_> {
    /// Names the columns; units of the cells are those of the titles.
    pub(super) fn name_columns(&mut self, mut titles: Vec<Title>) {
        titles.resize(self.columns.max(titles.len()), Title::default());
        for (title, cells) in titles.iter_mut().zip(&mut self.titles) {
            title.unit = title.unit.take().or_else(|| cells.unit.take());
        }
        self.titles = titles;
    }

    /// Half of the rows may say with 0 which points of the other half are missing (SPIP).
    pub(super) fn apply_mask(&mut self, header: &Header) {
        let rows = self.rows();
        if let Some(half) = header.rows_before_mask.filter(|&half| rows == 2 * half) {
            let mask = self.values.split_off(half * self.columns);
            for (z, _) in self.values.iter_mut().zip(mask).filter(|(_, is_there)| *is_there == 0.0)
            {
                *z = f64::NAN;
            }
        }
    }

    pub(super) fn column(&self, column: usize) -> Vec<f64> {
        self.values.iter().skip(column).step_by(self.columns).copied().collect()
    }

    pub(super) fn unit(&self, column: usize) -> Option<String> {
        self.titles.get(column).and_then(|title| title.unit.clone())
    }

    pub(super) fn is_called(&self, column: usize, names: &[&str]) -> bool {
        let is_one = |title: &Title| names.iter().any(|name| title.name.eq_ignore_ascii_case(name));
        self.titles.get(column).is_some_and(is_one)
    }

    /// The column of one of these names, if one only has it.
    pub(super) fn called(&self, names: &[&str]) -> Option<usize> {
        let mut found = (0..self.columns).filter(|&column| self.is_called(column, names));
        found.next().filter(|_| found.next().is_none())
    }

    pub(super) fn pick(self, order: &[usize]) -> Self {
        if order.iter().copied().eq(0..self.columns) {
            return self;
        }
        let digits = |i: usize| order.get(i).and_then(|&column| self.digits.get(column)).copied();
        Self {
            values: self
                .values
                .chunks_exact(self.columns)
                .flat_map(|row| order.iter().map(|&column| row[column]))
                .collect(),
            columns: order.len(),
            titles: order.iter().map(|&column| self.titles[column].clone()).collect(),
            digits: std::array::from_fn(|i| digits(i).unwrap_or(Digits::NONE)),
            ..self
        }
    }

    /// x, y, z, then the others, if the titles say which x and y are.
    pub(super) fn order(&self) -> Option<Vec<usize>> {
        let either = |name: &str, other: &[&str]| {
            self.called(&[name]).or_else(|| self.called(other)).filter(|_| self.columns > 2)
        };
        let x = either("x", &["col", "col.", "column", "spalte"])?;
        let y = either("y", &["row", "line", "zeile"])?;
        let others = || (0..self.columns).filter(move |&column| column != x && column != y);
        let z = others().min_by_key(|column| {
            let name = self.titles[*column].name.to_lowercase();
            (!HEIGHTS.iter().any(|height| name.starts_with(height)), Meaning::of(&name))
        })?;
        Some([x, y, z].into_iter().chain(others().filter(|&column| column != z)).collect())
    }

    /// A column that says which points are valid is no height.
    pub(super) fn leave_out_invalid(&mut self) -> Result<(), ReadError> {
        if self.columns < 3 {
            return Ok(());
        }
        let valid = self.called(&["valid", "isvalid"]);
        let invalid = self.called(&["invalid", "masked", "outlier", "bad"]);
        if let Some(column) = self.called(&["mask"]) {
            let marks = self.column(column);
            if marks.contains(&0.0) && marks.iter().any(|m| *m != 0.0) {
                let what = format!(
                    "column {} is a mask, whose 1 may mark points that are valid or that are not: call it \
                     \"valid\" or \"invalid\" in its title",
                    column + 1
                );
                return Err(two_readings(what, &[]));
            }
        }
        let Some(column) = valid.or(invalid) else { return Ok(()) };
        let kept: Vec<usize> = (0..self.columns).filter(|&other| other != column).collect();
        let first = usize::from(self.is_called(kept[0], &INDEX));
        let coordinates = match (self.called(&["x"]), self.called(&["y"])) {
            (Some(x), Some(y)) if kept.len() > first + 2 => vec![x, y],
            _ => vec![kept[first.min(kept.len() - 1)]],
        };
        for row in self.values.chunks_exact_mut(self.columns) {
            if (row[column] == 0.0) == valid.is_some() {
                for &height in kept[first..].iter().filter(|column| !coordinates.contains(column)) {
                    row[height] = f64::NAN;
                }
            }
        }
        let all = std::mem::replace(self, Self::empty(Vec::new()));
        *self = all.pick(&kept);
        Ok(())
    }

    /// True if the first of three columns or more counts the points that the others list.
    pub(super) fn has_index(&self, limits: &Limits) -> bool {
        // With a title it would be called so.
        let is_called = !self.titles[0].name.is_empty();
        if self.columns < 3 || self.rows() < 3 || is_called || !runs(&self.column(0)) {
            return false;
        }
        if self.columns == 3 {
            return Line::new(&self.column(1), self.digits[1])
                .is_ok_and(|line| line.uneven.is_none());
        }
        let values: Vec<f64> = self
            .values
            .chunks_exact(self.columns)
            .flat_map(|row| row[1..4].iter().copied())
            .collect();
        scattered::grid(&values, 3, [self.digits[1], self.digits[2]], limits)
            .is_ok_and(|map| map.is_plain())
    }

    pub(super) fn grid(&self, limits: &Limits) -> Result<scattered::GriddedMap, ReadError> {
        scattered::grid(&self.values, self.columns, [self.digits[0], self.digits[1]], limits)
    }

    /// Takes away a first row and a first column of coordinates or running numbers: around a corner that is empty or
    /// holds no height, and a first row that counts.
    pub(super) fn leave_out_axes(
        &mut self,
        header: &mut Header,
        layout: Option<Layout>,
    ) -> Result<(), ReadError> {
        let (rows, columns) = (self.rows(), self.columns);
        if columns < 4 || rows < 3 {
            return Ok(());
        }
        let top = self.values[1..columns].to_vec();
        let side = self.column(0).split_off(1);
        let corner = self.values[0];
        let is_empty = corner.is_nan();
        let lines = (Line::new(&top, self.first_row), Line::new(&side, self.digits[0]));
        // A plane rises everywhere.
        let is_plane = self.is_plane();
        let is_corner = is_empty
            || layout.is_none()
                && !is_plane
                && top.len() > 3
                && side.len() > 3
                && (corner == 0.0 || corner - top.len() as f64 == 0.0);
        if let (true, (Ok(x), Ok(y))) = (is_corner, &lines) {
            if x.uneven.is_some() || y.uneven.is_some() {
                if top.len() < 6 || side.len() < 6 {
                    return Ok(());
                }
                let what = "the first row and the first column rise like coordinates and are not evenly spaced: a map \
                            is to be put on an even grid first; all numbers can as well be heights";
                return Err(two_readings(what.into(), &[Layout::Matrix]));
            }
            let count = runs(&top) && runs(&side);
            if is_plane && !count {
                let what = "the first row and the first column rise evenly, and so do the others: coordinates of an \
                            even slope, to be deleted, or heights";
                return Err(two_readings(what.into(), &[Layout::Matrix]));
            }
            let mut heights: Vec<f64> = self.values[columns..]
                .chunks_exact(columns)
                .flat_map(|row| row[1..].iter().copied())
                .collect();
            if x.is_falling {
                heights.chunks_exact_mut(columns - 1).for_each(<[f64]>::reverse);
            }
            if y.is_falling {
                heights = heights.chunks_exact(columns - 1).rev().flatten().copied().collect();
            }
            self.values = heights;
            self.columns -= 1;
            header.steps = (!count).then_some([y.step, x.step]);
            let what = if count { "running numbers" } else { "coordinates" };
            header.metadata.insert("left out".into(), format!("{what} of rows and columns"));
            return Ok(());
        }
        let first = &self.values[..columns];
        if layout.is_some() || is_plane {
            return Ok(());
        }
        // Who states what a number means writes no row that counts, and a long one does so by no chance.
        if columns < 8 && (header.value_unit.is_some() || header.value_scale.is_some()) {
            return Ok(());
        }
        let rest = || self.values[columns..].iter().filter(|z| !z.is_nan());
        if runs(first) && (columns > 7 || rest().any(|z| z.fract() != 0.0)) {
            self.values.drain(..columns);
            header.metadata.insert("left out".into(), "running numbers of the columns".into());
            return Ok(());
        }
        if columns > 7 && Line::new(first, self.first_row).is_ok_and(|line| line.uneven.is_none())
            || runs(first)
        {
            let what = format!(
                "the first row rises evenly from {} to {}: coordinates or running numbers, to be deleted, or heights",
                first[0],
                first[columns - 1]
            );
            return Err(two_readings(what, &[Layout::Matrix]));
        }
        Ok(())
    }

    /// True if most rows or most columns rise or fall, without the first.
    pub(super) fn is_plane(&self) -> bool {
        let rises = |line: &[f64]| {
            let there: Vec<f64> = line.iter().copied().filter(|z| !z.is_nan()).collect();
            there.len() > 2 && is_monotone(&there)
        };
        let rows = self.values.chunks_exact(self.columns).skip(1);
        let most = self.rows() / 2;
        let rising = rows.filter(|row| rises(&row[1..])).count();
        let columns = (1..self.columns).filter(|&column| rises(&self.column(column)[1..]));
        rising > most || columns.count() > self.columns / 2
    }

    /// A first column that rises or falls from row to row, and no other does, may be positions of traces.
    pub(super) fn refuse_positions(&self) -> Result<(), ReadError> {
        if self.columns < 2 || self.rows() < 4 {
            return Ok(());
        }
        let x = self.column(0);
        let Ok(line) = Line::new(&x, self.digits[0]) else { return Ok(()) };
        if line.uneven.is_some() && x.len() < 8
            || (1..self.columns).any(|other| is_monotone(&self.column(other)))
        {
            return Ok(());
        }
        let what = format!(
            "the first of {} columns {} from {} to {}: positions or running numbers, and the others heights of \
             traces, or all are heights of a map",
            self.columns,
            if line.is_falling { "falls" } else { "rises" },
            x[0],
            x[x.len() - 1]
        );
        Err(two_readings(what, &[Layout::Traces, Layout::Matrix]))
    }
}

/// True if the numbers count 0, 1, 2, … or 1, 2, 3, …
fn runs(numbers: &[f64]) -> bool {
    let first = numbers.first().copied().unwrap_or(f64::NAN);
    (first == 0.0 || first - 1.0 == 0.0)
        && numbers.len() > 2
        && numbers.iter().enumerate().all(|(i, number)| number - first - i as f64 == 0.0)
}

pub(super) fn two_readings(what: String, needs: &[Layout]) -> ReadError {
    let needs = needs.iter().copied().map(Need::Layout).collect();
    ReadError::Ambiguous { what, needs }
}
