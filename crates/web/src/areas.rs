//! How much touches without each remedy and with it, at a light load.

use crate::message::Messages;
use crate::request::{Remedies, Request};
use crate::surface::{measurement, prepared, roughness};
use crate::trouble::Trouble;
use contact_compare::{Iteration, Load, Solver, with_images};
use contact_front_end::{Failure, shown};
use contact_types::ContactModulus;
use serde_json::{Value, json};
use std::borrow::Cow;
use std::ops::ControlFlow;
use surface_io::{Cut, Measurement};

/// Pressure over contact modulus and rms gradient: about 2 % of a surface with normal heights touches.
const LOAD: f64 = 0.01;

/// Points along a side; of larger maps the middle is solved.
const MOST: usize = 1024;

/// Relative error of the pressure at which the iteration ends: the area is shown to three digits at most.
const TOLERANCE: f64 = 1e-3;

/// Tells the areas of each remedy named in the request as soon as they are found. The modulus does not matter: the
/// load is a share of it. `None` if nobody listens any more.
pub(crate) fn answer(
    request: &Request,
    file: &[u8],
    out: &mut Messages<'_>,
) -> Result<Option<Value>, Trouble> {
    let (measured, is_cut) = middle(measurement(request, file)?)?;
    let pressure = LOAD * roughness(&prepared(&measured, request)?)?.rms_gradient();
    let mut known: Vec<(Remedies, f64)> = Vec::new();
    let mut area = |asked: &Request, out: &mut Messages<'_>| -> Result<Option<f64>, Trouble> {
        if let Some((_, area)) = known.iter().find(|(with, _)| *with == asked.remedies) {
            return Ok(Some(*area));
        }
        let found = solved(&measured, asked, pressure, out)?;
        known.extend(found.map(|area| (asked.remedies.clone(), area)));
        Ok(found)
    };
    for key in &request.defects {
        let fill = key == "fill";
        let mut lines = [Vec::new(), Vec::new()];
        for (on, lines) in [false, true].into_iter().zip(&mut lines) {
            let mut asked = request.clone();
            asked.remedies.set(key, on);
            let Some(found) = area(&asked, out)? else { return Ok(None) };
            let rule = match asked.remedies.fill.as_str() {
                _ if !fill => "",
                "nearest" => ", nearest",
                _ => ", smoothly",
            };
            lines.push(format!("area {}{rule}", shown::percent(found)));
        }
        // Nobody leaves points missing: both are remedies.
        if fill {
            let other = std::mem::take(&mut lines[0]);
            lines[1].extend(other);
        }
        out.tell("progress", json!({ "stage": "area", "key": key, "lines": lines }));
    }
    Ok(Some(json!({ "cut": is_cut.then_some(MOST) })))
}

fn middle(measured: Measurement) -> Result<(Measurement, bool), Trouble> {
    let [ny, nx] = measured.grid().shape();
    if ny.max(nx) <= MOST {
        return Ok((measured, false));
    }
    let [rows, columns] = [ny, nx].map(|n| n.min(MOST));
    let part = Cut::Rectangle([(ny - rows) / 2, (nx - columns) / 2, rows, columns]);
    Ok((measured.crop(part).map_err(Trouble::Unread)?, true))
}

/// The area fraction; `None` if nobody listens any more.
fn solved(
    measured: &Measurement,
    request: &Request,
    pressure: f64,
    out: &mut Messages<'_>,
) -> Result<Option<f64>, Trouble> {
    let map = prepared(measured, request)?;
    let modulus = ContactModulus::from_pascals(1.0).map_err(|e| Failure::from(&e))?;
    let whole = with_images(Cow::Owned(map), request.remedies.mirror);
    let whole = whole.map_err(|e| Failure::from(&e))?;
    let mut solver = Solver::builder()
        .tolerance(TOLERANCE)
        .threads(request.place.threads)
        .build(whole.grid(), modulus)
        .map_err(|e| Failure::from(&e))?;
    let listen = |now: &Iteration<'_>| {
        out.tell("progress", json!({ "stage": "iteration", "number": now.number }));
        if out.is_cut() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let found = solver.solve_observed(&whole, Load::MeanPressure(pressure), listen);
    match found {
        _ if out.is_cut() => Ok(None),
        Ok(solution) => Ok(Some(solution.state.area_fraction)),
        Err(error) => Err(Trouble::Refused(Failure::from(&error))),
    }
}
