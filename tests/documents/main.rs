//! Scenario, Recording and Run as JSON: round trips to the bit, every rule with an example that breaks it.

mod recording;
mod run;
mod scenario;

use rangelab::{Error, Problem};
use serde_json::Value;

fn as_value(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// The document with one place changed; a path ending in a new key adds it.
fn changed(document: &Value, pointer: &str, value: &Value) -> String {
    let mut document = document.clone();
    if let Some(place) = document.pointer_mut(pointer) {
        *place = value.clone();
    } else {
        let (parent, key) = pointer.rsplit_once('/').unwrap();
        document.pointer_mut(parent).unwrap()[key] = value.clone();
    }
    document.to_string()
}

fn problems_of<T: std::fmt::Debug>(result: Result<T, Error>) -> Vec<Problem> {
    match result {
        Err(Error::Invalid { problems, .. }) => problems,
        other => panic!("expected problems, found {other:?}"),
    }
}

/// Where, what to put there, the path that must be named and a part of the value shown.
type Rule = (&'static str, Value, &'static str, &'static str);

fn breaks_only(document: &Value, rules: &[Rule], read: impl Fn(&str) -> Vec<Problem>) {
    for (pointer, value, path, shown) in rules {
        let problems = read(&changed(document, pointer, value));
        assert_eq!(problems.len(), 1, "{pointer} = {value}: {problems:?}");
        let Problem { path: found, value: said, limit } = &problems[0];
        assert!(
            found == path && said.contains(shown) && !limit.is_empty(),
            "{pointer} = {value}: {problems:?}"
        );
    }
}
