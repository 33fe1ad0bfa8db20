//! `rangelab field`: the numbers of the bounds, in every form.

use rangelab::bounds::field::{NONE, field_of, layout_of};
use rangelab::math::float::{degrees, radians};
use rangelab::model::availability::Obstacle;
use rangelab::model::field_settings::{FieldPlane, FieldSettings, Quantity, Subject};
use rangelab::model::placement_settings::{Region, Target};
use rangelab::model::presets::preset;
use rangelab::model::ranging::RangeForm;
use rangelab::model::scenario::Scenario;
use rangelab::place::{advise, best_next};
use rangelab::study::exploration::bound_at;
use rangelab::with_dimension;

use crate::command::{folder, rangelab, rangelab_with};

/// Point and bound.
type Row = ([f64; 3], Option<f64>);

fn with_field(name: &str, change: impl FnOnce(&mut FieldSettings)) -> Scenario {
    let mut scenario = preset(name).unwrap();
    change(&mut scenario.field);
    scenario
}

/// Anchors in one plane, projected ranges: no bound anywhere.
fn flat_ceiling() -> Scenario {
    let mut scenario = with_field("coplanar-ceiling", |field| field.form = RangeForm::Projected);
    scenario.anchors.iter_mut().for_each(|anchor| anchor[2] = 2.5);
    scenario
}

/// The scenario in the comments of a table, and its rows.
fn table(text: &str) -> (Scenario, Vec<Row>) {
    let scenario = text.lines().find_map(|line| line.strip_prefix("# scenario: ")).unwrap();
    let rows = text.lines().skip_while(|line| line.starts_with('#')).skip(1).map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        let [x, y, z, value] = cells[..] else { panic!("{line}") };
        ([x, y, z].map(|cell| cell.parse().unwrap()), (!value.is_empty()).then(|| value.parse().unwrap()))
    });
    (Scenario::from_json(scenario).unwrap(), rows.collect())
}

/// The bound at a point in the unit of the table.
fn value(scenario: &Scenario, point: [f64; 3]) -> Option<f64> {
    let field = with_dimension!(scenario.dimension, D => field_of::<D>(scenario)).unwrap();
    let value = field.value(point);
    let shown = if scenario.field.quantity == Quantity::Position { value } else { degrees(value) };
    (value < NONE).then_some(shown)
}

#[test]
fn a_table_holds_the_numbers_of_the_field_and_its_scenario() {
    let vertical = FieldPlane::Vertical { heading: radians(30.0), offset: -2.0 };
    let raised = FieldSettings { plane: FieldPlane::Horizontal { height: 0.7 }, ..flat_ceiling().field };
    let cases: [(&[&str], Scenario); 5] = [
        (&["planar"], with_field("planar", |_| ())),
        (&["room", "--quantity", "orientation"], with_field("room", |f| f.quantity = Quantity::Orientation)),
        (
            &["room", "--heading-deg", "30", "--offset", "-2", "--form", "projected"],
            with_field("room", |f| (f.plane, f.form) = (vertical, RangeForm::Projected)),
        ),
        (
            &["room", "--plane", "body", "--headings", "3", "--limit", "0.01"],
            with_field("room", |f| {
                (f.plane, f.headings, f.position_limit) = (FieldPlane::Body, 3, Some(0.01));
            }),
        ),
        (&["-", "--height", "0.7"], Scenario { field: raised, ..flat_ceiling() }),
    ];
    for (options, scenario) in cases {
        let command = [&["field", "--resolution", "16"], options].concat();
        let text = rangelab_with(&flat_ceiling().to_json(), &command).data();
        let (written, rows) = table(&text);
        assert_eq!(written, scenario, "{options:?}");
        assert!(rows.len() >= 16 * 4, "{options:?}: {} rows", rows.len());
        for (point, found) in &rows {
            assert_eq!(*found, value(&scenario, *point), "{options:?} at {point:?}");
        }
        let unseen = options.contains(&"-");
        assert!(rows.iter().all(|(_, found)| found.is_none() == unseen), "{options:?}");
    }
}

/// Where one more anchor may stand, a wall, and a target in degrees.
fn next_anchor() -> Scenario {
    let mut scenario = with_field("room", |field| field.headings = 2);
    let wall = Obstacle::Wall { from: vec![2.5, 2.1], to: vec![4.5, 3.3], bottom: None, top: None };
    scenario.availability.obstacles = vec![wall];
    scenario.placement.target = Target::Orientation;
    scenario.placement.keep_out = vec![Region { low: vec![3.2, 0.6, 0.0], high: vec![4.2, 1.4, 3.0] }];
    scenario
}

#[test]
fn one_more_anchor_is_told_by_table_point_and_picture() {
    let scenario = next_anchor();
    let field = |options: &[&str]| {
        let command = [&["field", "-", "--quantity", "next-anchor"], options].concat();
        rangelab_with(&scenario.to_json(), &command).data()
    };
    let text = field(&["--resolution", "16"]);
    let title = "# Bound (UC-CRB) on the orientation with one more anchor here, deg: room\n";
    assert!(text.starts_with(title) && text.contains("2 headings; A-optimal\n"), "{text}");
    assert!(text.contains("\nx_m,y_m,z_m,orientation_bound_with_one_more_anchor_deg\n"), "{text}");
    let (written, rows) = table(&text);
    assert_eq!(written.field.subject, Subject::NextAnchor);
    let mut refused = 0;
    for (k, ([x, y, z], cell)) in rows.iter().enumerate() {
        let inside = (3.2..4.2).contains(x) && (0.6..1.4).contains(y);
        assert_eq!(cell.is_none(), inside, "{x} {y}");
        refused += usize::from(inside);
        if k % 9 > 0 && !inside {
            continue;
        }
        let text = field(&["--at", &format!("{x},{y},{z}"), "--format", "json"]);
        let document: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(document["bound_with_one_more_anchor"].as_f64(), *cell, "{text}");
        assert_eq!(document["unit"], serde_json::json!("deg"));
        let now = degrees(advise(&scenario).unwrap().value.unwrap());
        assert_eq!(document["bound_now"].as_f64(), Some(now));
        assert_eq!(document["cause"].is_null(), cell.is_some());
    }
    assert!(refused > 0);
    let sentence = field(&["--at", "3.5,1,1"]);
    assert!(sentence.ends_with("there: none\nno anchor may stand inside keep-out zone 1\n"), "{sentence}");
    let document: serde_json::Value = serde_json::from_str(&field(&["--format", "json"])).unwrap();
    let best = best_next(&scenario).unwrap().unwrap().point;
    assert_eq!(document["best_next_anchor"], serde_json::json!(best));
}

#[test]
fn the_name_of_the_column_holds_the_unit() {
    let header = |quantity: &str| {
        let text = rangelab(&["field", "planar", "--resolution", "4", "--quantity", quantity]).data();
        text.lines().find(|line| !line.starts_with('#')).unwrap().to_owned()
    };
    assert_eq!(header("position"), "x_m,y_m,z_m,position_bound_m");
    assert_eq!(header("orientation"), "x_m,y_m,z_m,orientation_bound_deg");
}

#[test]
fn json_holds_the_numbers_of_the_table() {
    let field = |format: &str| rangelab(&["field", "room", "--resolution", "9", "--format", format]).data();
    let document: serde_json::Value = serde_json::from_str(&field("json")).unwrap();
    let rows: Vec<Vec<Option<f64>>> = serde_json::from_value(document["values"].clone()).unwrap();
    let values: Vec<Option<f64>> = table(&field("csv")).1.iter().map(|(_, value)| *value).collect();
    assert_eq!(rows.concat(), values);
    assert_eq!((&document["unit"], rows[0].len()), (&serde_json::json!("m"), 9));
    let scenario = Scenario::from_json(&document["scenario"].to_string()).unwrap();
    assert_eq!(scenario, preset("room").unwrap());
}

#[test]
fn the_bounds_at_a_point_are_those_of_the_study() {
    for (name, at, point) in [("room", "4,3,1", vec![4.0, 3.0, 1.0]), ("planar", "-1,2.5", vec![-1.0, 2.5])] {
        let bound = bound_at(&preset(name).unwrap(), &point).unwrap();
        let text = rangelab(&["field", name, "--at", at, "--format", "json"]).data();
        let document: serde_json::Value = serde_json::from_str(&text).unwrap();
        let number = |key: &str| serde_json::from_value::<Option<f64>>(document[key].clone()).unwrap();
        assert_eq!(number("position_bound_m"), bound.position_sigma);
        assert_eq!(number("orientation_bound_deg"), bound.angle_sigma.map(degrees));
        assert!(bound.position_sigma.is_some());
        let text = rangelab(&["field", name, "--at", at]).data();
        let expected = format!("position bound: {} m\n", bound.position_sigma.unwrap());
        assert!(text.starts_with(&expected) && text.ends_with(&format!("{}\n", bound.sentence)), "{text}");
    }
    let unseen = rangelab_with(&flat_ceiling().to_json(), &["field", "-", "--at", "1,1,1"]).data();
    assert!(unseen.starts_with("position bound: none\norientation bound: none\n"), "{unseen}");
}

#[test]
fn a_cell_and_the_bound_at_its_middle_agree() {
    for (quantity, key) in [("position", "position_bound_m"), ("orientation", "orientation_bound_deg")] {
        let (_, rows) =
            table(&rangelab(&["field", "room", "--resolution", "8", "--quantity", quantity]).data());
        for ([x, y, z], cell) in rows.iter().step_by(9) {
            let text =
                rangelab(&["field", "room", "--at", &format!("{x},{y},{z}"), "--format", "json"]).data();
            let document: serde_json::Value = serde_json::from_str(&text).unwrap();
            let (at, cell) = (document[key].as_f64().unwrap(), cell.unwrap());
            assert!((at / cell - 1.0).abs() <= 1e-9, "{quantity} at {x}, {y}, {z}: {at} and {cell}");
        }
    }
}

/// Width, pixels, and the scenario that the picture holds.
fn picture(options: &[&str]) -> (usize, Vec<[u8; 3]>, Scenario) {
    let file = folder(&format!("field{}", options.concat())).join("field.png");
    let command = [&["field", "--format", "png", "-o", file.to_str().unwrap()], options].concat();
    assert_eq!(rangelab_with(&flat_ceiling().to_json(), &command).data(), "");
    let decoder = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(&file).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let shape = reader.next_frame(&mut bytes).unwrap();
    assert_eq!(shape.color_type, png::ColorType::Rgb);
    let chunks = &reader.info().utf8_text;
    let chunk = chunks.iter().find(|chunk| chunk.keyword == "Scenario").unwrap();
    let scenario = Scenario::from_json(&chunk.get_text().unwrap()).unwrap();
    (shape.width as usize, bytes.as_chunks().0.to_vec(), scenario)
}

#[test]
fn a_picture_holds_its_scenario_and_shows_what_is_not_seen() {
    const NO_BOUND: [u8; 3] = [0xc9, 0xce, 0xd6];
    let count = |pixels: &[[u8; 3]], colour| pixels.iter().filter(|pixel| **pixel == colour).count();
    let (width, seen, scenario) = picture(&["room"]);
    assert_eq!((scenario, seen.len() % width), (preset("room").unwrap(), 0));
    assert_eq!(count(&seen, NO_BOUND), 0);
    let (_, unseen, scenario) = picture(&["-"]);
    assert_eq!(scenario, flat_ceiling());
    assert!(count(&unseen, NO_BOUND) > unseen.len() / 4, "most of the picture is the field");
    // Lines 8 pixels apart over the whole field: about an eighth of more than half of the picture.
    let (_, hatched, scenario) = picture(&["room", "--limit", "0.001"]);
    assert_eq!(scenario.field.position_limit, Some(0.001));
    let (_, good, _) = picture(&["room", "--limit", "1000"]);
    let frame = 88 * width;
    let field = good.len() - 92 * width;
    let changed = (frame..field).filter(|i| good[*i] != hatched[*i]).count();
    assert!(changed > seen.len() / 20, "{changed} of {} pixels", seen.len());
    assert!((frame..field).all(|i| seen[i] == good[i]), "nothing is worse than a kilometre");
}

/// Of the pixels along a line of the room's picture, the part that is dark.
fn dark_along(scenario: &Scenario, name: &str, options: &[&str], from: [f64; 2], to: [f64; 2]) -> f64 {
    const INK: [u8; 3] = [0x16, 0x19, 0x1f];
    let file = folder(&format!("obstacles {name}")).join("field.png");
    let command = [&["field", "-", "--format", "png", "-o", file.to_str().unwrap()], options].concat();
    rangelab_with(&scenario.to_json(), &command).data();
    let decoder = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(&file).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let width = reader.next_frame(&mut bytes).unwrap().width as usize;
    let pixels: &[[u8; 3]] = bytes.as_chunks().0;
    // The field's rectangle, 8 m x 7 m from (-1, -1), is 640 pixels wide and begins 88 pixels from both edges.
    let layout = with_dimension!(scenario.dimension, D => layout_of::<D>(scenario, 8)).unwrap();
    assert_eq!((layout.corner[0], layout.u[0], layout.v[1]), (-1.0, 8.0, 7.0));
    let dark = |k: i32| {
        let at = |axis: usize| from[axis] + f64::from(k) / 200.0 * (to[axis] - from[axis]);
        let pixel = |x: f64| (0..width).find(|i| *i as f64 + 0.5 > x).unwrap();
        let (column, row) = (88.0 + 80.0 * (at(0) + 1.0), 88.0 + 80.0 * (6.0 - at(1)));
        pixels[pixel(row) * width + pixel(column)] == INK
    };
    (0..=200).filter(|k| dark(*k)).count() as f64 / 201.0
}

#[test]
fn a_picture_shows_what_blocks_lines_of_sight_and_keeps_anchors_out() {
    let mut scenario = next_anchor();
    let wall = |scenario: &Scenario, name| dark_along(scenario, name, &[], [2.5, 2.1], [4.5, 3.3]);
    assert!(wall(&scenario, "wall") > 0.97);
    let zone = |name, options: &[&str]| dark_along(&next_anchor(), name, options, [3.2, 0.6], [4.2, 0.6]);
    let (dashed, hidden) = (zone("zone", &["--quantity", "next-anchor"]), zone("no zone", &[]));
    assert!((0.35..0.8).contains(&dashed) && hidden < 0.1, "{dashed} {hidden}");
    let Obstacle::Wall { top, .. } = &mut scenario.availability.obstacles[0] else { unreachable!() };
    *top = Some(0.5);
    let below = wall(&scenario, "below");
    assert!((0.35..0.8).contains(&below), "dashed where it ends below the plane: {below}");
    scenario.availability.obstacles.clear();
    assert!(wall(&scenario, "none") < 0.1);
    let corner = vec![2.5, 2.1, -1.0];
    scenario.availability.obstacles = vec![Obstacle::Box { low: corner, high: vec![4.5, 3.3, 3.0] }];
    // Inside a box nothing is measured: hatches, but no line.
    assert!(wall(&scenario, "diagonal of a box") < 0.5);
    assert!(dark_along(&scenario, "box", &[], [2.5, 2.1], [4.5, 2.1]) > 0.97);
}

#[test]
fn what_makes_no_field_is_refused() {
    let refused = |options: &[&str], words: &str| {
        rangelab(&[&["field", "room"], options].concat()).refused(words);
    };
    refused(&["--resolution", "0"], "the resolution of the field is 0; it must be from 1 to 1024 cells");
    refused(&["--resolution", "1025"], "the resolution of the field is 1025");
    refused(&["--headings", "0"], "field.headings is 0, allowed: 1 to 72");
    refused(&["--limit", "-1"], "field.position_limit is -1");
    refused(&["--quantity", "orientation", "--limit", "nan"], "field.angle_limit is NaN");
    refused(&["--height", "1", "--offset", "2"], "--height is of a horizontal plane");
    refused(&["--plane", "level", "--height", "1"], "--height: only for --plane horizontal");
    refused(&["--plane", "body", "--offset", "1"], "only for --plane vertical");
    refused(&["--height", "inf"], "field.plane.height is inf");
    refused(&["--at", "1,2"], "2 coordinates of the point where 3 are needed");
    refused(&["--at", "1,nan,3"], "a coordinate of --at is not a number");
    refused(&["--at", "1,2,1e300"], "a coordinate of --at is ");
    refused(&["--at", "1,2,3", "--quantity", "position"], "--at gives both bounds of the body");
    refused(&["--at", "1,2,3", "--format", "png"], "--at gives a sentence, or json");
    rangelab(&["field", "planar", "--plane", "body"]).refused("field.plane is tilted or raised");
    rangelab_with("{}", &["field", "-"]).refused("stdin: ");
    let conflict = rangelab(&["field", "room", "--at", "1,2,3", "--headings", "4"]);
    assert!(conflict.code == 2 && conflict.stderr.contains("cannot be used with"), "{conflict:?}");
}
