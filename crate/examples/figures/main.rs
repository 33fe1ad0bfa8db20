//! Does the tracking paper's experiment come out as it should? Runs it and prints every figure beside its target:
//! `cargo run --release --example figures`, or with another number of trials, `... figures 10000`.

mod claims;

use claims::Claim;

fn main() -> rangelab::Result<()> {
    let trials = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(1000);
    for (name, claims) in
        [("tracking-paper", claims::fixed as fn(&_) -> _), ("tracking-paper-redrawn", claims::redrawn)]
    {
        println!("\nrangelab study {name} --trials {trials}");
        claims(&claims::study(name, trials)?).iter().for_each(print);
    }
    Ok(())
}

fn print(claim: &Claim) {
    let figure = claim.found.map_or_else(
        || "none".to_owned(),
        |found| format!("{:.4} ± {:.4}", found.value, found.standard_error),
    );
    let target = match claim.target {
        (0.0, most) => format!("at most {most}"),
        (least, f64::INFINITY) => format!("above {least}"),
        (least, most) => format!("{least} to {most}"),
    };
    let verdict = match claim.missed_by() {
        0.0 => "holds".to_owned(),
        missed => format!("missed by {missed:.1} standard errors"),
    };
    println!("  {:<60} {figure:<18} {target:<16} {verdict}", claim.what);
}
