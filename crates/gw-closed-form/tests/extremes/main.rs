//! The ends of every input: the answer and its error, never NaN or infinity.

mod cases;

#[test]
fn every_extreme_has_an_answer() {
    let mut seen = 0;
    for case in cases::all() {
        let place = format!("{} at {}", case.quantity, case.argument);
        assert!(case.answer.is_finite(), "{place}");
        match case.error() {
            // α = ln-load 1000 is exp(667): its digits are those of the logarithm.
            Some(error) if case.argument == "1000" && case.quantity == "alpha from ln load" => {
                assert!(error < 1e-13, "{place}: {error:e}");
            }
            Some(error) => assert!(error < 4e-15, "{place}: {error:e}"),
            None => assert!(
                case.answer.abs() >= f64::MAX || case.answer.abs() < f64::MIN_POSITIVE,
                "{place}: {}",
                case.answer
            ),
        }
        seen += 1;
    }
    assert!(seen > 60);
}
