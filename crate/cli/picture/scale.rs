//! Places on a logarithmic scale, and round numbers along scales.

use rangelab::math::float::{floor, log, pow};

/// From 0 at its low end to 1 at its high end.
#[derive(Clone, Copy)]
pub struct Scale {
    pub low: f64,
    pub high: f64,
    /// Whether there are larger numbers: they have the last colour.
    pub more: bool,
}

/// Where the numbers span more than this, a few may be beyond the high end: those beside a place without a bound would
/// take all colours.
const SPAN: f64 = 100.0;
/// How many: this part of the cells.
const BEYOND: f64 = 0.02;
/// The ends differ at least by this factor, or rounding would be coloured.
const LEAST_RATIO: f64 = 1.05;
const MOST_LEVELS: usize = 10;
/// First three digits of levels where there are few in a power of ten; where there are more, they are evenly apart.
const DIGITS: [&[u16]; 3] = [&[100], &[100, 300], &[100, 200, 500]];
const STEPS: [usize; 7] = [100, 50, 20, 10, 5, 2, 1];

impl Scale {
    /// The scale of these numbers; none of no numbers.
    pub fn of(values: impl Iterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<f64> = values.collect();
        sorted.sort_by(f64::total_cmp);
        let (low, largest) = (*sorted.first()?, *sorted.last()?);
        let most = sorted[super::canvas::cell(1.0 - BEYOND, sorted.len())];
        let high = largest.min(most.max(SPAN * low)).max(LEAST_RATIO * low);
        Some(Self { low, high, more: largest > high })
    }

    pub fn place(&self, value: f64) -> f64 {
        log(value / self.low) / log(self.high / self.low)
    }

    /// Round numbers on it: as many as are told apart.
    pub fn levels(&self) -> Vec<f64> {
        let even = STEPS.iter().map(|step| (100..1000).step_by(*step).collect());
        let digits = DIGITS.iter().map(|digits| digits.to_vec()).chain(even);
        let sets = digits.map(|digits| self.levels_of(&digits));
        sets.take_while(|levels| levels.len() <= MOST_LEVELS).last().unwrap_or_default()
    }

    fn levels_of(&self, digits: &[u16]) -> Vec<f64> {
        let power = |value: f64| whole(floor(log(value) / core::f64::consts::LN_10));
        let powers = power(self.low) - 1..=power(self.high) + 1;
        // Read from decimal digits, a level is the number that is written beside it.
        let level = |digit: u16, power: i64| format!("{digit}e{}", power - 2).parse();
        let levels = powers.flat_map(|power| digits.iter().map(move |digit| level(*digit, power)));
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
    (first..=whole(floor(high / step))).map(|k| k as f64 * step).collect()
}

#[allow(clippy::cast_possible_truncation, reason = "a whole number far below 2^63; beyond, it saturates")]
fn whole(value: f64) -> i64 {
    value as i64
}

/// As few digits as tell it.
pub fn short(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e5).contains(&size) {
        let text = format!("{value:.9e}");
        let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{power}", without_zeros(digits));
    }
    let text = format!("{value:.6}");
    let text = without_zeros(&text);
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn without_zeros(decimals: &str) -> &str {
    decimals.trim_end_matches('0').trim_end_matches('.')
}
