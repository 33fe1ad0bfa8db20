//! What scenario, recording and run share: reading with a version, checking, matrices as plain numbers.
//!
//! Documents know the dimension only as a number. [`with_dimension!`](crate::with_dimension) is the one door from there
//! to code that is generic in it.

pub(super) mod check;
pub mod entries;

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::error::{Error, Problem, Result};
use check::accept;

/// The version of the documents that this crate writes, and the only one it reads.
pub const VERSION: u32 = 1;

/// Calls an expression of type `Result` with a constant `$D` equal to a dimension known only when the program runs.
///
/// ```
/// use rangelab::math::rotation::rotation_angles;
/// let angles = |dimension: usize| rangelab::with_dimension!(dimension, D => Ok(rotation_angles(D)));
/// assert_eq!((angles(2), angles(3)), (Ok(1), Ok(3)));
/// assert!(angles(4).is_err());
/// ```
#[macro_export]
macro_rules! with_dimension {
    ($dimension:expr, $D:ident => $call:expr) => {
        match $dimension {
            2 => {
                const $D: usize = 2;
                $call
            }
            3 => {
                const $D: usize = 3;
                $call
            }
            other => {
                Err($crate::Error::Number { what: "the dimension", value: other as f64, limit: "2 or 3" })
            }
        }
    };
}

#[derive(Deserialize)]
struct Versioned {
    version: u64,
}

/// Reads a document; its version comes first, so that a newer document is not blamed for its new fields.
pub(crate) fn parse<T: DeserializeOwned>(document: &'static str, text: &str) -> Result<T> {
    let Versioned { version } = parse_part(document, text)?;
    if version > u64::from(VERSION) {
        return Err(Error::Version { document, found: version, newest: VERSION });
    }
    parse_part(document, text)
}

/// A document that people write: it may leave out defaults, and it may be wrong.
pub(crate) trait Written: DeserializeOwned {
    /// What kind of document.
    const KIND: &'static str;

    /// 2 or 3, if it is right.
    fn dimension(&self) -> usize;

    /// Gives the defaults that depend on the dimension their size.
    fn fill(&mut self, dimension: usize);

    /// Everything wrong with it.
    fn problems(&self) -> Vec<Problem>;
}

/// Reads a document, fills in what was left out, and refuses it with everything that is wrong.
pub(crate) fn read<T: Written>(text: &str) -> Result<T> {
    let mut document: T = parse(T::KIND, text)?;
    let dimension = document.dimension();
    // Any other dimension is among the problems; it must not decide how much memory is taken.
    if (2..=3).contains(&dimension) {
        document.fill(dimension);
    }
    accept(T::KIND, document.problems())?;
    Ok(document)
}

/// Reads a part of a document, which has no version of its own.
fn parse_part<T: DeserializeOwned>(document: &'static str, text: &str) -> Result<T> {
    serde_json::from_str(text).map_err(|error| Error::Syntax { document, message: error.to_string() })
}

/// Reads a part of a document that stands alone, and refuses it with everything that is wrong.
pub(crate) fn read_part<T: DeserializeOwned>(
    kind: &'static str,
    text: &str,
    problems: impl Fn(&T) -> Vec<Problem>,
) -> Result<T> {
    let part = parse_part(kind, text)?;
    accept(kind, problems(&part))?;
    Ok(part)
}

/// Writes a document; every number comes back as the same bits.
pub(crate) fn write<T: Serialize>(document: &T) -> String {
    serde_json::to_string(document).expect("numbers, lists and texts always have a JSON form")
}
