//! `rangelab place`: the table, the scenario that is written, and what is refused.

use rangelab::model::scenario::Scenario;
use rangelab::place::{best_next, improve};

use crate::command::{folder, rangelab, rangelab_with};

/// The searches in a table: number, value, share of the best.
fn searches(table: &str) -> Vec<(u64, f64, f64)> {
    let lines = table.lines().skip_while(|line| !line.starts_with("search")).skip(1);
    let row = |line: &str| {
        let cells: Vec<&str> = line.split_whitespace().collect();
        Some((cells[0].parse().ok()?, cells[1].parse().ok()?, cells[2].parse().ok()?))
    };
    lines.take_while(|line| !line.is_empty()).map(|line| row(line).expect(line)).collect()
}

fn number_after(text: &str, words: &str) -> f64 {
    let (_, rest) = text.split_once(words).unwrap_or_else(|| panic!("no {words:?} in {text}"));
    rest.split_whitespace().next().and_then(|number| number.parse().ok()).expect(rest)
}

#[test]
fn anchors_are_placed_and_written() {
    let folder = folder("place");
    let path = folder.join("better.json").to_str().unwrap().to_owned();
    let table = rangelab(&["place", "planar", "--restarts", "3", "-o", &path]).data();
    let scenario = Scenario::from_json(&rangelab(&["presets", "planar"]).data()).unwrap();
    let found = searches(&table);
    assert_eq!(found.len(), 4);
    let best = found.iter().map(|search| search.1).fold(f64::INFINITY, f64::min);
    for (restart, value, share) in found {
        let expected = improve(&scenario, restart).unwrap().after.unwrap();
        assert!((value / expected - 1.0).abs() < 1e-5, "{value} printed, {expected} found");
        assert!((share - 100.0 * best / value).abs() < 0.06, "{table}");
    }
    let (before, after) = (number_after(&table, "before: "), number_after(&table, "after: "));
    let next = best_next(&scenario).unwrap().unwrap();
    for (words, value) in [
        ("plane of the field: best at (", next.point[0]),
        ("m, ", next.before.unwrap()),
        ("now, ", next.after.unwrap()),
    ] {
        let line = table.lines().last().unwrap();
        let text = line.split_once(words).unwrap().1;
        let printed: f64 = text.split([',', ' ']).next().unwrap().parse().unwrap();
        assert!((printed - value).abs() < 1e-3 * value.abs(), "{words}{printed}: {value}");
    }
    assert!(after < 0.98 * before && (after / best - 1.0).abs() < 1e-9, "{table}");
    let written = Scenario::from_json(&std::fs::read_to_string(&path).unwrap()).unwrap();
    assert_eq!(Scenario { anchors: scenario.anchors.clone(), ..written.clone() }, scenario);
    assert_ne!(written.anchors, scenario.anchors);
    let again = rangelab(&["place", &path, "--restarts", "0"]).data();
    assert!((number_after(&again, "before: ") / after - 1.0).abs() < 1e-9, "{again}");
}

#[test]
fn threads_change_nothing() {
    let place = |threads: &str| {
        rangelab(&["place", "room", "--restarts", "4", "--threads", threads, "--criterion", "d"]).data()
    };
    assert_eq!(place("1"), place("3"));
}

#[test]
fn options_choose_what_is_made_small() {
    let head = |options: &[&str]| {
        let table = rangelab(&[&["place", "planar", "--restarts", "0"], options].concat()).data();
        table.lines().take(4).collect::<Vec<_>>().join("\n")
    };
    assert!(head(&[]).contains("position") && head(&[]).contains("A: ") && head(&[]).contains("value, m"));
    assert!(head(&["--target", "orientation"]).contains("value, rad"));
    assert!(head(&["--criterion", "e", "--over", "worst"]).contains("E: largest standard deviation; worst"));
}

#[test]
fn what_cannot_be_placed_is_refused() {
    rangelab(&["place", "rod"]).failed(1, "a turn about that line moves no sensor");
    let scenario = rangelab(&["presets", "planar"]).data();
    let everywhere = r#""keep_out":[{"low":[-100,-100],"high":[100,100]}]"#;
    assert!(scenario.contains(r#""keep_out":[]"#));
    let spoiled = scenario.replace(r#""keep_out":[]"#, everywhere);
    rangelab_with(&spoiled, &["place", "-"]).refused("placement.keep_out is 1 zones around anchors[0]");
    let outcome = rangelab(&["place", "planar", "--restarts", "-1"]);
    assert!(outcome.code == 2 && outcome.stdout.is_empty());
}
