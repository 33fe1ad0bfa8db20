//! Do the papers' figures come out as they should? Computes all of them and prints what is claimed beside what is found:
//! `cargo run --release --example figures`, or with another number of trials, `... figures 10000`.

use rangelab::study::figures::plan::FigurePlan;
use rangelab::study::figures::{FIGURES, SEED};

fn main() -> rangelab::Result<()> {
    let trials = std::env::args().nth(1).and_then(|text| text.parse().ok());
    for figure in &FIGURES {
        let plan = FigurePlan::new(figure, trials.unwrap_or(figure.trials), SEED)?;
        let mut sum = plan.start();
        for job in 0..plan.jobs() {
            sum.merge(&plan.job(job)?)?;
        }
        let report = plan.report(&sum)?;
        println!("\n{}\n{}", report.heading(), report.command);
        report.claims.iter().for_each(|claim| println!("  {claim}"));
    }
    Ok(())
}
