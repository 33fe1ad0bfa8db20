//! What is said below a figure, computed from its claims.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::Figure;
use super::claim::{Claim, Source, Verdict};

/// What the paper says, how much was computed, and which of its claims hold.
pub(super) fn caption(figure: &Figure, trials: usize, seed: u64, claims: &[Claim]) -> String {
    let of = |source| claims.iter().filter(|claim| claim.source == source).collect::<Vec<_>>();
    let (paper, beyond) =
        (counts(&of(Source::Paper), "of the paper"), counts(&of(Source::Beyond), "beyond it"));
    format!(
        "The paper says: {} Here, over {trials} trials (seed {seed}): {paper}{beyond}Numbers are ± one standard error; \
         a verdict needs three.",
        figure.statement
    )
}

/// How many claims hold, and those that do not by name.
fn counts(claims: &[&Claim], whose: &str) -> String {
    let with = |verdict| claims.iter().filter(move |claim| claim.verdict == verdict);
    let [holding, failing, open] =
        [Verdict::Holds, Verdict::DoesNotHold, Verdict::NotDecided].map(|verdict| with(verdict).count());
    if claims.is_empty() {
        return String::new();
    }
    let failures = match failing {
        0 => String::new(),
        1 => format!("; this one does not: {}", list(with(Verdict::DoesNotHold))),
        _ => format!("; these {failing} do not: {}", list(with(Verdict::DoesNotHold))),
    };
    let undecided = match open {
        0 => String::new(),
        1 => "; one is not decided at this number of trials".to_string(),
        _ => format!("; {open} are not decided at this number of trials"),
    };
    format!("{holding} of {} claims {whose} hold{failures}{undecided}. ", claims.len())
}

fn list<'a>(claims: impl Iterator<Item = &'a &'a Claim>) -> String {
    let each = claims.map(|claim| format!("{} is {}, not {}", claim.what, claim.found_words(), claim.target));
    each.collect::<Vec<_>>().join("; ")
}
