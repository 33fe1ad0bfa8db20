//! The one error type: what was wrong with the data, with the numbers in it.

use alloc::{string::String, vec::Vec};
use core::fmt;

/// One thing wrong with a document (scenario or recording): where, what was found, what is allowed.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Problem {
    /// Where in the document, for example `anchors[2][0]`.
    pub path: String,
    /// What was found there.
    pub value: String,
    /// What is allowed.
    pub limit: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is {}, allowed: {}", self.path, self.value, self.limit)
    }
}

/// Why the data at hand give no answer. Programmer mistakes assert instead.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A document breaks its rules; every problem is listed.
    Invalid {
        /// What kind of document ("scenario", "recording").
        document: &'static str,
        /// All that is wrong with it.
        problems: Vec<Problem>,
    },
    /// The text is not JSON of the expected shape.
    Syntax {
        /// What kind of document.
        document: &'static str,
        /// What the parser said, with line and column.
        message: String,
    },
    /// The document was written by a newer rangelab.
    Version {
        /// What kind of document.
        document: &'static str,
        /// Its version.
        found: u64,
        /// The newest version that can be read here.
        newest: u32,
    },
    /// A list has the wrong number of entries.
    Size {
        /// What was counted.
        what: &'static str,
        /// How many there were.
        found: usize,
        /// How many there must be.
        expected: usize,
    },
    /// A number is not finite or out of its range.
    Number {
        /// What the number is.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        limit: &'static str,
    },
    /// The information about the state lost its rank: some motion of the body cannot be seen.
    Unobservable {
        /// What was being computed.
        what: &'static str,
        /// Number of ranges that were used.
        ranges: usize,
        /// Why, in a sentence.
        reason: String,
    },
    /// There are too few nodes, stamps or distances for what was asked.
    TooFew {
        /// What was being computed.
        what: &'static str,
        /// What there are too few of.
        counted: &'static str,
        /// How many there are.
        found: usize,
        /// How many it takes.
        needed: usize,
        /// Why, in a sentence.
        reason: &'static str,
    },
    /// A pair of nodes measured the distance between them too rarely.
    PairTooFew {
        /// What was being computed.
        what: &'static str,
        /// The nodes, counted from 0.
        pair: (usize, usize),
        /// At how many different stamps they measured.
        found: usize,
        /// How many it takes.
        needed: usize,
    },
    /// The data lie so that the answer is not determined.
    Degenerate {
        /// What was being computed.
        what: &'static str,
        /// The number that shows it, relative to its usual size.
        value: f64,
        /// Why, in a sentence.
        reason: &'static str,
    },
    /// A covariance is no longer positive definite within double precision.
    NotPositiveDefinite {
        /// Which matrix.
        what: &'static str,
        /// The pivot that was met.
        pivot: f64,
    },
    /// An iteration did not settle.
    NoConvergence {
        /// Which iteration.
        what: &'static str,
        /// How many iterations were made.
        iterations: usize,
        /// Size of the last step.
        last_step: f64,
    },
    /// A name that is not in the list.
    UnknownName {
        /// What kind of thing was named.
        what: &'static str,
        /// The name given.
        name: String,
        /// The names that exist.
        known: String,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Invalid { document, problems } => {
                write!(f, "the {document} has {} problem(s)", problems.len())?;
                problems.iter().try_for_each(|problem| write!(f, "; {problem}"))
            }
            Self::Syntax { document, message } => write!(f, "the {document} cannot be read: {message}"),
            Self::Version { document, found, newest } => write!(
                f,
                "the {document} is of version {found}, and this rangelab reads version {newest}: \
                 it was written by a newer one, which can open it"
            ),
            Self::Size { what, found, expected } => write!(f, "{found} {what} where {expected} are needed"),
            Self::Number { what, value, limit } if value.is_nan() => {
                write!(f, "{what} is not a number; it must be {limit}")
            }
            Self::Number { what, value, limit } => write!(f, "{what} is {value}; it must be {limit}"),
            Self::Unobservable { what, ranges, reason } => {
                write!(f, "{what}: {ranges} ranges are not enough to find the pose. {reason}")
            }
            Self::TooFew { what, counted, found, needed, reason } => {
                write!(f, "{what} needs at least {needed} {counted}, and there are {found}. {reason}")
            }
            Self::PairTooFew { what, pair, found, needed } => pair_too_few(f, what, *pair, [*found, *needed]),
            Self::Degenerate { what, value, reason } => {
                write!(f, "{what} is not determined ({value:e}). {reason}")
            }
            Self::NotPositiveDefinite { what, pivot } => write!(
                f,
                "{what} is not positive definite within double precision (pivot {pivot:e}): \
                 the prior and the ranges differ too much in scale, or a motion of the body is not seen at all"
            ),
            Self::NoConvergence { what, iterations, last_step } => write!(
                f,
                "{what} did not settle within {iterations} iterations (last step {last_step:e}): \
                 the data barely tell orientations apart"
            ),
            Self::UnknownName { what, name, known } => {
                write!(f, "no {what} is called \"{name}\"; there are: {known}")
            }
        }
    }
}

/// People count nodes from 1.
fn pair_too_few(
    f: &mut fmt::Formatter<'_>,
    what: &str,
    (a, b): (usize, usize),
    [found, needed]: [usize; 2],
) -> fmt::Result {
    let (a, b) = (a + 1, b + 1);
    write!(f, "{what} needs the distance between nodes {a} and {b} at {needed} different stamps, and ")?;
    match found {
        0 => f.write_str("those two never measured it"),
        1 => f.write_str("those two measured it at one only"),
        _ => write!(f, "those two measured it at {found} only"),
    }
}

impl core::error::Error for Error {}

/// Result of every fallible function of the crate.
pub type Result<T> = core::result::Result<T, Error>;
