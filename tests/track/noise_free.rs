//! With exact ranges of a body that moves as the filter thinks, every estimator comes as near the truth as its prior lets
//! it, and nearer with every epoch.

use rangelab::math::pose::{Pose, Theta};
use rangelab::math::rotation::Rotation;
use rangelab::model::epoch::Epoch;
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
use rangelab::model::motion::{Motion, ProcessNoise};
use rangelab::model::noise::RangeNoise;

use crate::scenario::{Options, Track};
use crate::support::sampling::Sampler;
use crate::support::{at_most, caught};

crate::in_plane_and_space!(all_estimators_come_to_the_truth);

/// A start 0.5 rad and 2 m off, exact motion, exact ranges; `precise` ranges weigh `1e6` more.
fn track<const D: usize>(sampler: &mut Sampler, sigma: f64, centred: bool) -> Track<D> {
    let options =
        Options { noise: RangeNoise::Range { sigma }, centred, variance: 100.0, ..Options::default() };
    let mut track = Track::<D>::random(sampler, &options);
    let mut pose = Pose {
        rotation: Rotation::exp(&sampler.axis::<D>().map(|x| 0.5 * x)),
        position: sampler.vector(1.0),
    };
    track.recording.process = ProcessNoise { sigma_q: 0.0, sigma_t: 0.0 };
    for (epoch, truth) in track.recording.epochs.iter_mut().zip(&mut track.truth) {
        let motion: Motion<D> = epoch.motion;
        pose = motion.predict_pose(&pose, &motion.rotation());
        *truth = Theta::from(pose);
        *epoch =
            Epoch { motion, ranges: track.recording.model.exact_ranges(truth).unwrap(), true_ranges: None };
    }
    track
}

fn all_estimators_come_to_the_truth<const D: usize>() {
    let mut sampler = Sampler::new(700);
    for index in 0..10 {
        let track = track::<D>(&mut sampler, 1e-3, index % 2 == 0);
        for name in EstimatorName::ALL {
            let mut filter = track.estimator(name, &EstimatorSettings::default());
            let errors: Vec<f64> = track
                .recording
                .epochs
                .iter()
                .zip(&track.truth)
                .map(|(epoch, truth)| {
                    let error = filter.step(epoch).unwrap().posterior.minus(truth);
                    error.dot(&error).sqrt()
                })
                .collect();
            caught("the start", track.recording.initial.theta.minus(&track.truth[0]).position.norm(), 1e-2);
            at_most(&format!("{name} after 1 epoch"), errors[0], 1e-3);
            at_most(&format!("{name} after 20 epochs"), errors[19], (0.1 * errors[0]).max(1e-12));
        }
    }
}
