//! Scenarios.

use rangelab::Error;
use rangelab::model::document::entries::PoseEntries;
use rangelab::model::estimator_settings::EstimatorSettings;
use rangelab::model::noise::RangeNoise;
use rangelab::model::path::{PathSettings, Side};
use rangelab::model::presets::{PRESETS, preset};
use rangelab::model::recording::RecordingDocument;
use rangelab::model::run::Run;
use rangelab::model::scenario::Scenario;
use rangelab::simulate::simulate;
use serde_json::{Value, json};

use super::{Rule, as_value, breaks_only, changed, problems_of};

#[test]
fn presets_survive_json() {
    for each in PRESETS {
        let scenario = each.scenario();
        assert_eq!(scenario.validate(), [], "{}", each.name);
        assert_eq!(Scenario::from_json(&scenario.to_json()), Ok(scenario), "{}", each.name);
    }
}

#[test]
fn what_is_left_out_of_a_scenario_is_filled_in() {
    let text = r#"{"version": 1, "dimension": 3, "anchors": [[0, 0, 0]], "sensors": [[0, 0, 1]],
        "noise": {"kind": "toa", "zeta_db": 60}, "motion": {"sigma_t": 0.5}, "initial": {"covariance": 2}}"#;
    let scenario = Scenario::from_json(text).unwrap();
    assert_eq!(scenario.start, PoseEntries::identity(3));
    assert_eq!((scenario.motion.angular_velocity.len(), scenario.motion.sigma_t), (3, 0.5));
    assert_eq!((scenario.initial.position.len(), scenario.initial.covariance), (3, 2.0));
    assert_eq!(scenario.estimators, EstimatorSettings::default());
}

fn breaks_only_in_the_room(rules: &[Rule]) {
    let document = as_value(&preset("room").unwrap().to_json());
    breaks_only(&document, rules, |text| problems_of(Scenario::from_json(text)));
}

#[test]
fn every_rule_of_what_is_measured_can_be_broken() {
    let many = |count: usize| json!(vec![[1.0, 2.0, 3.0]; count]);
    let rules: Vec<Rule> = vec![
        ("/version", json!(0), "version", "0"),
        ("/name", json!("x".repeat(201)), "name", "201 bytes"),
        ("/anchors", json!([]), "anchors", "0 long"),
        ("/anchors", many(1001), "anchors", "1001 long"),
        ("/anchors/2", json!([1, 2]), "anchors[2]", "2 long"),
        ("/anchors/2/0", json!(1e10), "anchors[2][0]", "1e10"),
        ("/redraw_anchors", json!({"half_width": 0}), "redraw_anchors.half_width", "0"),
        ("/sensors", json!([]), "sensors", "0 long"),
        ("/sensors/1/2", json!(-1e10), "sensors[1][2]", "-1e10"),
        ("/mounting_sigma", json!(-0.01), "mounting_sigma", "-0.01"),
        ("/mounting_sigma", json!(2e9), "mounting_sigma", "2e9"),
        ("/noise", json!({"kind": "range", "sigma": 0}), "noise.sigma", "0"),
        ("/noise", json!({"kind": "squared_range", "sigma": -1}), "noise.sigma", "-1"),
        ("/noise", json!({"kind": "toa", "zeta_db": 301}), "noise.zeta_db", "301"),
        ("/missing_probability", json!(1.5), "missing_probability", "1.5"),
        ("/missing_probability", json!(-0.1), "missing_probability", "-0.1"),
        ("/interval", json!(0), "interval", "0"),
        ("/steps", json!(0), "steps", "0"),
        ("/steps", json!(10_001), "steps", "10001"),
        ("/seed", json!((1_u64 << 53) + 1), "seed", "9007199254740993"),
    ];
    breaks_only_in_the_room(&rules);
}

#[test]
fn every_rule_of_what_moves_and_estimates_can_be_broken() {
    let rules: Vec<Rule> = vec![
        ("/motion/velocity", json!([1]), "motion.velocity", "1 long"),
        ("/motion/velocity/1", json!(1e10), "motion.velocity[1]", "1e10"),
        ("/motion/angular_velocity", json!([1, 2]), "motion.angular_velocity", "2 long"),
        ("/motion/angular_velocity/0", json!(1e7), "motion.angular_velocity[0]", "1e7"),
        ("/motion/sigma_omega", json!(-1), "motion.sigma_omega", "-1"),
        ("/motion/sigma_t", json!(-1), "motion.sigma_t", "-1"),
        ("/start/orientation", json!([[1, 0, 0], [0, 1, 0]]), "start.orientation", "2 rows"),
        ("/start/orientation/0", json!([1, 0]), "start.orientation[0]", "2 long"),
        ("/start/orientation", json!([[1, 0, 0], [0, 1, 0], [0, 0, 1.1]]), "start.orientation", "0.21"),
        ("/start/orientation", json!([[1, 0, 0], [0, 1, 0], [0, 0, -1]]), "start.orientation", "-1"),
        ("/start/position/0", json!(1e10), "start.position[0]", "1e10"),
        ("/initial/orientation", json!([[1, 0, 0]]), "initial.orientation", "1 rows"),
        ("/initial/orientation/2/1", json!(1e7), "initial.orientation[2][1]", "1e7"),
        ("/initial/position", json!([1]), "initial.position", "1 long"),
        ("/initial/covariance", json!(0), "initial.covariance", "0"),
        ("/process/sigma_q", json!(-1), "process.sigma_q", "-1"),
        ("/process/sigma_t", json!(-1), "process.sigma_t", "-1"),
        ("/estimators/enabled", json!(["kf", "eskf", "kf"]), "estimators.enabled[2]", "kf"),
        ("/estimators/threshold/epsilon", json!(-0.1), "estimators.threshold.epsilon", "-0.1"),
        ("/view", json!([1]), "view", "[1]"),
        ("/view", json!({"x": "y".repeat(10_000)}), "view", "bytes long"),
    ];
    breaks_only_in_the_room(&rules);
}

#[test]
fn every_rule_of_what_can_be_measured_can_be_broken() {
    let wall =
        |to: [f64; 2], top: f64| json!({"kind": "wall", "from": [0, 0], "to": to, "bottom": 0, "top": top});
    let block = |high: [f64; 3]| json!({"kind": "box", "low": [0, 0, 0], "high": high});
    let rules: Vec<Rule> = vec![
        ("/availability/max_ranges", json!([1.0]), "availability.max_ranges", "1 long"),
        ("/availability/max_ranges", json!([0, 1, 1, 1, 1, 1]), "availability.max_ranges[0]", "0"),
        ("/availability/obstacles", json!([wall([0.0, 0.0], 2.0)]), "availability.obstacles[0].to", "starts"),
        ("/availability/obstacles", json!([wall([1.0, 0.0], 0.0)]), "availability.obstacles[0].top", "0"),
        (
            "/availability/obstacles",
            json!([wall([1e10, 0.0], 2.0)]),
            "availability.obstacles[0].to[0]",
            "1e10",
        ),
        (
            "/availability/obstacles",
            json!([block([1.0, 0.0, 1.0])]),
            "availability.obstacles[0].high[1]",
            "0",
        ),
        ("/availability/obstacles", json!(vec![block([1.0; 3]); 101]), "availability.obstacles", "101 long"),
    ];
    breaks_only_in_the_room(&rules);
}

#[test]
fn every_rule_of_field_and_placement_can_be_broken() {
    let region = |high: f64| json!({"low": [0, 0, 0], "high": [1, 1, high]});
    let upright = json!({"kind": "vertical", "heading": 0, "offset": 1e10});
    let turned = json!({"kind": "vertical", "heading": 1e4, "offset": 0});
    let rules: Vec<Rule> = vec![
        ("/field/plane", json!({"kind": "horizontal", "height": 1e10}), "field.plane.height", "1e10"),
        ("/field/plane", upright, "field.plane.offset", "1e10"),
        ("/field/plane", turned, "field.plane.heading", "10000"),
        ("/field/headings", json!(0), "field.headings", "0"),
        ("/field/headings", json!(73), "field.headings", "73"),
        ("/field/position_limit", json!(0), "field.position_limit", "0"),
        ("/field/angle_limit", json!(-1), "field.angle_limit", "-1"),
        ("/placement/region", region(0.0), "placement.region.high[2]", "0"),
        ("/placement/limits", region(-1.0), "placement.limits.high[2]", "-1"),
        ("/placement/keep_out", json!([region(0.0)]), "placement.keep_out[0].high[2]", "0"),
        ("/placement/keep_out", json!(vec![region(1.0); 101]), "placement.keep_out", "101 long"),
        ("/placement/fixed", json!([6]), "placement.fixed[0]", "6"),
        ("/placement/fixed", json!([2, 2]), "placement.fixed[1]", "2"),
    ];
    breaks_only_in_the_room(&rules);
}

#[test]
fn a_flat_scenario_has_one_plane() {
    let mut scenario = preset("planar").unwrap();
    scenario.field.plane = rangelab::model::field_settings::FieldPlane::Body;
    assert_eq!(scenario.validate()[0].path, "field.plane");
}

#[test]
fn every_rule_of_a_path_can_be_broken() {
    let turn = |radius: f64, period: f64| json!({"kind": "turn", "radius": radius, "period": period});
    let eight = json!({"kind": "figure_eight", "radius": -1, "period": 8});
    let helix =
        |radius: f64, climb: f64| json!({"kind": "helix", "radius": radius, "period": 8, "climb": climb});
    let drawn = |points: Value| json!({"kind": "drawn", "points": points, "closed": true, "period": 8});
    let start = preset("room").unwrap().start.position;
    let near = vec![start[0] + 1e-7, start[1], start[2]];
    let many: Vec<[f64; 3]> = (0..201).map(|i| [f64::from(i), 0.0, 0.0]).collect();
    let rules: Vec<Rule> = vec![
        ("/motion/path", turn(0.0, 8.0), "motion.path.radius", "0"),
        ("/motion/path", turn(1e10, 8.0), "motion.path.radius", "1e10"),
        ("/motion/path", turn(1.0, 0.0), "motion.path.period", "0"),
        ("/motion/path", turn(1.0, 1e10), "motion.path.period", "1e10"),
        ("/motion/path", eight, "motion.path.radius", "-1"),
        ("/motion/path", helix(0.0, 1.0), "motion.path.radius", "0"),
        ("/motion/path", helix(1.0, -1e10), "motion.path.climb", "-1e10"),
        ("/motion/path", drawn(json!([])), "motion.path.points", "0 long"),
        ("/motion/path", drawn(json!(many)), "motion.path.points", "201 long"),
        ("/motion/path", drawn(json!([[1, 2, 3], [1, 2]])), "motion.path.points[1]", "2 long"),
        ("/motion/path", drawn(json!([[1, 2, 1e10]])), "motion.path.points[0][2]", "1e10"),
        ("/motion/path", drawn(json!([near])), "motion.path.points[0]", "where the path starts"),
        ("/motion/path", drawn(json!([[1, 2, 3], [1, 2, 3]])), "motion.path.points[1]", "the point before"),
        ("/motion/path", drawn(json!([[1, 2, 3], start])), "motion.path.points[1]", "returns by itself"),
    ];
    breaks_only_in_the_room(&rules);
    let document = as_value(&preset("planar").unwrap().to_json());
    let in_plane: Rule = ("/motion/path", helix(1.0, 1.0), "motion.path.kind", "helix");
    breaks_only(&document, &[in_plane], |text| problems_of(Scenario::from_json(text)));
}

#[test]
fn too_many_ranges_are_refused_before_they_are_drawn() {
    let mut scenario = preset("room").unwrap();
    scenario.anchors = vec![vec![1.0, 2.0, 3.0]; 1000];
    scenario.sensors = vec![vec![0.0; 3]; 1000];
    let problems = problems_of(simulate::<3>(&scenario, 0));
    assert_eq!(problems.len(), 1);
    assert!(problems[0].path == "steps" && problems[0].value.ends_with("= 60000000 ranges"), "{problems:?}");
}

#[test]
fn a_dimension_that_is_none_is_refused_everywhere() {
    let problems = problems_of(Scenario::from_json(&changed(
        &as_value(&preset("room").unwrap().to_json()),
        "/dimension",
        &json!(4_000_000_000_u32),
    )));
    assert_eq!(problems.len(), 1, "{problems:?}");
    assert_eq!(problems[0].to_string(), "dimension is 4000000000, allowed: 2 or 3");
    let planar = preset("planar").unwrap();
    assert!(planar.setup::<3>().unwrap_err().to_string().starts_with("2 dimensions in the document"));
}

#[test]
fn all_problems_are_listed_at_once() {
    let mut scenario = preset("room").unwrap();
    scenario.anchors[4][1] = f64::NAN;
    scenario.sensors[0].push(1.0);
    scenario.interval = f64::INFINITY;
    scenario.process.sigma_q = f64::NAN;
    scenario.steps = 0;
    let paths: Vec<String> = scenario.validate().into_iter().map(|problem| problem.path).collect();
    assert_eq!(paths, ["anchors[4][1]", "sensors[0]", "interval", "steps", "process.sigma_q"]);
    let sentence = simulate::<3>(&scenario, 0).unwrap_err().to_string();
    assert!(
        sentence.starts_with("the scenario has 5 problem(s); anchors[4][1] is NaN, allowed: from "),
        "{sentence}"
    );
}

#[test]
fn numbers_that_are_not_finite_are_refused_in_every_field() {
    let spoil: [fn(&mut Scenario, f64); 19] = [
        |s, x| s.anchors[0][0] = x,
        |s, x| s.sensors[0][0] = x,
        |s, x| s.mounting_sigma = x,
        |s, x| s.noise = RangeNoise::Range { sigma: x },
        |s, x| s.noise = RangeNoise::Toa { zeta_db: x },
        |s, x| s.missing_probability = x,
        |s, x| s.interval = x,
        |s, x| s.motion.velocity[0] = x,
        |s, x| s.motion.sigma_t = x,
        |s, x| s.motion.path = Some(PathSettings::FigureEight { radius: x, period: 1.0 }),
        |s, x| s.motion.path = Some(PathSettings::FigureEight { radius: 1.0, period: x }),
        |s, x| {
            s.motion.path =
                Some(PathSettings::Helix { radius: 1.0, period: 1.0, climb: x, side: Side::Left });
        },
        |s, x| {
            let points = vec![vec![0.0, 0.0, x]];
            s.motion.path = Some(PathSettings::Drawn { points, closed: false, period: 1.0 });
        },
        |s, x| s.start.orientation[0][0] = x,
        |s, x| s.start.position[0] = x,
        |s, x| s.initial.orientation[0][0] = x,
        |s, x| s.initial.covariance = x,
        |s, x| s.process.sigma_t = x,
        |s, x| s.estimators.threshold.epsilon = x,
    ];
    for (i, spoil) in spoil.iter().enumerate() {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut scenario = preset("room").unwrap();
            spoil(&mut scenario, x);
            assert_eq!(scenario.validate().len(), 1, "field {i} = {x}");
        }
    }
}

#[test]
fn text_that_is_no_scenario_gives_a_sentence() {
    let document = as_value(&preset("room").unwrap().to_json());
    let sentence = |text: &str| Scenario::from_json(text).unwrap_err().to_string();
    for (text, part) in [
        (String::from("{\"version\": 1,\n \"name\": }"), "line 2 column 10"),
        (String::from("[]"), "the scenario cannot be read"),
        (changed(&document, "/colour", &json!("red")), "unknown field `colour`"),
        (changed(&document, "/motion/colour", &json!("red")), "unknown field `colour`"),
        (changed(&document, "/motion/path", &json!({"kind": "loop"})), "unknown variant `loop`"),
        (changed(&document, "/motion/path", &json!({"kind": "turn", "radius": 1})), "missing field `period`"),
        (changed(&document, "/noise/colour", &json!("red")), "unknown field `colour`"),
        (changed(&document, "/noise/kind", &json!("loud")), "unknown variant `loud`"),
        (changed(&document, "/anchors/0/0", &json!(null)), "invalid type: null"),
        (changed(&document, "/estimators/enabled/0", &json!("ukf")), "unknown variant `ukf`"),
        (String::from("{\"name\": \"x\"}"), "missing field `version`"),
        (String::from("{\"version\": 1}"), "missing field `dimension`"),
    ] {
        assert!(sentence(&text).contains(part), "{}", sentence(&text));
        assert!(matches!(Scenario::from_json(&text), Err(Error::Syntax { .. })));
    }
}

#[test]
fn a_newer_version_is_named_before_its_new_fields() {
    let error = Scenario::from_json(r#"{"version": 2, "anchors": "in orbit"}"#).unwrap_err();
    assert_eq!(error, Error::Version { document: "scenario", found: 2, newest: 1 });
    assert!(error.to_string().contains("version 2") && error.to_string().contains("newer"), "{error}");
    assert!(matches!(
        RecordingDocument::from_json(r#"{"version": 9}"#),
        Err(Error::Version { found: 9, .. })
    ));
    assert!(matches!(Run::from_json(r#"{"version": 3}"#), Err(Error::Version { found: 3, .. })));
}
