//! Geometry that hides something: every estimator gives a finite answer or a typed error that names the cause.

use nalgebra::{SVector, Vector2, Vector3};
use rangelab::error::Error;
use rangelab::localize::{Snapshot, localize};
use rangelab::math::pose::{Pose, Theta};
use rangelab::math::rotation::{Manifold, Rotation};
use rangelab::model::anchors::Anchors;
use rangelab::model::localize_settings::{LocalizeSettings, LocalizerName as Name, Loss};
use rangelab::model::noise::RangeNoise;
use rangelab::model::ranges::Ranges;
use rangelab::model::ranging::{RangeModel, Weighting};
use rangelab::model::topology::Topology;

use crate::support::sampling::Sampler;

const NOISES: [RangeNoise; 3] = [
    RangeNoise::Range { sigma: 0.02 },
    RangeNoise::SquaredRange { sigma: 0.05 },
    RangeNoise::Toa { zeta_db: 50.0 },
];
const LINEAR: [Name; 8] = [
    Name::ClassicalLs,
    Name::Ls,
    Name::SucLs,
    Name::SucLsWeighted,
    Name::OucLs,
    Name::SucTls,
    Name::OucTlsPrinted,
    Name::OucTls,
];

/// Runs every estimator in every setting; `expected` is a word of the cause, or `None` for a pose.
fn check<const D: usize>(
    anchors: &[SVector<f64, D>],
    sensors: &[SVector<f64, D>],
    pose: Pose<D>,
    missing: impl Fn(usize, usize) -> bool,
    expected: impl Fn(Name) -> Option<&'static str>,
) {
    let mut sampler = Sampler::new(550);
    for (index, noise) in NOISES.into_iter().enumerate() {
        for weighting in [Weighting::Common, Weighting::PerPair] {
            let anchors = Anchors::new(anchors.to_vec()).unwrap();
            let topology = Topology::new(sensors.to_vec()).unwrap();
            let model = RangeModel::new(anchors, topology, noise, weighting).unwrap();
            let exact = model.exact_ranges(&Theta::from(pose)).unwrap();
            let spread = if index == 0 { 0.0 } else { 1e-3 };
            let ranges = Ranges::from_fn(exact.anchors(), exact.sensors(), |m, n| {
                exact.get(m, n).filter(|_| !missing(m, n)).map(|d| d + spread * sampler.normal())
            })
            .unwrap();
            let snapshot = Snapshot::new(&model, &ranges, &ranges).unwrap();
            for name in Name::ALL {
                one(&snapshot, name, &expected);
            }
        }
    }
}

fn one<const D: usize>(snapshot: &Snapshot<D>, name: Name, expected: &impl Fn(Name) -> Option<&'static str>) {
    for manifold in [Manifold::So, Manifold::O] {
        for (multi_start, loss) in [(false, Loss::Squared), (true, Loss::Huber { scale: 1.345 })] {
            let settings = LocalizeSettings { manifold, multi_start, loss, ..LocalizeSettings::default() };
            match (localize(name, snapshot, &settings, 0.01), expected(name)) {
                (Ok(estimate), None) => {
                    assert!(estimate.theta.is_none_or(|theta| theta.is_finite()), "{name}");
                    assert!(estimate.theta.is_some() || name == Name::ClassicalLs);
                }
                (Err(Error::Unobservable { what, ranges, reason }), Some(word)) => {
                    assert!(reason.contains(word), "{name}: {reason} does not say {word}");
                    let sentence = Error::Unobservable { what, ranges, reason }.to_string();
                    assert!(sentence.contains(&format!("{ranges} ranges")), "{sentence}");
                }
                (found, expected) => panic!("{name}: {found:?} where {expected:?} is expected"),
            }
        }
    }
}

fn around() -> Vec<Vector3<f64>> {
    [[0.0, 0.0, 0.0], [8.0, 0.5, 1.0], [0.5, 7.0, 2.0], [1.0, 1.0, 6.0], [7.0, 7.0, 5.0]]
        .map(Vector3::from)
        .to_vec()
}

fn body() -> Vec<Vector3<f64>> {
    [[0.5, 0.0, 0.0], [-0.5, 0.1, 0.0], [0.0, 0.6, 0.1], [0.1, 0.0, 0.7], [0.3, 0.3, -0.4]]
        .map(Vector3::from)
        .to_vec()
}

fn pose() -> Pose<3> {
    Pose { rotation: Rotation::exp(&[0.3, -0.4, 0.8]), position: Vector3::new(3.0, 2.0, 2.5) }
}

fn all_linear(word: &'static str) -> impl Fn(Name) -> Option<&'static str> {
    move |name| (LINEAR.contains(&name) || name == Name::GaussNewton).then_some(word)
}

#[test]
fn a_sound_scene_is_seen() {
    check(&around(), &body(), pose(), |_, _| false, |_| None);
}

/// M = D: the linear model needs one more; the ranges themselves do not.
#[test]
fn as_many_anchors_as_dimensions() {
    let expected = all_linear("3 anchors where at least 4 are needed");
    check(&around()[..3], &body(), pose(), |_, _| false, expected);
    let anchors = [Vector2::new(0.0, 0.0), Vector2::new(9.0, 1.0)];
    let sensors = [Vector2::new(0.5, 0.0), Vector2::new(-0.5, 0.2), Vector2::new(0.0, 0.7)];
    let pose = Pose { rotation: Rotation::exp(&[0.7, 0.0, 0.0]), position: Vector2::new(4.0, 5.0) };
    let expected = all_linear("2 anchors where at least 3 are needed");
    check(&anchors, &sensors, pose, |_, _| false, expected);
}

/// Of the two sides of the anchors' plane the body fits only one, for on the other it would be mirrored; where the descent from
/// both starts ends in a pose that does not fit, the misfit shows it.
#[test]
fn three_anchors_are_enough_for_the_ranges_themselves() {
    let mut sampler = Sampler::new(551);
    let (mut right, mut trials) = (0, 0);
    for _ in 0..100 {
        let anchors = sampler.anchors::<3>(3, 8.0);
        let topology = sampler.topology::<3>(5, true);
        let noise = RangeNoise::Range { sigma: 0.01 };
        let model = RangeModel::new(anchors, topology, noise, Weighting::Common).unwrap();
        let truth = sampler.pose::<3>(3.0);
        let ranges = model.exact_ranges(&Theta::from(truth)).unwrap();
        let snapshot = Snapshot::new(&model, &ranges, &ranges).unwrap();
        let found = localize(Name::MaximumLikelihood, &snapshot, &LocalizeSettings::default(), 0.0).unwrap();
        let theta = found.theta.unwrap();
        let fit = model.exact_ranges(&theta).unwrap();
        let pairs = (0..5).flat_map(|n| (0..3).map(move |m| (m, n)));
        let misfit =
            pairs.map(|(m, n)| (fit.get(m, n).unwrap().sqrt() - ranges.get(m, n).unwrap().sqrt()).abs());
        let error = theta.minus(&truth.into());
        let fits = misfit.fold(0.0, f64::max) < 1e-6;
        let is_right = error.position.norm() + error.orientation.norm() < 1e-4;
        assert!(is_right || !fits, "fits, and is off by {}", error.position.norm());
        trials += 1;
        right += usize::from(is_right);
    }
    println!("right in {right} of {trials} scenes");
    assert!(10 * right >= 9 * trials, "right in {right} of {trials} scenes only");
}

#[test]
fn coplanar_anchors() {
    let plane = [[0.0, 0.0, 3.0], [8.0, 0.0, 3.0], [0.0, 6.0, 3.0], [8.0, 6.0, 3.0], [3.0, 1.0, 3.0]];
    check(&plane.map(Vector3::from), &body(), pose(), |_, _| false, all_linear("in one plane"));
}

#[test]
fn collinear_anchors_hide_a_turn_from_everyone() {
    let line = [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [5.0, 0.0, 1.0], [9.0, 0.0, 1.0]].map(Vector3::from);
    check(&line, &body(), pose(), |_, _| false, |_| Some("on one line"));
}

/// A rod shows its place and its direction; its roll is nobody's to find.
#[test]
fn collinear_sensors() {
    let rod = [[-0.5, 0.0, 0.0], [0.0, 0.0, 0.0], [0.5, 0.0, 0.0], [0.2, 0.0, 0.0]].map(Vector3::from);
    let expected = |name| (name != Name::ClassicalLs).then_some("sensors lie on one line");
    check(&around(), &rod, pose(), |_, _| false, expected);
}

/// A flat body is enough where it is known to be one: only the unconstrained LS needs more.
#[test]
fn coplanar_sensors() {
    let flat = [[-0.5, 0.0, 0.0], [0.4, 0.1, 0.0], [0.0, 0.5, 0.0], [0.3, -0.5, 0.0]].map(Vector3::from);
    let expected = |name| (name == Name::Ls).then_some("sensors lie in one plane");
    check(&around(), &flat, pose(), |_, _| false, expected);
}

#[test]
fn one_sensor() {
    let expected = |name| (name != Name::ClassicalLs).then_some("1 sensor where at least");
    check(&around(), &body()[..1], pose(), |_, _| false, expected);
}

#[test]
fn one_range_missing() {
    check(&around(), &body(), pose(), |m, n| (m, n) == (2, 0), |_| None);
    // Of four anchors three are left for one sensor: its own position is lost, not the pose.
    let expected = |name| (name == Name::ClassicalLs).then_some("1 of 20 ranges are missing");
    check(&around()[..4], &body(), pose(), |m, n| (m, n) == (2, 0), expected);
}

#[test]
fn no_range_at_all() {
    check(&around(), &body(), pose(), |_, _| true, |_| Some("No range was measured"));
}

#[test]
fn a_sensor_on_an_anchor() {
    let pose = pose();
    let mut anchors = around();
    anchors[1] = pose.act(&body()[0]);
    check(&anchors, &body(), pose, |_, _| false, |_| None);
    // In the middle of the body, and the first sensor gives the weights.
    anchors[0] = pose.position;
    check(&anchors, &body(), pose, |_, _| false, |_| None);
}

#[test]
fn ranges_that_overflow_are_refused() {
    let model = RangeModel::new(
        Anchors::new(around()).unwrap(),
        Topology::new(body()).unwrap(),
        RangeNoise::Range { sigma: 1e-9 },
        Weighting::Common,
    )
    .unwrap();
    let ranges = Ranges::from_fn(5, 5, |m, _| Some(1e300 * (1.0 + m as f64))).unwrap();
    let refused = Snapshot::new(&model, &ranges, &ranges).map(drop);
    assert!(matches!(refused, Err(Error::Number { .. })), "{refused:?}");
    let few = Ranges::from_fn(4, 5, |_, _| Some(1.0)).unwrap();
    assert!(matches!(Snapshot::new(&model, &few, &few).map(drop), Err(Error::Size { .. })));
}
