//! The edges: an answer is finite, or it is a typed error and the filter goes on from where it was.

use nalgebra::SVector;
use rangelab::model::anchors::Anchors;
use rangelab::model::epoch::{Epoch, Recording};
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
use rangelab::model::noise::RangeNoise;
use rangelab::model::ranges::Ranges;
use rangelab::model::ranging::{RangeModel, Weighting};
use rangelab::model::topology::Topology;
use rangelab::track::filter::Step;

use crate::scenario::{Options, Track};
use crate::support::sampling::Sampler;

crate::in_plane_and_space!(
    few_anchors_and_sensors,
    extreme_noise,
    flat_anchors,
    coinciding_points,
    no_ranges_at_all_is_a_prediction,
    a_failed_step_leaves_no_trace,
    single_ranges_are_used_or_ignored,
);

fn is_finite<const D: usize>(step: &Step<D>) -> bool {
    [step.prior, step.innovation, step.unprojected, step.posterior]
        .iter()
        .all(rangelab::math::pose::Theta::is_finite)
        && step.uncertainty.orientation_trace().is_finite()
        && step.uncertainty.position_block().iter().all(|x| x.is_finite())
        && step.nis.value.is_finite()
        && step.defect.is_finite()
}

/// Runs every estimator with every choice; returns how many steps gave an answer and how many an error.
fn run<const D: usize>(recording: &Recording<D>) -> [usize; 2] {
    let mut counts = [0, 0];
    for name in EstimatorName::ALL {
        for decoupled in [false, true] {
            let settings = EstimatorSettings { decoupled, ..EstimatorSettings::default() };
            let mut filter = rangelab::track::estimator(name, &settings, recording);
            for epoch in &recording.epochs {
                match filter.step(epoch) {
                    Ok(step) => {
                        assert!(is_finite(&step), "{name}: {step:?}");
                        counts[0] += 1;
                    }
                    Err(error) => {
                        assert!(!error.to_string().contains("NaN"), "{name}: {error}");
                        counts[1] += 1;
                    }
                }
            }
        }
    }
    counts
}

#[track_caller]
fn all_answer<const D: usize>(what: &str, recording: &Recording<D>) {
    let [answers, errors] = run(recording);
    assert!(errors == 0, "{what}: {errors} of {} steps are errors", answers + errors);
}

fn few_anchors_and_sensors<const D: usize>() {
    let mut sampler = Sampler::new(900);
    for anchors in 1..=D {
        for sensors in 1..=D + 1 {
            for weighting in [Weighting::Common, Weighting::PerPair] {
                for centred in [true, false] {
                    let options =
                        Options { anchors, sensors, weighting, centred, steps: 5, ..Options::default() };
                    let track = Track::<D>::random(&mut sampler, &options);
                    all_answer(&format!("{anchors} x {sensors}"), &track.recording);
                }
            }
        }
    }
}

fn extreme_noise<const D: usize>() {
    let mut sampler = Sampler::new(901);
    for sigma in [1e-12, 1e-6, 1e3, 1e6, 1e9] {
        for noise in [RangeNoise::SquaredRange { sigma }, RangeNoise::Range { sigma }] {
            for (anchors, centred) in [(6, true), (6, false), (D, true), (1, false)] {
                let options = Options { anchors, noise, centred, steps: 5, ..Options::default() };
                let track = Track::<D>::random(&mut sampler, &options);
                let [answers, errors] = run(&track.recording);
                if errors > 0 {
                    println!(
                        "D = {D} {noise:?}, {anchors} anchors, centred {centred}: {answers} answers, {errors} errors"
                    );
                }
                assert!(errors == 0 || !(1e-6..=1e6).contains(&sigma), "{noise:?} is no reason for an error");
            }
        }
    }
}

/// Anchors within `thickness` of a plane (a line in the plane) at the paper's scale.
fn flat<const D: usize>(sampler: &mut Sampler, thickness: f64) -> Recording<D> {
    let noise = RangeNoise::SquaredRange { sigma: 0.0316 };
    let options = Options { half: 1000.0, noise, variance: 100.0, ..Options::default() };
    let track = Track::<D>::random(sampler, &options);
    let press = |a: &SVector<f64, D>| {
        let mut a = *a;
        a[D - 1] *= thickness / 1000.0;
        a
    };
    let anchors = track.recording.model.anchors().positions().iter().map(press).collect();
    let topology = track.recording.model.topology().clone();
    let model = RangeModel::new(Anchors::new(anchors).unwrap(), topology, noise, Weighting::Common).unwrap();
    let epochs = track.recording.epochs.iter().zip(&track.truth).map(|(epoch, truth)| {
        let exact = model.exact_ranges(truth).unwrap();
        let ranges = Ranges::from_fn(exact.anchors(), exact.sensors(), |m, n| {
            let d = exact.get(m, n)?;
            Some(d + 0.0316 * d.sqrt() * sampler.normal())
        });
        Epoch { motion: epoch.motion, ranges: ranges.unwrap(), true_ranges: None }
    });
    let epochs = epochs.collect();
    Recording { model, epochs, ..track.recording }
}

fn flat_anchors<const D: usize>() {
    let mut sampler = Sampler::new(902);
    for thickness in [8.0, 1e-3, 1e-6, 0.0] {
        for _ in 0..10 {
            all_answer(&format!("anchors flat by {thickness} m"), &flat::<D>(&mut sampler, thickness));
        }
    }
}

fn coinciding_points<const D: usize>() {
    let mut sampler = Sampler::new(903);
    let mut recording =
        Track::<D>::random(&mut sampler, &Options { steps: 5, ..Options::default() }).recording;
    let (anchors, sensors) = (recording.model.anchors().len(), recording.model.topology().len());
    for (place, spot) in [(0.0, 0.0), (3.0, 0.0), (0.0, 0.4), (3.0, 0.4)] {
        let model = RangeModel::new(
            Anchors::new(vec![SVector::repeat(place); anchors]).unwrap(),
            Topology::new(vec![SVector::repeat(spot); sensors]).unwrap(),
            *recording.model.noise(),
            Weighting::PerPair,
        )
        .unwrap();
        for epoch in &mut recording.epochs {
            epoch.ranges = model.exact_ranges(&recording.initial.theta).unwrap();
            epoch.true_ranges = None;
        }
        recording.model = model;
        let [answers, _] = run(&recording);
        println!("D = {D} all anchors at {place}, sensors at {spot}: {answers} answers");
    }
}

fn no_ranges_at_all_is_a_prediction<const D: usize>() {
    let mut sampler = Sampler::new(904);
    for centred in [true, false] {
        let track =
            Track::<D>::random(&mut sampler, &Options { missing: 1.0, centred, ..Options::default() });
        for name in EstimatorName::ALL {
            let mut filter = track.estimator(name, &EstimatorSettings::default());
            let mut theta = track.recording.initial.theta;
            for epoch in &track.recording.epochs {
                let step = filter.step(epoch).unwrap();
                theta = epoch.motion.predict_theta(&theta, &epoch.motion.rotation());
                let error = step.posterior.minus(&theta);
                assert!(error.dot(&error) < 1e-26, "{name}");
                assert_eq!((step.nis.value, step.nis.degrees_of_freedom), (0.0, 0));
            }
        }
    }
}

/// Epochs that must fail, made from a good one.
fn bad_epochs<const D: usize>(good: &Epoch<D>) -> Vec<Epoch<D>> {
    let (anchors, sensors) = (good.ranges.anchors(), good.ranges.sensors());
    let sized = |m, n, value| Ranges::from_fn(m, n, |_, _| value).unwrap();
    let one_wild =
        Ranges::from_fn(anchors, sensors, |m, n| Some(if (m, n) == (0, 0) { 1e300 } else { 1.0 })).unwrap();
    let plain = Epoch { true_ranges: None, ..good.clone() };
    let mut bad = vec![
        Epoch { ranges: sized(anchors + 1, sensors, Some(1.0)), ..plain.clone() },
        Epoch { ranges: sized(anchors, sensors - 1, Some(1.0)), ..plain.clone() },
        Epoch { true_ranges: Some(sized(anchors, sensors + 1, Some(1.0))), ..plain.clone() },
        Epoch { ranges: one_wild, true_ranges: good.true_ranges.clone(), ..plain.clone() },
    ];
    for value in [f64::NAN, f64::INFINITY, 1e308] {
        for ranges in [good.ranges.clone(), sized(anchors, sensors, None)] {
            let mut wild = Epoch { ranges, ..good.clone() };
            wild.motion.velocity[0] = 10.0 * value;
            bad.push(wild.clone());
            wild.motion.velocity[0] = 0.0;
            wild.motion.angular_velocity[0] = 10.0 * value;
            bad.push(wild);
        }
    }
    bad
}

fn a_failed_step_leaves_no_trace<const D: usize>() {
    let mut sampler = Sampler::new(905);
    let track = Track::<D>::random(&mut sampler, &Options { missing: 0.1, steps: 4, ..Options::default() });
    let settings = EstimatorSettings { feedback: true, ..EstimatorSettings::default() };
    let epochs = &track.recording.epochs;
    for name in EstimatorName::ALL {
        let [mut disturbed, mut undisturbed] = [0, 1].map(|_| track.estimator(name, &settings));
        for epoch in epochs {
            assert_eq!(disturbed.step(epoch).unwrap(), undisturbed.step(epoch).unwrap(), "{name}");
            for (index, bad) in bad_epochs(epoch).iter().enumerate() {
                match disturbed.step(bad) {
                    Err(error) => assert!(!error.to_string().is_empty()),
                    Ok(step) => panic!("{name}: bad epoch {index} was taken: {:?}", step.posterior),
                }
            }
        }
    }
}

/// One range, from one anchor to one sensor: the projected forms predict, the raw form moves.
fn single_ranges_are_used_or_ignored<const D: usize>() {
    let mut sampler = Sampler::new(906);
    let mut track = Track::<D>::random(&mut sampler, &Options { steps: 3, ..Options::default() });
    for epoch in &mut track.recording.epochs {
        let all = epoch.ranges.clone();
        epoch.ranges =
            Ranges::from_fn(all.anchors(), all.sensors(), |m, n| all.get(m, n).filter(|_| (m, n) == (1, 2)))
                .unwrap();
    }
    for name in EstimatorName::ALL {
        let mut filter = track.estimator(name, &EstimatorSettings::default());
        for epoch in &track.recording.epochs {
            let step = filter.step(epoch).unwrap();
            let moved = step.unprojected.minus(&step.prior);
            let raw = name == EstimatorName::EskfRaw;
            assert_eq!(step.nis.degrees_of_freedom, usize::from(raw), "{name}");
            assert_eq!(moved.dot(&moved).sqrt() > 1e-9, raw, "{name} moved by {moved:?}");
        }
    }
}
