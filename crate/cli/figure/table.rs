//! A figure as a text for people: what is claimed, what is found, what holds.

use std::fmt::Write;

use rangelab::study::figures::claim::{Claim, Source};
use rangelab::study::figures::report::FigureReport;

use super::LINE;
use crate::cli::text::wrapped;

pub fn text(report: &FigureReport) -> String {
    let mut text = format!("{}\n{}\n\n", report.heading(), report.command);
    for (source, title) in [(Source::Paper, "What the paper claims"), (Source::Beyond, "Beyond the paper")] {
        let claims: Vec<&Claim> = report.claims.iter().filter(|claim| claim.source == source).collect();
        if !claims.is_empty() {
            let _ = writeln!(text, "{title}\n{}", table(&claims));
        }
    }
    text + &wrapped(&report.caption, LINE).join("\n") + "\n"
}

/// Claim, number, target and verdict, one line each, in columns.
pub fn rows(claims: &[&Claim]) -> Vec<[String; 4]> {
    let row = |claim: &&Claim| {
        [claim.what.clone(), claim.found_words(), claim.target.to_string(), claim.verdict.to_string()]
    };
    claims.iter().map(row).collect()
}

fn table(claims: &[&Claim]) -> String {
    let rows = rows(claims);
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths = [0, 1, 2].map(width);
    let line = |row: &[String; 4]| {
        let [what, found, target, verdict] = row;
        let [a, b, c] = widths;
        format!("  {what:<a$}  {found:<b$}  {target:<c$}  {verdict}\n")
    };
    rows.iter().map(line).collect()
}
