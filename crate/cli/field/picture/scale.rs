//! Places on a logarithmic scale, and round numbers along scales.

use rangelab::math::float::{floor, log, pow};

/// From 0 at its low end to 1 at its high end.
#[derive(Clone, Copy)]
pub struct Scale {
    pub low: f64,
    pub high: f64,
}

/// This part of the cells is beyond the high end: the few beside a place without a bound would take all colours.
const BEYOND: f64 = 0.02;
/// The ends differ at least by this factor, or rounding would be coloured.
const LEAST_RATIO: f64 = 1.05;
const MOST_LEVELS: usize = 10;
/// First digits of levels, from few to many in a power of ten.
const DIGITS: [&[&str]; 5] = [
    &["1"],
    &["1", "3"],
    &["1", "2", "5"],
    &["1", "1.5", "2", "3", "4", "5", "7"],
    &["1", "1.2", "1.4", "1.6", "1.8", "2", "2.5", "3", "3.5", "4", "4.5", "5", "6", "7", "8", "9"],
];

impl Scale {
    /// The scale of these numbers; none of no numbers.
    pub fn of(values: impl Iterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<f64> = values.collect();
        sorted.sort_by(f64::total_cmp);
        let low = *sorted.first()?;
        let high = sorted[super::canvas::cell(1.0 - BEYOND, sorted.len())];
        Some(Self { low, high: high.max(LEAST_RATIO * low) })
    }

    pub fn place(&self, value: f64) -> f64 {
        log(value / self.low) / log(self.high / self.low)
    }

    /// Round numbers on it: as many as are told apart.
    pub fn levels(&self) -> Vec<f64> {
        let sets = DIGITS.iter().map(|digits| self.levels_of(digits));
        sets.filter(|levels| levels.len() <= MOST_LEVELS).last().unwrap_or_else(|| self.levels_of(DIGITS[0]))
    }

    fn levels_of(&self, digits: &[&str]) -> Vec<f64> {
        let power = |value: f64| whole(floor(log(value) / core::f64::consts::LN_10));
        let powers = power(self.low)..=power(self.high);
        // Read from decimal digits, a level is the number that is written beside it.
        let levels =
            powers.flat_map(|power| digits.iter().map(move |digit| format!("{digit}e{power}").parse()));
        levels.flatten().filter(|level| (self.low..=self.high).contains(level)).collect()
    }
}

/// Round numbers from `low` to `high`, 4 to 10 of them.
pub fn ticks(low: f64, high: f64) -> Vec<f64> {
    let power = pow(10.0, floor(log(high - low) / core::f64::consts::LN_10));
    let part = (high - low) / power;
    let step = if part <= 2.0 {
        0.2 * power
    } else if part <= 5.0 {
        0.5 * power
    } else {
        power
    };
    let first = whole(-floor(-low / step));
    (first..=whole(floor(high / step))).map(|k| f64::from(k) * step).collect()
}

#[allow(clippy::cast_possible_truncation, reason = "a whole number far below 2^31; beyond, it saturates")]
fn whole(value: f64) -> i32 {
    value as i32
}

/// As few digits as tell it: at most four.
pub fn short(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e5).contains(&size) {
        return format!("{value:e}");
    }
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
