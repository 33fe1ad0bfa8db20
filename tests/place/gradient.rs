//! The slope of the value against central differences, and against an independent sum in which the weights may be kept
//! from changing.

use nalgebra::{DMatrix, DVector, SVector};
use rangelab::math::pose::Pose;
use rangelab::math::tangent::{TangentVector, split, tangent_dimension};
use rangelab::model::availability::Availability;
use rangelab::model::placement_settings::{Criterion, Over, Target};
use rangelab::model::ranging::RangeForm;
use rangelab::model::scenario::Scenario;
use rangelab::place::figure::Sharpness;
use rangelab::place::{Placement, advise};

use crate::in_plane_and_space;
use crate::scenes::{CRITERIA, FORMS, OVERS, TARGETS, obstructed, placement, random, typed};

in_plane_and_space!(
    the_slope_is_that_of_the_value,
    the_slope_knows_walls_and_longest_ranges,
    weights_move_with_the_anchors,
    advice_leads_downhill
);

const STEP: f64 = 1e-4;
const TOLERANCE: f64 = 1e-5;

/// Central differences of a function of the anchors.
fn differences<const D: usize>(
    anchors: &[SVector<f64, D>],
    value: impl Fn(&[SVector<f64, D>]) -> f64,
) -> Vec<SVector<f64, D>> {
    let moved = |m: usize, i: usize, step: f64| {
        let mut anchors = anchors.to_vec();
        anchors[m][i] += step;
        value(&anchors)
    };
    let slope = |m, i| (moved(m, i, STEP) - moved(m, i, -STEP)) / (2.0 * STEP);
    (0..anchors.len()).map(|m| SVector::from_fn(|i, _| slope(m, i))).collect()
}

/// Largest difference of an anchor's gradient, as part of the steepest.
fn error<const D: usize>(found: &[SVector<f64, D>], expected: &[SVector<f64, D>]) -> f64 {
    let steepest = expected.iter().map(SVector::norm).fold(0.0, f64::max);
    found.iter().zip(expected).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max) / steepest
}

/// The placements of a scenario with every form, criterion, target and way to count poses together.
fn every_choice<const D: usize>(scenario: &Scenario) -> Vec<Placement<D>> {
    let mut placements = Vec::new();
    for form in FORMS {
        for criterion in CRITERIA {
            for target in TARGETS {
                for over in OVERS {
                    let mut chosen = placement::<D>(scenario);
                    (chosen.form, chosen.over) = (form, over);
                    (chosen.figure.criterion, chosen.figure.target) = (criterion, target);
                    placements.push(chosen);
                }
            }
        }
    }
    placements
}

fn the_slope_is_that_of_the_value<const D: usize>() {
    for trial in 0..6 {
        let scenario = random::<D>(trial);
        let anchors = typed::<D>(&scenario.anchors);
        for placement in every_choice::<D>(&scenario) {
            for sharpness in [Sharpness::Exact, Sharpness::Smooth { doublings: 3 }] {
                let what = format!(
                    "{trial}: {:?} {:?} {:?} {sharpness:?}",
                    placement.form, placement.figure, placement.over
                );
                let (value, gradient) = placement.gradient(&anchors, sharpness).unwrap();
                let numeric =
                    differences(&anchors, |anchors| placement.gradient(anchors, sharpness).unwrap().0);
                let found = error(&gradient, &numeric);
                assert!(found < TOLERANCE, "{what}: {found:e}");
                let twice: Vec<_> = gradient.iter().map(|g| g * 2.0).collect();
                assert!(error(&twice, &numeric) > 0.5, "{what}: a factor of 2 passes");
                if sharpness == Sharpness::Exact {
                    let alone = placement.value(&anchors).unwrap();
                    assert!((value / alone - 1.0).abs() < 1e-12, "{what}: {value} {alone}");
                }
            }
        }
    }
}

/// The root mean square A-value of the position from raw ranges, by stacked rows of differences; the weights may be taken
/// for other anchors than the rows.
fn stacked<const D: usize>(
    placement: &Placement<D>,
    anchors: &[SVector<f64, D>],
    weighed: &[SVector<f64, D>],
) -> f64 {
    let size = tangent_dimension(D);
    let of_pose = |pose: &Pose<D>| {
        let mut j = DMatrix::<f64>::zeros(size, size);
        for (a, b) in anchors.iter().zip(weighed) {
            for c in placement.topology.sensors() {
                let row = row(pose, a, c);
                let range = (b - pose.act(c)).norm_squared();
                j += &row * row.transpose() / placement.noise.squared_range_variance(range);
            }
        }
        let bound = j.try_inverse().unwrap();
        (size - D..size).map(|i| bound[(i, i)]).sum::<f64>()
    };
    let squares: f64 = placement.poses.iter().map(of_pose).sum();
    (squares / placement.poses.len() as f64).sqrt()
}

/// Central differences of a squared range in the tangent coordinates of the pose.
fn row<const D: usize>(pose: &Pose<D>, anchor: &SVector<f64, D>, sensor: &SVector<f64, D>) -> DVector<f64> {
    let squared = |tangent: &TangentVector| {
        let (phi, shift) = split::<D>(tangent);
        (anchor - pose.retract(&phi, &shift).act(sensor)).norm_squared()
    };
    DVector::from_fn(tangent_dimension(D), |i, _| {
        let mut step = TangentVector::zeros();
        step[i] = STEP;
        (squared(&step) - squared(&-step)) / (2.0 * STEP)
    })
}

/// With ranges taken away the slope is still that of the value; the slope of the scene without wall is not, and an anchor
/// that nothing is measured from has none.
fn the_slope_knows_walls_and_longest_ranges<const D: usize>() {
    let mut compared = 0;
    for trial in 0..6 {
        let mut scenario = obstructed::<D>(trial);
        scenario.availability.max_ranges = vec![Some(9.0); scenario.anchors.len()];
        scenario.availability.max_ranges[0] = Some(1e-3);
        let anchors = typed::<D>(&scenario.anchors);
        for placement in every_choice::<D>(&scenario) {
            let what = format!("{trial}: {:?} {:?} {:?}", placement.form, placement.figure, placement.over);
            let Ok((_, gradient)) = placement.gradient(&anchors, Sharpness::Exact) else { continue };
            let numeric = differences(&anchors, |anchors| placement.value(anchors).unwrap());
            let found = error(&gradient, &numeric);
            assert!(found < TOLERANCE, "{what}: {found:e}");
            assert!(!(gradient[0].norm() > 0.0), "{what}: nothing is measured from anchor 0");
            let blind = Placement { availability: Availability::unlimited(), ..placement.clone() };
            let (_, blind) = blind.gradient(&anchors, Sharpness::Exact).unwrap();
            assert!(error(&blind, &numeric) > 1e-3, "{what}: a slope that knows no walls passes");
            compared += 1;
        }
    }
    assert!(compared > 36, "{compared} slopes");
}

fn weights_move_with_the_anchors<const D: usize>() {
    for trial in 0..6 {
        let mut scenario = random::<D>(trial);
        scenario.field.form = RangeForm::Raw;
        scenario.placement.criterion = Criterion::A;
        (scenario.placement.target, scenario.placement.over) = (Target::Position, Over::Mean);
        let (placement, anchors) = (placement::<D>(&scenario), typed::<D>(&scenario.anchors));
        let (value, gradient) = placement.gradient(&anchors, Sharpness::Exact).unwrap();
        assert!((stacked(&placement, &anchors, &anchors) / value - 1.0).abs() < 1e-6);
        let whole = differences(&anchors, |moved| stacked(&placement, moved, moved));
        let found = error(&gradient, &whole);
        assert!(found < TOLERANCE, "{trial}: {found:e}");
        let frozen = differences(&anchors, |moved| stacked(&placement, moved, &anchors));
        let spoiled = error(&frozen, &whole);
        assert!(
            spoiled > 100.0 * TOLERANCE,
            "{trial}: without the slope of the weights only {spoiled:e} off"
        );
    }
}

fn advice_leads_downhill<const D: usize>() {
    for trial in 0..6 {
        let mut scenario = random::<D>(trial);
        let advice = advise(&scenario).unwrap();
        let squares: f64 = advice.gradient.iter().flatten().map(|x| x * x).sum();
        let step = 1e-3 / squares.sqrt();
        for (anchor, gradient) in scenario.anchors.iter_mut().zip(&advice.gradient) {
            for (x, slope) in anchor.iter_mut().zip(gradient) {
                *x -= step * slope;
            }
        }
        let (before, after) = (advice.value.unwrap(), advise(&scenario).unwrap().value.unwrap());
        let promised = step * squares;
        assert!(((before - after) / promised - 1.0).abs() < 0.05, "{trial}: {before} {after} {promised}");
    }
}

#[test]
fn advice_is_given_where_no_bound_exists() {
    let mut scenario = random::<3>(0);
    scenario.anchors = (0..4).map(|m| vec![f64::from(m), f64::from(m % 2), 2.0]).collect();
    scenario.field.form = RangeForm::Projected;
    let advice = advise(&scenario).unwrap();
    assert!(advice.value.is_none() && advice.cause.is_some());
    assert!(advice.gradient.iter().flatten().all(|x| x.is_finite()));
}
