//! Spikes in words.

use crate::numbers::{METRES, percent, quantity};
use contact_compare::SPIKE_THRESHOLD;

/// Part of the points from which spikes of an instrument are not the likely reading.
const MANY_SPIKES: f64 = 0.01;

/// Claim and text: what `count` spikes of `of` points say, after `taken` were taken out.
pub(super) fn spikes(
    [count, taken, of]: [usize; 3],
    largest: f64,
    share: Option<f64>,
) -> [String; 2] {
    let (who, stand) = if count == 1 { ("It carries", "stands") } else { ("They carry", "stand") };
    let carried = share.map_or_else(String::new, |s| format!("{who} {} of the load. ", percent(s)));
    let [part, ever] = [count, count + taken].map(|n| n as f64 / of.max(1) as f64);
    let up_to = quantity(largest, METRES, 2);
    let points = if count == 1 { "1 point".to_owned() } else { format!("{count} points") };
    let many = "So many are seldom spikes of an instrument: a surface of smooth ground with peaks, grains or walls on it \
                looks so too";
    match (taken > 0, ever > MANY_SPIKES) {
        (true, is_many) => [
            format!(
                "{points} still {stand} far from the neighbours, up to {up_to}, after {taken} {} taken out.",
                if taken == 1 { "was" } else { "were" }
            ),
            if is_many {
                format!(
                    "{carried}{many}, and taking them out takes peaks from it. Look at the map."
                )
            } else {
                format!(
                    "{carried}Another round would find others again: rims of wide spikes, peaks and edges of the surface \
                     itself. Look at the map; what is an error of the instrument can be made a missing point in the file."
                )
            },
        ],
        (false, true) => [
            format!(
                "{} of the points stand far from their neighbours, up to {up_to}.",
                percent(part)
            ),
            format!("{carried}{many}. Look at the map before you take all out."),
        ],
        (false, false) => [
            format!(
                "{points} {}, up to {up_to} from the neighbours.",
                if count == 1 { "is a spike" } else { "are spikes" }
            ),
            format!(
                "{carried}If they are errors of the instrument, take them out and fill: outliers {SPIKE_THRESHOLD}, \
                 fill harmonic."
            ),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numbers::SPACE;

    #[test]
    fn half_a_map_is_no_spike() {
        let told = |count, taken| {
            let [claim, text] = spikes([count, taken, 1000], 1e-6, None);
            (claim + " " + &text).replace(SPACE, " ")
        };
        assert!(told(9, 0).contains("9 points are spikes") && told(9, 0).contains("fill harmonic"));
        assert!(
            !told(500, 0).contains("are spikes") && told(500, 0).contains("50 % of the points")
        );
        // What was done is not advised again.
        for left in [told(1, 8), told(9, 1), told(500, 40)] {
            assert!(left.contains("still stand") && !left.contains("fill harmonic"), "{left}");
        }
        assert!(
            told(9, 1).contains("Another round") && told(9, 40).contains("takes peaks from it")
        );
    }
}
