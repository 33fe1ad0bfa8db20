//! KF-ortho and ET-KF: what the trigger and the feedback do, to the last bit.

use rangelab::math::rotation::{Manifold, Rotation, defect};
use rangelab::model::estimator_settings::{
    EstimatorName, EstimatorSettings, Metric, Threshold, ThresholdKind,
};
use rangelab::track::filter::Step;

use crate::scenario::{Options, Track};
use crate::support::at_most;
use crate::support::sampling::Sampler;

crate::in_plane_and_space!(
    threshold_zero_is_ortho,
    a_threshold_never_reached_is_the_plain_filter,
    events_are_where_the_defect_is,
    without_feedback_the_filter_runs_on_undisturbed,
    with_feedback_the_projected_pose_is_predicted,
);

fn noisy<const D: usize>() -> Track<D> {
    let noise = rangelab::model::noise::RangeNoise::Range { sigma: 0.3 };
    Track::random(&mut Sampler::new(400), &Options { noise, centred: false, ..Options::default() })
}

fn steps<const D: usize>(
    track: &Track<D>,
    name: EstimatorName,
    settings: &EstimatorSettings,
) -> Vec<Step<D>> {
    let mut filter = track.estimator(name, settings);
    track.recording.epochs.iter().map(|epoch| filter.step(epoch).unwrap()).collect()
}

fn all_settings() -> Vec<EstimatorSettings> {
    let mut all = Vec::new();
    for metric in [Metric::Frobenius, Metric::Information] {
        for manifold in [Manifold::So, Manifold::O] {
            for feedback in [false, true] {
                all.push(EstimatorSettings { metric, manifold, feedback, ..EstimatorSettings::default() });
            }
        }
    }
    all
}

fn above(kind: ThresholdKind, epsilon: f64, settings: &EstimatorSettings) -> EstimatorSettings {
    EstimatorSettings { threshold: Threshold { kind, epsilon }, ..settings.clone() }
}

fn threshold_zero_is_ortho<const D: usize>() {
    let track = noisy::<D>();
    for settings in all_settings() {
        let ortho = steps(&track, EstimatorName::Ortho, &settings);
        for kind in [ThresholdKind::Absolute, ThresholdKind::Relative] {
            assert_eq!(steps(&track, EstimatorName::EtKf, &above(kind, 0.0, &settings)), ortho);
        }
    }
}

fn a_threshold_never_reached_is_the_plain_filter<const D: usize>() {
    let track = noisy::<D>();
    for settings in all_settings() {
        let plain = steps(&track, EstimatorName::Kf, &settings);
        for kind in [ThresholdKind::Absolute, ThresholdKind::Relative] {
            assert_eq!(steps(&track, EstimatorName::EtKf, &above(kind, 1e9, &settings)), plain);
        }
    }
}

fn scale<const D: usize>(kind: ThresholdKind, step: &Step<D>) -> f64 {
    match kind {
        ThresholdKind::Absolute => 1.0,
        ThresholdKind::Relative => step.uncertainty.orientation_trace().sqrt(),
    }
}

/// At the median of the plain filter's defects the trigger shows both of its cases.
fn events_are_where_the_defect_is<const D: usize>() {
    let track = noisy::<D>();
    let plain = steps(&track, EstimatorName::Kf, &EstimatorSettings::default());
    for kind in [ThresholdKind::Absolute, ThresholdKind::Relative] {
        let statistic = |step: &Step<D>| step.defect / scale(kind, step);
        let mut all: Vec<f64> = plain.iter().map(statistic).collect();
        all.sort_by(f64::total_cmp);
        let epsilon = all[all.len() / 2];
        let mut events = 0;
        for step in steps(&track, EstimatorName::EtKf, &above(kind, epsilon, &EstimatorSettings::default())) {
            assert_eq!(step.defect, defect(&step.unprojected.orientation));
            assert_eq!(step.event, step.defect > epsilon * scale(kind, &step));
            let polar = *Rotation::project(&step.unprojected.orientation, Manifold::So).matrix();
            let expected = if step.event { polar } else { step.unprojected.orientation };
            assert_eq!(step.posterior.orientation, expected);
            assert_eq!(step.posterior.position, step.unprojected.position);
            events += usize::from(step.event);
        }
        assert!(events > 0 && events < track.truth.len(), "{events} events show neither case");
    }
}

fn without_feedback_the_filter_runs_on_undisturbed<const D: usize>() {
    let track = noisy::<D>();
    let plain = steps(&track, EstimatorName::Kf, &EstimatorSettings::default());
    for settings in all_settings().into_iter().filter(|settings| !settings.feedback) {
        for (step, undisturbed) in steps(&track, EstimatorName::Ortho, &settings).iter().zip(&plain) {
            assert_eq!(step.unprojected, undisturbed.posterior);
            assert_eq!((step.prior, step.nis), (undisturbed.prior, undisturbed.nis));
            assert_eq!(step.uncertainty, undisturbed.uncertainty);
            at_most("defect", defect(&step.posterior.orientation), 3e-15);
        }
    }
}

fn with_feedback_the_projected_pose_is_predicted<const D: usize>() {
    let track = noisy::<D>();
    for settings in all_settings().into_iter().filter(|settings| settings.feedback) {
        let all = steps(&track, EstimatorName::Ortho, &settings);
        for ((before, after), epoch) in all.iter().zip(&all[1..]).zip(&track.recording.epochs[1..]) {
            let predicted = epoch.motion.predict_theta(&before.posterior, &epoch.motion.rotation());
            assert_eq!(after.prior, predicted);
        }
    }
}
