//! The ends of every input: bandwidth 3/2 exactly, 3/2 (1 + 1e-12) and 1e8, separations from -6 to
//! 40 rms heights, pressures from the smallest normal double to 1e3 E*.

mod cases;

#[test]
fn every_extreme_has_an_answer() {
    let mut seen = 0;
    for case in cases::all() {
        let place = format!("{} at {}, {}", case.quantity, case.bandwidth, case.argument);
        assert!(case.answer.is_finite(), "{place}");
        match case.error() {
            Some(error) => assert!(error < 1e-14, "{place}: {error:e}"),
            None => assert!(case.answer.abs() < f64::MIN_POSITIVE, "{place}: {}", case.answer),
        }
        seen += 1;
    }
    assert!(seen > 100);
}
