//! `rangelab figure`: every format holds the same numbers, and how to get them again.

use std::collections::BTreeMap;
use std::io::Read;
use std::process::{Command, Stdio};
use std::time::Duration;

use rangelab::model::scenario::Scenario;
use rangelab::study::figures::FIGURES;
use rangelab::study::figures::report::{FigureReport, FigureScenario, NamedScenario};

use crate::command::{folder, rangelab};

const COMMAND: &str = "rangelab figure tracking-3 --trials 40 --seed 7";

/// The figure of [`COMMAND`] with other options.
fn figure(options: &[&str]) -> String {
    let words: Vec<&str> = COMMAND.split(' ').skip(1).collect();
    rangelab(&[&words, options].concat()).data()
}

fn report() -> FigureReport {
    serde_json::from_str(&figure(&["--format", "json"])).unwrap()
}

#[test]
fn figures_are_listed() {
    let list = rangelab(&["figure"]).data();
    for figure in &FIGURES {
        assert!(list.contains(&format!("\n{}  ", figure.name)) || list.starts_with(figure.name), "{list}");
    }
    assert!(list.lines().filter(|line| line.starts_with(' ')).all(|line| line.chars().count() <= 100));
}

#[test]
fn json_is_the_report_and_repeats_itself() {
    let report = report();
    assert_eq!((report.name.as_str(), report.trials, report.seed), ("tracking-3", 40, 7));
    assert_eq!(report.command, COMMAND);
    assert!(report.panels.len() == 4 && report.claims.len() == 14 && report.scenarios.len() == 2);
    assert!(
        report
            .scenarios
            .iter()
            .all(|named| matches!(&named.scenario, FigureScenario::Body(body) if body.seed == 7))
    );
    let threads = |count| figure(&["--format", "json", "--threads", count]);
    assert_eq!(threads("1"), threads("3"), "threads change nothing");
    let other = rangelab(&["figure", "tracking-3", "--trials", "40", "--format", "json"]).data();
    assert_ne!(serde_json::from_str::<FigureReport>(&other).unwrap().panels, report.panels, "seeds differ");
}

#[test]
fn text_says_what_is_claimed_and_found() {
    let (text, report) = (figure(&[]), report());
    assert!(text.starts_with(&report.heading()) && text.contains(COMMAND));
    for claim in &report.claims {
        let line = text.lines().find(|line| line.trim_start().starts_with(&claim.what)).unwrap();
        let found = claim.found.unwrap().to_string();
        assert!(line.contains(&found) && line.ends_with(&claim.verdict.to_string()), "{line}");
    }
    let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>().join(" ");
    assert!(words(&text).ends_with(&words(&report.caption)));
}

#[test]
fn csv_holds_every_point_and_the_scenarios() {
    let (text, report) = (figure(&["--format", "csv"]), report());
    assert!(text.contains(&format!("# {COMMAND}\n")));
    let mut rows = text.lines().filter(|line| !line.starts_with('#'));
    assert!(rows.next().unwrap().starts_with("panel,curve,kind,x,y,y_standard_error,trials"));
    let curves = report.panels.iter().flat_map(|panel| panel.curves.iter().map(move |curve| (panel, curve)));
    for (panel, curve) in curves {
        for point in &curve.points {
            let row: Vec<&str> = rows.next().unwrap().split(',').collect();
            let number = |i: usize| row[i].parse::<f64>().unwrap().to_bits();
            assert_eq!((row.len(), row[0], row[1]), (10, panel.name.as_str(), curve.name.as_str()));
            let expected = [point.x, point.y.value, point.y.standard_error].map(f64::to_bits);
            assert_eq!([number(3), number(4), number(5)], expected);
        }
    }
    assert_eq!(rows.next(), None);
    for named in &report.scenarios {
        let start = format!("# scenario {}: ", named.name);
        let scenario = text.lines().find_map(|line| line.strip_prefix(&start)).unwrap();
        assert_eq!(FigureScenario::from(Scenario::from_json(scenario).unwrap()), named.scenario);
    }
}

fn unescaped(text: &str) -> String {
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
}

/// What is between the first `<tag>` and its end.
fn inside(text: &str, tag: &str) -> String {
    let (_, rest) = text.split_once(&format!("<{tag}>")).unwrap_or_else(|| panic!("no {tag}"));
    unescaped(rest.split_once(&format!("</{tag}>")).unwrap().0)
}

#[test]
fn svg_holds_curves_claims_and_scenarios() {
    let (svg, report) = (figure(&["--format", "svg"]), report());
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    assert_eq!((inside(&svg, "title"), inside(&svg, "desc")), (report.heading(), report.caption.clone()));
    let metadata: serde_json::Value = serde_json::from_str(&inside(&svg, "metadata")).unwrap();
    assert_eq!(metadata["command"], COMMAND);
    let scenarios: Vec<NamedScenario> = serde_json::from_value(metadata["scenarios"].clone()).unwrap();
    assert_eq!(scenarios, report.scenarios);
    let texts = unescaped(&svg);
    for panel in &report.panels {
        for name in [&panel.title, &panel.x.name(), &panel.y.name()] {
            assert!(texts.contains(&format!(">{name}</text>")), "{name}");
        }
        for curve in &panel.curves {
            let group =
                texts.split("<g>").find(|group| group.contains(&format!("<title>{}</title>", curve.label)));
            let line = group.unwrap().lines().find(|line| line.starts_with("<polyline")).unwrap();
            assert_eq!(inside_quotes(line, "points").split(' ').count(), curve.points.len(), "{line}");
        }
    }
    assert!(report.claims.iter().all(|claim| texts.contains(&format!(">{}</text>", claim.what))));
}

fn inside_quotes<'a>(line: &'a str, attribute: &str) -> &'a str {
    let (_, rest) =
        line.split_once(&format!("{attribute}=\"")).unwrap_or_else(|| panic!("{attribute}: {line}"));
    rest.split_once('"').unwrap().0
}

/// The colours of the page's light theme by name.
fn tokens() -> BTreeMap<String, String> {
    let css = std::fs::read_to_string("web/page/src/theme/tokens.css").unwrap();
    let light = css.split(":root[data-theme=\"light\"] {").nth(1).unwrap().split('}').next().unwrap();
    let tokens =
        light.lines().filter_map(|line| line.trim().strip_prefix("--")?.strip_suffix(';')?.split_once(": "));
    tokens.map(|(name, value)| (name.to_owned(), value.to_owned())).collect()
}

#[test]
fn colours_are_those_of_the_page() {
    let (svg, tokens) = (figure(&["--format", "svg"]), tokens());
    for curve in report().panels.iter().flat_map(|panel| &panel.curves) {
        let token = if curve.name.ends_with("crb") { "bound" } else { &curve.name };
        let groups =
            svg.split("<g>").filter(|group| group.contains(&format!("<title>{}</title>", curve.label)));
        for group in groups {
            assert!(group.contains(&tokens[token]), "{token}: {group}");
            assert_eq!(group.contains("stroke-dasharray=\"7 4\""), token == "bound", "{group}");
        }
    }
    for token in ["ink", "ink-soft", "line", "grid", "surface"] {
        assert!(svg.contains(&tokens[token]), "{token} {}", tokens[token]);
    }
}

/// Rows of title and key, where each curve is shown too.
const BELOW_KEY: usize = 100;

#[test]
fn a_png_shows_the_curves_and_holds_the_scenarios() {
    let file = folder("figure").join("figure.png");
    assert_eq!(figure(&["-o", file.to_str().unwrap()]), "", "the ending says the format");
    let decoder = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(&file).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let width = reader.next_frame(&mut bytes).unwrap().width as usize;
    let pixels: &[[u8; 3]] = bytes.as_chunks().0;
    let report = report();
    let text = |keyword: &str| {
        let chunk = reader.info().utf8_text.iter().find(|chunk| chunk.keyword == keyword).unwrap();
        chunk.get_text().unwrap()
    };
    assert_eq!((text("Command").as_str(), text("Description")), (COMMAND, report.caption));
    let scenarios: Vec<NamedScenario> = serde_json::from_str(&text("Scenarios")).unwrap();
    assert_eq!(scenarios, report.scenarios);
    for name in ["kf", "ortho", "uc-kf", "et-kf", "eskf"] {
        let hex = &tokens()[name];
        let part = |i: usize| u8::from_str_radix(&hex[i..i + 2], 16).unwrap();
        let colour = [part(1), part(3), part(5)];
        // Thin lines are mixed with what is below; their middles and the marks are not.
        let near = |pixel: &&[u8; 3]| pixel.iter().zip(colour).all(|(a, b)| a.abs_diff(b) <= 6);
        let count = pixels[width * BELOW_KEY..].iter().filter(near).count();
        assert!(count > 30, "{name}: {count} pixels");
    }
}

#[test]
fn what_is_no_figure_is_refused() {
    rangelab(&["figure", "tracking-4"])
        .refused("no figure is called \"tracking-4\"; there are: tracking-2, ");
    rangelab(&["figure", "tracking-2", "--trials", "0"]).refused("the number of trials is 0");
    rangelab(&["figure", "tracking-2", "--seed", "9007199254740993"]).refused("seed is 9007199254740993");
    let outcome = rangelab(&["figure", "tracking-2", "--format", "gif"]);
    assert!(outcome.code == 2 && outcome.stderr.contains("text, json, csv, svg, png"), "{outcome:?}");
}

#[test]
#[cfg(unix)]
fn an_interrupt_ends_it_with_a_sentence_and_no_file() {
    let file = folder("interrupt").join("figure.svg");
    let arguments = ["figure", "tracking-2", "--trials", "1000000", "-o", file.to_str().unwrap()];
    let mut child = Command::new(env!("CARGO_BIN_EXE_rangelab"))
        .args(arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // Until the program listens, an interrupt would end it at once.
    std::thread::sleep(Duration::from_millis(1500));
    let ended = (0..100).find_map(|_| {
        Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        std::thread::sleep(Duration::from_millis(500));
        child.try_wait().unwrap()
    });
    let mut stderr = String::new();
    child.stderr.take().unwrap().read_to_string(&mut stderr).unwrap();
    assert_eq!(ended.and_then(|status| status.code()), Some(130), "{stderr}");
    assert!(
        stderr.starts_with("rangelab: cancelled at ") && stderr.contains("nothing is written"),
        "{stderr}"
    );
    assert!(!file.exists());
}
