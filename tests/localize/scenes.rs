//! Random snapshots: anchors around a body of about 1 m, any attitude, the body's frame anywhere near it.

use nalgebra::SVector;
use rangelab::localize::{Estimate, Snapshot, localize};
use rangelab::math::pose::{Pose, Theta};
use rangelab::model::anchors::Anchors;
use rangelab::model::localize_settings::{LocalizeSettings, LocalizerName};
use rangelab::model::noise::RangeNoise;
use rangelab::model::ranges::Ranges;
use rangelab::model::ranging::{RangeModel, Weighting};
use rangelab::model::topology::Topology;

use crate::support::sampling::Sampler;

pub struct Scene<const D: usize> {
    pub model: RangeModel<D>,
    pub pose: Pose<D>,
    pub ranges: Ranges,
}

impl<const D: usize> Scene<D> {
    /// Every third scene has common weights, weights per pair, a missing range for some sensors.
    pub fn random(sampler: &mut Sampler, index: usize, sigma: f64) -> Self {
        let weighting = if index % 3 == 1 { Weighting::PerPair } else { Weighting::Common };
        let anchors = shell(sampler, D + 2 + index % 4);
        let topology = sampler.topology(D + 1 + index % 3, false);
        let mut scene = Self::of(sampler, anchors, topology, weighting, sigma);
        if index % 3 == 2 {
            let lost = sampler.below(D + 2);
            let all = scene.ranges.clone();
            let kept = |m: usize, n: usize| all.get(m, n).filter(|_| n.is_multiple_of(2) || m != lost);
            scene.ranges = Ranges::from_fn(all.anchors(), all.sensors(), kept).unwrap();
        }
        scene
    }

    /// Ranges with noise of `sigma` at a random pose.
    pub fn of(
        sampler: &mut Sampler,
        anchors: Anchors<D>,
        topology: Topology<D>,
        weighting: Weighting,
        sigma: f64,
    ) -> Self {
        let noise = RangeNoise::Range { sigma: 0.05 };
        let model = RangeModel::new(anchors, topology, noise, weighting).unwrap();
        let pose = sampler.pose::<D>(0.5);
        let exact = model.exact_ranges(&Theta::from(pose)).unwrap();
        let ranges = Ranges::from_fn(exact.anchors(), exact.sensors(), |m, n| {
            let range = exact.get(m, n).unwrap().sqrt() + sigma * sampler.normal();
            Some(range * range)
        });
        Self { model, pose, ranges: ranges.unwrap() }
    }

    pub fn snapshot(&self) -> Snapshot<'_, D> {
        Snapshot::new(&self.model, &self.ranges, &self.ranges).unwrap()
    }

    pub fn estimate(&self, name: LocalizerName, settings: &LocalizeSettings, sigma: f64) -> Estimate<D> {
        localize(name, &self.snapshot(), settings, sigma).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub fn theta(&self, name: LocalizerName) -> Theta<D> {
        self.estimate(name, &LocalizeSettings::default(), 0.1).theta.unwrap()
    }
}

/// Anchors all around, 6 to 12 m from the origin.
pub fn shell<const D: usize>(sampler: &mut Sampler, count: usize) -> Anchors<D> {
    let mut point = || {
        let direction: SVector<f64, D> = sampler.vector(1.0);
        direction / direction.norm() * sampler.uniform(6.0, 12.0)
    };
    Anchors::new((0..count).map(|_| point()).collect()).unwrap()
}

/// Largest difference of `Q`, and of `t` in metres.
pub fn difference<const D: usize>(a: &Theta<D>, b: &Theta<D>) -> f64 {
    let difference = a.minus(b);
    difference.orientation.norm() + difference.position.norm()
}

/// All estimators that give a pose.
pub fn posed() -> impl Iterator<Item = LocalizerName> {
    LocalizerName::ALL.into_iter().filter(|&name| name != LocalizerName::ClassicalLs)
}
