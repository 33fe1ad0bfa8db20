//! What the searches found, for people.

use rangelab::model::placement_settings::{Criterion, Over, Target};
use rangelab::model::ranging::RangeForm;
use rangelab::model::scenario::Scenario;
use rangelab::place::{Improvement, NextPlace};

/// What is made small, the searches, the anchors of the best, and where one more would help the anchors as they are.
pub fn table(scenario: &Scenario, found: &[Improvement], best: usize, next: Option<&NextPlace>) -> String {
    let best = &found[best];
    let mut lines = vec![goal(scenario), String::new()];
    lines.push(format!("search  {:<11}  of the best", format!("value, {}", best.unit)));
    lines.extend(found.iter().map(|search| row(search, best)));
    lines.extend([String::new(), summary(best), String::new()]);
    lines.extend(anchors(scenario, best));
    lines.extend([String::new(), one_more(next)]);
    lines.join("\n")
}

fn row(search: &Improvement, best: &Improvement) -> String {
    let share = search.after.zip(best.after).map(|(after, best)| format!("{:.1} %", 100.0 * best / after));
    format!("{:<6}  {:<11}  {:>11}", search.restart, digits(search.after), share.unwrap_or_default())
}

/// The best beside the anchors as they were.
fn summary(best: &Improvement) -> String {
    let (before, after, unit) = (digits(best.before), digits(best.after), &best.unit);
    let Some(ratio) = best.after.zip(best.before).map(|(after, before)| after / before) else {
        return format!("before: no bound exists; after: {after} {unit} (search {})", best.restart);
    };
    let (change, more) = (100.0 * (ratio - 1.0).abs(), if ratio > 1.0 { "more" } else { "less" });
    format!("before: {before} {unit}; after: {after} {unit}, {change:.1} % {more} (search {})", best.restart)
}

fn one_more(next: Option<&NextPlace>) -> String {
    let Some(next) = next else {
        return "one more anchor in the plane of the field: no place gives a bound".into();
    };
    let place: Vec<String> = next.point.iter().map(|x| format!("{x:.3}")).collect();
    let (now, with, unit) = (digits(next.before), digits(next.after), &next.unit);
    let place = place.join(", ");
    format!(
        "one more anchor in the plane of the field: best at ({place}) m, {now} {unit} now, {with} {unit} with it"
    )
}

/// What the values mean.
fn goal(scenario: &Scenario) -> String {
    let placement = &scenario.placement;
    let criterion = match placement.criterion {
        Criterion::A => "A: root of the trace",
        Criterion::D => "D: geometric mean of the standard deviations",
        Criterion::E => "E: largest standard deviation",
    };
    let target = match placement.target {
        Target::Position => "the position",
        Target::Orientation => "the orientation",
        Target::Pose => "the pose, angles as metres at the sensors",
    };
    let over = match placement.over {
        Over::Mean => "root mean square",
        Over::Worst => "worst",
    };
    let form = match scenario.field.form {
        RangeForm::Projected => "projected",
        RangeForm::Raw => "raw",
    };
    let name = if scenario.name.is_empty() { "no name" } else { &scenario.name };
    format!(
        "{name}: the bound on {target}, from {form} ranges\n{criterion}; {over} over the places of the body"
    )
}

/// Where the anchors of a search stand, and how far that is from where they were.
fn anchors(scenario: &Scenario, search: &Improvement) -> Vec<String> {
    let columns =
        |cells: &[String]| cells.iter().map(|cell| format!("{cell:>11}")).collect::<Vec<_>>().join(" ");
    let header: Vec<String> =
        ["x, m", "y, m", "z, m"][..scenario.dimension].iter().map(|&s| s.into()).collect();
    let row = |(m, (before, after)): (usize, (&Vec<f64>, &Vec<f64>))| {
        let moved: f64 = before.iter().zip(after).map(|(a, b)| (a - b) * (a - b)).sum();
        let cells: Vec<String> = after.iter().chain([&moved.sqrt()]).map(|x| format!("{x:.3}")).collect();
        format!("{m:<6} {}", columns(&cells))
    };
    let header = format!("anchor {} {:>11}", columns(&header), "moved, m");
    let pairs = scenario.anchors.iter().zip(&search.anchors).enumerate();
    [header].into_iter().chain(pairs.map(row)).collect()
}

/// Six digits that count, with an exponent where a plain number would be long.
fn digits(value: Option<f64>) -> String {
    let Some(value) = value else { return "no bound".into() };
    if !(1e-4..1e6).contains(&value) {
        return format!("{value:.5e}");
    }
    let mut decimals = 0;
    let mut scaled = value;
    while scaled < 1e5 {
        (scaled, decimals) = (10.0 * scaled, decimals + 1);
    }
    format!("{value:.decimals$}")
}
