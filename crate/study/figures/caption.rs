//! What is said below a figure, computed from its claims.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::Figure;
use super::claim::{Claim, Source, Verdict};

/// What the paper says, how much was computed, and which of its claims hold.
pub(super) fn caption(figure: &Figure, trials: usize, seed: u64, claims: &[Claim]) -> String {
    let of = |source| claims.iter().filter(move |claim| claim.source == source);
    let mut text = format!("The paper says: {} ", figure.statement);
    text += &format!("Here, over {trials} trials (seed {seed}): ");
    text += &counts(of(Source::Paper).collect(), "of the paper");
    text += &counts(of(Source::Beyond).collect(), "beyond it");
    text += "Numbers are ± one standard error; a verdict needs three.";
    text
}

/// How many claims hold, and those that do not by name.
fn counts(claims: Vec<&Claim>, whose: &str) -> String {
    if claims.is_empty() {
        return String::new();
    }
    let with = |verdict| claims.iter().filter(move |claim| claim.verdict == verdict);
    let list = |verdict: Verdict| {
        let each: Vec<String> = with(verdict)
            .map(|claim| {
                let found = claim.found.map_or_else(|| "no number".into(), |found| format!("{found}"));
                format!("{} is {found}, not {}", claim.what, claim.target)
            })
            .collect();
        each.join("; ")
    };
    let holding = with(Verdict::Holds).count();
    let mut text = format!("{holding} of {} claims {whose} hold", claims.len());
    if with(Verdict::DoesNotHold).count() > 0 {
        text += &format!("; {} do not: {}", with(Verdict::DoesNotHold).count(), list(Verdict::DoesNotHold));
    }
    match with(Verdict::NotDecided).count() {
        0 => text + ". ",
        open => text + &format!("; {open} are not decided at this number of trials. "),
    }
}
