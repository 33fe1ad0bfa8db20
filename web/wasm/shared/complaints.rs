//! What is wrong with a document, as the page shows it.

use rangelab::{Error, Problem};
use serde::Serialize;

use crate::json;

/// All that is wrong with a document that was read: JSON `[{path, value, limit, message}]`, empty if it can be run. Text
/// that is no document of its kind gives one entry without a path.
pub fn complaints<T>(read: rangelab::Result<T>) -> String {
    let found = match read {
        Ok(_) => Vec::new(),
        Err(Error::Invalid { problems, .. }) => problems.into_iter().map(Found::from).collect(),
        Err(error) => vec![Found { message: error.to_string(), ..Found::default() }],
    };
    json(&found)
}

/// A problem and its sentence.
#[derive(Default, Serialize)]
struct Found {
    path: String,
    value: String,
    limit: String,
    message: String,
}

impl From<Problem> for Found {
    fn from(problem: Problem) -> Self {
        let message = problem.to_string();
        let Problem { path, value, limit } = problem;
        Self { path, value, limit, message }
    }
}
