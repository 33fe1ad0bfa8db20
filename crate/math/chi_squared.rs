//! Quantiles of the chi-square distribution: the bands that NEES and NIS are held against.

use super::float::{exp, lgamma, log};
use crate::error::{Error, Result};

/// Both numbers that the squared length of so many standard normal numbers stays between with a probability, as much of
/// the rest below as above: `[x_low, x_high]` with `P(chi^2 < x_low) = P(chi^2 > x_high) = (1 - probability)/2`.
///
/// # Errors
/// [`Error::Number`] for degrees of freedom that are not from 1 to 1e9, or a probability that is not between 0 and 1.
///
/// ```
/// let [low, high] = rangelab::math::chi_squared::chi_squared_interval(6.0, 0.95)?;
/// assert!((low - 1.237_344).abs() < 1e-6 && (high - 14.449_375).abs() < 1e-6);
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn chi_squared_interval(degrees_of_freedom: f64, probability: f64) -> Result<[f64; 2]> {
    if !(1.0..=1e9).contains(&degrees_of_freedom) {
        let limit = "from 1 to 1e9";
        return Err(Error::Number {
            what: "the number of degrees of freedom",
            value: degrees_of_freedom,
            limit,
        });
    }
    let outside = 0.5 * (1.0 - probability);
    if !(probability > 0.0 && outside > 0.0) {
        let limit = "above 0 and below 1";
        return Err(Error::Number { what: "the probability of an interval", value: probability, limit });
    }
    let shape = 0.5 * degrees_of_freedom;
    Ok([Tail::Lower, Tail::Upper].map(|tail| 2.0 * quantile(shape, tail, outside)))
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Tail {
    Lower,
    Upper,
}

/// The place beyond which a gamma variable of this shape lies with probability `outside`.
///
/// Newton on the logarithm of the tail over that of the place, both of which keep their digits however small the tail;
/// bisection where a step would leave the bracket.
fn quantile(shape: f64, tail: Tail, outside: f64) -> f64 {
    // Far enough out for the smallest tail that 1 - probability can leave, 2^-54.
    let (mut below, mut above) = (-80.0, log(shape + 100.0) + 1.0);
    let mut place = log(shape);
    loop {
        let Tails { density, lower, upper } = tails(shape, exp(place));
        let (found, slope) = match tail {
            Tail::Lower => (lower, density / lower),
            Tail::Upper => (upper, -density / upper),
        };
        if (found > outside) == (tail == Tail::Lower) {
            above = place;
        } else {
            below = place;
        }
        let newton = place + log(outside / found) / slope;
        let next = if newton > below && newton < above { newton } else { 0.5 * (below + above) };
        if (next - place).abs() <= 2.0 * f64::EPSILON * place.abs().max(1.0) {
            return exp(next);
        }
        place = next;
    }
}

struct Tails {
    /// The density over `log x`: `x^a e^-x / Gamma(a)`.
    density: f64,
    /// `P(a, x)`, the regularized lower incomplete gamma function.
    lower: f64,
    /// `Q(a, x) = 1 - P(a, x)`.
    upper: f64,
}

/// Each tail with all its digits where it is the smaller one (NIST DLMF 8.7.1 and 8.9.2).
fn tails(a: f64, x: f64) -> Tails {
    let density = exp(a * log(x) - x - lgamma(a));
    if x < a + 1.0 {
        let lower = density * series(a, x);
        Tails { density, lower, upper: 1.0 - lower }
    } else {
        let upper = density * continued_fraction(a, x);
        Tails { density, lower: 1.0 - upper, upper }
    }
}

/// `1/a (1 + x/(a+1) + x^2/((a+1)(a+2)) + ...)`.
fn series(a: f64, x: f64) -> f64 {
    let (mut term, mut sum, mut n) = (1.0 / a, 1.0 / a, a);
    while term > 0.25 * f64::EPSILON * sum {
        n += 1.0;
        term *= x / n;
        sum += term;
    }
    sum
}

/// `1/(x+1-a - 1(1-a)/(x+3-a - 2(2-a)/(x+5-a - ...)))`, from its front (Lentz).
fn continued_fraction(a: f64, x: f64) -> f64 {
    let mut b = x + 1.0 - a;
    let (mut c, mut d) = (f64::INFINITY, 1.0 / b);
    let (mut value, mut n) = (d, 0.0);
    loop {
        n += 1.0;
        let numerator = n * (a - n);
        b += 2.0;
        d = 1.0 / (b + numerator * d);
        c = b + numerator / c;
        let factor = c * d;
        value *= factor;
        if (factor - 1.0).abs() <= f64::EPSILON {
            return value;
        }
    }
}
