//! A statement about a figure, held against what was found.

use alloc::string::{String, ToString};
use core::fmt;

use serde::{Deserialize, Serialize};

use crate::study::moments::Estimate;

/// A verdict is given where the number is clear of the target's ends by so many of its standard errors: by chance alone a
/// claim in 700 would come out on the wrong side.
pub const STANDARD_ERRORS: f64 = 3.0;

/// What is claimed, what was found, and whether it holds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Claim {
    /// What the number is.
    pub what: String,
    /// Who claims it.
    pub source: Source,
    /// The number; null where the trials so far give none.
    pub found: Option<Estimate>,
    /// Where it should lie.
    pub target: Interval,
    /// Whether it does.
    pub verdict: Verdict,
}

/// Who claims something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "kebab-case")]
pub enum Source {
    /// The paper, in words that are made a number here.
    Paper,
    /// rangelab, beyond the paper.
    Beyond,
}

/// Where a number should lie; null at an end that is open.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Interval {
    /// Least.
    pub least: Option<f64>,
    /// Most.
    pub most: Option<f64>,
}

/// What the number says of the claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The number is inside of the target by [`STANDARD_ERRORS`].
    Holds,
    /// It is outside by as many.
    DoesNotHold,
    /// It is too near to an end of the target, there is none, or too few trials stand behind it.
    NotDecided,
}

impl Claim {
    /// Holds a number against a target.
    pub fn new(source: Source, what: impl Into<String>, found: Option<Estimate>, target: Interval) -> Self {
        let verdict = found.map_or(Verdict::NotDecided, |found| target.verdict(found));
        Self { what: what.into(), source, found, target, verdict }
    }

    /// The number in words: with its standard error also where its first digits alone would speak against the verdict.
    pub fn found_words(&self) -> String {
        let Some(found) = self.found else { return "no number".to_string() };
        let words = found.to_string();
        let alone = words.parse::<f64>().ok().map(|value| Estimate { value, standard_error: 0.0 });
        let misleads = alone.is_some_and(|alone| self.target.verdict(alone) != self.verdict);
        if misleads { found.in_full() } else { words }
    }

    /// The same where too few trials stand behind the number.
    #[must_use]
    pub(super) fn undecided(self) -> Self {
        Self { verdict: Verdict::NotDecided, ..self }
    }
}

impl Interval {
    /// At most this.
    pub const fn most(most: f64) -> Self {
        Self { least: None, most: Some(most) }
    }

    /// At least this.
    pub const fn least(least: f64) -> Self {
        Self { least: Some(least), most: None }
    }

    /// From this to that.
    pub const fn between(least: f64, most: f64) -> Self {
        Self { least: Some(least), most: Some(most) }
    }

    /// Whether a number lies in it, as far as its standard error lets one say.
    ///
    /// ```
    /// use rangelab::study::figures::claim::{Interval, Verdict};
    /// use rangelab::study::moments::Estimate;
    /// let found = |value| Estimate { value, standard_error: 0.01 };
    /// let verdicts = [0.96, 0.98, 1.02, 1.04].map(|value| Interval::most(1.0).verdict(found(value)));
    /// use Verdict::{DoesNotHold, Holds, NotDecided};
    /// assert_eq!(verdicts, [Holds, NotDecided, NotDecided, DoesNotHold]);
    /// ```
    pub fn verdict(self, found: Estimate) -> Verdict {
        let reach = STANDARD_ERRORS * found.standard_error;
        let (low, high) = (found.value - reach, found.value + reach);
        let (least, most) = (self.least.unwrap_or(f64::NEG_INFINITY), self.most.unwrap_or(f64::INFINITY));
        if low >= least && high <= most {
            Verdict::Holds
        } else if high < least || low > most {
            Verdict::DoesNotHold
        } else {
            Verdict::NotDecided
        }
    }
}

impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.least, self.most) {
            (Some(least), Some(most)) => write!(f, "{least} to {most}"),
            (Some(least), None) => write!(f, "at least {least}"),
            (None, Some(most)) => write!(f, "at most {most}"),
            (None, None) => f.write_str("anything"),
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Holds => "holds",
            Self::DoesNotHold => "does not hold",
            Self::NotDecided => "not decided",
        })
    }
}

impl fmt::Display for Claim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {} ({}): {}", self.what, self.found_words(), self.target, self.verdict)
    }
}

#[cfg(test)]
mod tests {
    use super::{Claim, Estimate, Interval, Source};

    #[test]
    fn words_never_speak_against_the_verdict() {
        let words = |value, standard_error, target| {
            let found = Some(Estimate { value, standard_error });
            Claim::new(Source::Paper, "ratio", found, target).found_words()
        };
        let most = Interval::most(1.0);
        assert_eq!(words(1.000_033_8, 6.1e-6, most), "1.0000338 ± 0.0000061");
        assert_eq!(words(1.000_033_8, 6.1e-5, most), "1.000034 ± 0.000061");
        assert_eq!(words(0.999_966_2, 6.1e-6, most), "1.000");
        assert_eq!(words(1.000_033_8, 0.0, most), "1.0000338");
        assert_eq!(words(1.02, 6.1e-6, most), "1.020");
        assert_eq!(Claim::new(Source::Paper, "ratio", None, most).found_words(), "no number");
    }
}
