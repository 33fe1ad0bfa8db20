//! Geometries in which something cannot be seen: a finite bound, or an error that names the cause.

use rangelab::Error;
use rangelab::bounds::{Bound, BoundKind, bounds_along, crb, observability, unitary_crb};
use rangelab::math::float::radians;
use rangelab::math::pose::Pose;
use rangelab::math::rotation::Rotation;
use rangelab::model::noise::RangeNoise;
use rangelab::model::ranges::Ranges;
use rangelab::model::ranging::{RangeForm, RangeModel, Weighting};

use crate::dense::{of_blocks, of_tangent};
use crate::scenes::{Scene, TRACKING_ANCHORS, model, recording, tracking};

const ROOM: [[f64; 3]; 5] =
    [[4.0, 3.0, 2.5], [-4.0, 3.5, 0.3], [-3.5, -3.0, 2.2], [4.2, -3.2, 0.1], [0.5, 0.3, 2.7]];
const BODY: [[f64; 3]; 5] =
    [[0.5, 0.5, -0.2], [-0.5, 0.5, -0.2], [-0.5, -0.5, -0.2], [0.5, -0.5, -0.2], [0.0, 0.0, 0.8]];

fn turned(points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let pose = Pose { rotation: Rotation::exp(&[0.3, -0.4, 0.5]), position: [0.3, 0.2, 1.1].into() };
    points.iter().map(|&p| pose.act(&p.into()).into()).collect()
}

fn scene<const D: usize>(anchors: &[[f64; D]], sensors: &[[f64; D]]) -> Scene<D> {
    let mut pose = Pose::identity();
    pose.rotation = Rotation::exp(&[0.4, if D == 3 { 0.2 } else { 0.0 }, if D == 3 { -0.3 } else { 0.0 }]);
    for i in 0..D {
        pose.position[i] = 0.3 + 0.2 * i as f64;
    }
    Scene { model: model(anchors, sensors, RangeNoise::Range { sigma: 0.05 }, Weighting::PerPair), pose }
}

/// What each bound of one epoch says: `"finite"`, or the reason of the typed error.
fn verdicts<const D: usize>(scene: &Scene<D>) -> [String; 3] {
    let reason = |error: Error| match error {
        Error::Unobservable { reason, ranges, .. } => {
            assert_eq!(ranges, scene.model.anchors().len() * scene.model.topology().len());
            reason
        }
        other => panic!("not the error of an unseen motion: {other}"),
    };
    let (projected, raw) = (scene.information(RangeForm::Projected), scene.information(RangeForm::Raw));
    let finite = |ok: bool| {
        assert!(ok, "a bound that is not finite");
        "finite".to_owned()
    };
    let tangent =
        |bound: rangelab::math::tangent::TangentMatrix<D>| of_tangent(&bound).iter().all(|x| x.is_finite());
    let facts = observability(&raw);
    assert!(facts.sentence.ends_with('.') && !facts.sentence.contains("NaN"), "{}", facts.sentence);
    assert!(!facts.anchor_condition.is_nan() && !facts.sensor_condition.is_nan());
    [
        crb(&projected).map_or_else(reason, |c| finite(of_blocks(&c).iter().all(|x| x.is_finite()))),
        unitary_crb(&projected).map_or_else(reason, |c| finite(tangent(c))),
        unitary_crb(&raw).map_or_else(reason, |c| finite(tangent(c))),
    ]
}

/// Words that each of the three verdicts must contain: CRB, UC-CRB, UC-CRB raw.
fn expect<const D: usize>(name: &str, anchors: &[[f64; D]], sensors: &[[f64; D]], words: [&str; 3]) {
    let found = verdicts(&scene(anchors, sensors));
    println!("{name}: {found:#?}");
    for (verdict, word) in found.iter().zip(words) {
        assert!(verdict.contains(word), "{name}: \"{verdict}\" does not say \"{word}\"");
    }
}

#[test]
fn few_or_flat_anchors() {
    expect("whole room", &ROOM, &BODY, ["finite", "finite", "finite"]);
    expect("1 anchor", &ROOM[..1], &BODY, ["1 anchor where", "1 anchor where", "1 anchor where"]);
    expect("2 anchors", &ROOM[..2], &BODY, ["2 anchors where", "2 anchors where", "2 anchors where"]);
    expect("3 anchors", &ROOM[..3], &BODY, ["3 anchors where", "3 anchors where", "finite"]);
    let plane =
        turned(&[[4.0, 3.0, 0.0], [-4.0, 3.5, 0.0], [-3.5, -3.0, 0.0], [4.2, -3.2, 0.0], [1.0, 0.3, 0.0]]);
    expect("coplanar anchors", &plane, &BODY, ["one plane", "one plane", "finite"]);
    // The mean of equal heights is not always that height: what rounding leaves is no information.
    for height in [0.0, 0.1, 2.7, 1e3 / 3.0] {
        let ceiling =
            [[4.0, 3.0], [-4.0, 3.5], [-3.5, -3.0], [4.2, -3.2], [1.0, 0.3]].map(|[x, y]| [x, y, height]);
        expect("anchors at one height", &ceiling, &BODY, ["one plane", "one plane", "finite"]);
    }
    let line = turned(&[[-4.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.5, 0.0, 0.0]]);
    expect("collinear anchors", &line, &BODY, ["one line", "one line", "one line"]);
    let equal = [ROOM[0], ROOM[1], ROOM[2], ROOM[2]];
    expect("two of four equal", &equal, &BODY, ["one plane", "one plane", "finite"]);
    let doubled = [ROOM[0], ROOM[1], ROOM[2], ROOM[3], ROOM[3]];
    expect("two of five equal", &doubled, &BODY, ["finite", "finite", "finite"]);
    expect("all equal", &[ROOM[0]; 4], &BODY, ["one point", "one point", "one point"]);
}

#[test]
fn few_or_flat_sensors() {
    expect("1 sensor", &ROOM, &BODY[..1], ["1 sensor where", "1 sensor where", "1 sensor where"]);
    expect("2 sensors", &ROOM, &BODY[..2], ["2 sensors where", "2 sensors where", "2 sensors where"]);
    expect("3 sensors", &ROOM, &BODY[..3], ["3 sensors where", "finite", "finite"]);
    expect("flat body", &ROOM, &BODY[..4], ["one plane", "finite", "finite"]);
    let rod = turned(&[[-0.5, 0.0, 0.0], [0.1, 0.0, 0.0], [0.4, 0.0, 0.0], [0.7, 0.0, 0.0]]);
    expect("collinear sensors", &ROOM, &rod, ["one line", "one line", "one line"]);
}

#[test]
fn in_the_plane() {
    let room = [[4.0, 3.0], [-4.0, 3.5], [-3.5, -3.0], [4.2, -3.2]];
    let body = [[0.5, 0.1], [-0.5, 0.2], [0.0, -0.4]];
    expect("whole room", &room, &body, ["finite", "finite", "finite"]);
    expect("1 anchor", &room[..1], &body, ["1 anchor where", "1 anchor where", "1 anchor where"]);
    expect("2 anchors", &room[..2], &body, ["2 anchors where", "2 anchors where", "finite"]);
    let line = [[-4.0, -2.0], [0.0, 0.0], [2.0, 1.0], [6.0, 3.0]];
    expect("collinear anchors", &line, &body, ["one line", "one line", "finite"]);
    expect("1 sensor", &room, &body[..1], ["1 sensor where", "1 sensor where", "1 sensor where"]);
    expect("2 sensors", &room, &body[..2], ["2 sensors where", "finite", "finite"]);
}

#[test]
fn a_pose_at_which_good_geometry_sees_less() {
    // Body and anchors in one plane: to first order no squared range feels a motion across it.
    let flat_room = [[4.0, 3.0, 0.0], [-4.0, 3.5, 0.0], [-3.5, -3.0, 0.0], [4.2, -3.2, 0.0]];
    let mut scene = scene(&flat_room, &BODY[..4].iter().map(|c| [c[0], c[1], 0.0]).collect::<Vec<_>>());
    scene.pose = Pose { position: [0.2, 0.1, 0.0].into(), ..Pose::identity() };
    let found = verdicts(&scene);
    println!("{found:#?}");
    assert!(found[2].contains("At this pose"), "{}", found[2]);
}

#[test]
fn a_sensor_on_an_anchor() {
    let mut scene = scene(&ROOM, &BODY);
    scene.pose.position += nalgebra::Vector3::from(ROOM[0]) - scene.pose.act(&BODY[0].into());
    assert_eq!(verdicts(&scene), ["finite", "finite", "finite"]);
}

#[test]
fn thin_anchors_are_seen_badly_and_the_facts_say_how_thin() {
    let thin: Vec<[f64; 3]> =
        ROOM.iter().enumerate().map(|(m, a)| [a[0], a[1], 0.15 * (m % 2) as f64]).collect();
    let (thin, whole) = (scene(&thin, &BODY), scene(&ROOM, &BODY));
    let facts = |scene: &Scene<3>| observability(&scene.information(RangeForm::Projected));
    let (thin, whole) = (facts(&thin), facts(&whole));
    println!("{}\n{}", thin.sentence, whole.sentence);
    assert!(
        thin.sentence.contains("within 0.") && thin.sentence.contains("m of one plane"),
        "{}",
        thin.sentence
    );
    assert!(thin.anchor_thickness < 0.15 && thin.anchor_rank == 3 && thin.anchor_condition > 20.0);
    let deviation = |facts: &rangelab::bounds::Observability<3>| facts.motions[0].standard_deviation.unwrap();
    assert!(deviation(&thin) > 5.0 * deviation(&whole));
    assert!(thin.motions[0].shift[2].abs() > 0.9 || thin.motions[0].turning > 0.5);
}

#[test]
fn a_blind_epoch_stops_no_other_bound() {
    let few =
        model(&TRACKING_ANCHORS[..3], &BODY, RangeNoise::SquaredRange { sigma: 0.0316 }, Weighting::PerPair);
    let kinds = |model: RangeModel<3>| {
        let steps = bounds_along(&recording(model, radians(1.0))).unwrap();
        steps
            .iter()
            .map(|step| BoundKind::ALL.map(|kind| step.get(kind).unwrap().is_ok()))
            .collect::<Vec<_>>()
    };
    assert!(kinds(few).iter().all(|&known| known == [false, false, true, true, true, true]));

    let mut gap = tracking(Weighting::PerPair);
    gap.epochs[5].ranges = Ranges::from_fn(4, 5, |m, n| (m == 0 && n == 0).then_some(1e6)).unwrap();
    let steps = bounds_along(&gap).unwrap();
    let Some(Err(error)) = steps[5].get(BoundKind::UnitaryCrb) else {
        panic!("one range cannot show a pose")
    };
    assert!(error.to_string().contains("19 of 20 ranges are missing"), "{error}");
    assert!(
        steps[5].get(BoundKind::PosteriorCrb).unwrap().is_ok()
            && steps[6].get(BoundKind::Crb).unwrap().is_ok()
    );
    let finite = |bound: &Bound<3>| bound.orientation_trace > 0.0 && bound.position_trace > 0.0;
    assert!(steps.iter().all(|step| finite(step.get(BoundKind::PosteriorCrbRaw).unwrap().as_ref().unwrap())));
}
