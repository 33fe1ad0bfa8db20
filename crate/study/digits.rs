//! A number with its standard error, with as many digits as it deserves.

use alloc::format;
use alloc::string::{String, ToString};
use core::fmt;

use super::moments::Estimate;

/// Digits of a standard error; a number is not known better than that.
const ERROR_DIGITS: i32 = 2;
const EXACT_DIGITS: i32 = 4;
/// Most digits after the point; beyond, an exponent is easier to read.
const MOST_DECIMALS: i32 = 7;

impl fmt::Display for Estimate {
    /// `value ± standard error`, the error with two digits; the value alone where the error does not reach its first four.
    ///
    /// ```
    /// use rangelab::study::moments::Estimate;
    /// assert_eq!(Estimate { value: 0.11596, standard_error: 0.00213 }.to_string(), "0.1160 ± 0.0021");
    /// ```
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&with_error(*self))
    }
}

impl Estimate {
    /// `value ± standard error` however small the error is; all digits where it is 0.
    ///
    /// ```
    /// use rangelab::study::moments::Estimate;
    /// let near_one = Estimate { value: 1.0000338, standard_error: 0.0000061 };
    /// assert_eq!((near_one.to_string().as_str(), near_one.in_full().as_str()), ("1.000", "1.0000338 ± 0.0000061"));
    /// ```
    pub fn in_full(self) -> String {
        let Self { value, standard_error } = self;
        match decimals(standard_error, ERROR_DIGITS) {
            _ if standard_error == 0.0 => format!("{value:?}"),
            Some(digits) => format!("{value:.digits$} ± {standard_error:.digits$}"),
            None => format!("{value:?} ± {standard_error:.0e}"),
        }
    }
}

fn with_error(estimate: Estimate) -> String {
    let Estimate { value, standard_error } = estimate;
    let first_digits = decimals(value, EXACT_DIGITS).filter(|_| value.abs() < 1e6);
    match (first_digits, decimals(standard_error, ERROR_DIGITS)) {
        _ if value == 0.0 && standard_error == 0.0 => "0".to_string(),
        (Some(digits), _) if rounds_to_zero(standard_error, digits) => format!("{value:.digits$}"),
        (Some(_), Some(_)) => estimate.in_full(),
        _ if standard_error < 5e-4 * value.abs() => format!("{value:.3e}"),
        _ => format!("{value:.2e} ± {standard_error:.0e}"),
    }
}

fn rounds_to_zero(standard_error: f64, decimals: usize) -> bool {
    !format!("{standard_error:.decimals$}").contains(|c: char| ('1'..='9').contains(&c))
}

/// How many digits after the point show `digits` digits of a number; none if that is too many.
fn decimals(value: f64, digits: i32) -> Option<usize> {
    // The exponent as it is printed, so that a number that is rounded up to a power of ten counts as that.
    let printed = format!("{value:.*e}", usize::try_from(digits - 1).ok()?);
    let exponent: i32 = printed.split_once('e')?.1.parse().ok()?;
    let decimals = (digits - 1 - exponent).max(0);
    usize::try_from(decimals).ok().filter(|_| decimals <= MOST_DECIMALS)
}

#[cfg(test)]
mod tests {
    use alloc::string::ToString;

    use super::Estimate;

    #[test]
    fn the_standard_error_decides_the_digits() {
        let shown = |value, standard_error| Estimate { value, standard_error }.to_string();
        assert_eq!(shown(0.115_96, 0.002_13), "0.1160 ± 0.0021");
        assert_eq!(shown(0.115_96, 0.000_996), "0.1160 ± 0.0010");
        assert_eq!(shown(2.0, 0.25), "2.00 ± 0.25");
        assert_eq!(shown(12_345.6, 789.0), "12346 ± 789");
        assert_eq!(shown(0.0, 0.0), "0");
        assert_eq!(shown(0.032_014_9, 0.0), "0.03201");
        assert_eq!(shown(0.032_014_9, 4e-6), "0.03201");
        assert_eq!(shown(0.032_014_9, 6e-6), "0.0320149 ± 0.0000060");
        assert_eq!(shown(0.0, 0.1), "0.00 ± 0.10");
        assert_eq!(shown(3e-9, 4e-11), "3.00e-9 ± 4e-11");
        assert_eq!(shown(3e9, 4e5), "3.000e9");
        assert_eq!(shown(3e9, 4e7), "3.00e9 ± 4e7");
    }
}
