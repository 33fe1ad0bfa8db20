//! Scenes that anchors are placed for.

use nalgebra::SVector;
use rangelab::model::availability::Obstacle;
use rangelab::model::noise::RangeNoise;
use rangelab::model::placement_settings::{Criterion, Over, Region, Target};
use rangelab::model::ranging::RangeForm;
use rangelab::model::scenario::Scenario;
use rangelab::place::Placement;

use crate::support::sampling::Sampler;

pub const CRITERIA: [Criterion; 3] = [Criterion::A, Criterion::D, Criterion::E];
pub const TARGETS: [Target; 3] = [Target::Position, Target::Orientation, Target::Pose];
pub const OVERS: [Over; 2] = [Over::Mean, Over::Worst];
pub const FORMS: [RangeForm; 2] = [RangeForm::Projected, RangeForm::Raw];

/// Anchors in a box of 10 m, a body of about 1 m in a region of 2 m within it, in two headings, each kind of noise.
pub fn random<const D: usize>(trial: usize) -> Scenario {
    let mut sampler = Sampler::new(trial as u64);
    let noise = match trial % 3 {
        0 => RangeNoise::Range { sigma: 0.05 },
        1 => RangeNoise::SquaredRange { sigma: 0.1 },
        _ => RangeNoise::Toa { zeta_db: 40.0 },
    };
    let mut scenario = scenario(D, noise);
    scenario.anchors = points::<D>(&mut sampler, D + 2 + trial % 3, 5.0);
    scenario.sensors = points::<D>(&mut sampler, D + 1, 0.5);
    scenario.start = sampler.pose::<D>(1.0).into();
    scenario.field.headings = 2;
    let low: Vec<f64> = (0..D).map(|_| sampler.uniform(-2.0, 0.0)).collect();
    let high = low.iter().map(|x| x + 2.0).collect();
    scenario.placement.region = Some(Region { low, high });
    scenario.placement.limits = Some(cube(D, 5.0));
    scenario
}

/// A wall through the region and a box at a corner of it, and anchors of which some do not reach all of it.
pub fn obstructed<const D: usize>(trial: usize) -> Scenario {
    let mut scenario = random::<D>(trial);
    let wall =
        Obstacle::Wall { from: vec![-1.53, 0.51], to: vec![1.49, 0.83], bottom: Some(-6.0), top: Some(6.0) };
    let low = vec![2.2; D];
    let block = Obstacle::Box { high: low.iter().map(|x| x + 1.0).collect(), low };
    scenario.availability.obstacles = vec![wall, block];
    scenario.availability.max_ranges = scenario.anchors.iter().map(|_| Some(7.0)).collect();
    scenario
}

/// One anchor and one sensor at the origin.
pub fn scenario(dimension: usize, noise: RangeNoise) -> Scenario {
    let origin = &["0"; 3][..dimension].join(",");
    let text = format!(
        r#"{{"version": 1, "dimension": {dimension}, "anchors": [[{origin}]], "sensors": [[{origin}]],
            "noise": {{"kind": "range", "sigma": 1}}}}"#
    );
    Scenario { noise, ..Scenario::from_json(&text).unwrap() }
}

pub fn points<const D: usize>(sampler: &mut Sampler, count: usize, half: f64) -> Vec<Vec<f64>> {
    (0..count).map(|_| (0..D).map(|_| sampler.uniform(-half, half)).collect()).collect()
}

pub fn cube(dimension: usize, half: f64) -> Region {
    Region { low: vec![-half; dimension], high: vec![half; dimension] }
}

pub fn typed<const D: usize>(points: &[Vec<f64>]) -> Vec<SVector<f64, D>> {
    points.iter().map(|point| SVector::from_column_slice(point)).collect()
}

pub fn placement<const D: usize>(scenario: &Scenario) -> Placement<D> {
    Placement::of(scenario).unwrap()
}
