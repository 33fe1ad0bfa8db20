//! `rangelab field`: the numbers of the bounds, in every form.

use rangelab::bounds::field::{NONE, field_of};
use rangelab::math::float::{degrees, radians};
use rangelab::model::field_settings::{FieldPlane, FieldSettings, Quantity};
use rangelab::model::presets::preset;
use rangelab::model::ranging::RangeForm;
use rangelab::model::scenario::Scenario;
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
    refused(&["--at", "1,2,3", "--format", "png"], "--at gives a sentence, or json");
    rangelab(&["field", "planar", "--plane", "body"]).refused("field.plane is tilted or raised");
    rangelab_with("{}", &["field", "-"]).refused("stdin: ");
    let conflict = rangelab(&["field", "room", "--at", "1,2,3", "--headings", "4"]);
    assert!(conflict.code == 2 && conflict.stderr.contains("cannot be used with"), "{conflict:?}");
}
