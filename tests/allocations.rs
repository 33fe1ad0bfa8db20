//! A step touches no heap: counted by an allocator that counts.
#![allow(unsafe_code, reason = "an allocator is unsafe by its nature; it only counts and passes on")]

mod support;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use rangelab::inertial::inertial_filter;
use rangelab::math::pose::{Pose, Theta};
use rangelab::model::epoch::{Epoch, Initial, Recording};
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings, Metric};
use rangelab::model::indoor::filter_settings::{FilterName, FilterSettings, FrontEndKind, Transport};
use rangelab::model::indoor::presets::indoor_preset;
use rangelab::model::motion::{Motion, ProcessNoise};
use rangelab::model::noise::RangeNoise;
use rangelab::model::ranges::Ranges;
use rangelab::model::ranging::{RangeModel, Weighting};
use rangelab::simulate::indoor::simulate_indoor;
use support::sampling::Sampler;

struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call is passed on to the system's allocator as it came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        ALLOCATIONS.with(|count| count.set(count.get() + 1));
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Allocations of this thread while `work` runs.
fn allocations<T>(work: impl FnOnce() -> T) -> (usize, T) {
    let before = ALLOCATIONS.with(Cell::get);
    let result = work();
    (ALLOCATIONS.with(Cell::get) - before, result)
}

fn recording<const D: usize>(
    sampler: &mut Sampler,
    [anchors, sensors]: [usize; 2],
    weighting: Weighting,
    missing: f64,
) -> Recording<D> {
    let (anchors, topology) = (sampler.anchors(anchors, 10.0), sampler.topology(sensors, true));
    let noise = RangeNoise::Range { sigma: 0.05 };
    let model = RangeModel::new(anchors, topology, noise, weighting).unwrap();
    let theta = Theta::from(Pose::identity());
    let exact = model.exact_ranges(&theta).unwrap();
    let epoch = |sampler: &mut Sampler| {
        let ranges = Ranges::from_fn(exact.anchors(), exact.sensors(), |m, n| {
            exact
                .get(m, n)
                .filter(|_| sampler.uniform(0.0, 1.0) >= missing)
                .map(|d| d + 0.1 * sampler.normal())
        });
        Epoch { motion: Motion::rest(0.1), ranges: ranges.unwrap(), true_ranges: None }
    };
    let epochs = (0..2).map(|_| epoch(sampler)).collect();
    let initial = Initial { theta, variance: 1.0 };
    let process = ProcessNoise { sigma_q: 0.01, sigma_t: 0.01 };
    Recording { model, initial, process, epochs, truth: Vec::new() }
}

fn every_choice() -> Vec<EstimatorSettings> {
    let mut choices = Vec::new();
    for metric in [Metric::Frobenius, Metric::Information] {
        for decoupled in [false, true] {
            let manifold = rangelab::math::rotation::Manifold::O;
            choices.push(EstimatorSettings { metric, decoupled, manifold, ..EstimatorSettings::default() });
        }
    }
    choices
}

in_plane_and_space!(a_step_allocates_nothing, the_counter_counts);

fn a_step_allocates_nothing<const D: usize>() {
    let mut sampler = Sampler::new(1);
    for size in [[4, 5], [1, 1], [256, 500]] {
        for weighting in [Weighting::Common, Weighting::PerPair] {
            for missing in [0.0, 0.3] {
                let recording = recording::<D>(&mut sampler, size, weighting, missing);
                for settings in every_choice() {
                    for name in EstimatorName::ALL {
                        let mut filter = rangelab::track::estimator(name, &settings, &recording);
                        for epoch in &recording.epochs {
                            let (count, step) = allocations(|| filter.step(epoch));
                            assert!(step.is_ok(), "{name} {size:?}: {step:?}");
                            assert_eq!(count, 0, "{name} with {size:?} anchors and sensors");
                        }
                    }
                }
            }
        }
    }
}

fn the_counter_counts<const D: usize>() {
    let (count, _) = allocations(|| vec![0.0; D]);
    assert_eq!(count, 1);
    let recording = recording::<D>(&mut Sampler::new(2), [4, 5], Weighting::Common, 0.0);
    let build = || rangelab::track::estimator(EstimatorName::Kf, &EstimatorSettings::default(), &recording);
    assert!(allocations(build).0 > 0, "building an estimator allocates");
}

#[test]
fn a_step_of_an_inertial_filter_allocates_nothing() {
    let scenario = indoor_preset("indoor-u").unwrap();
    let recording = simulate_indoor(&scenario, 0).unwrap();
    let kinds = [FrontEndKind::GaussNewton, FrontEndKind::Isosceles];
    for (front_end, transport) in kinds.into_iter().zip([Transport::Congruence, Transport::Literal]) {
        let settings = FilterSettings { front_end, transport, ..scenario.filters.clone() };
        for name in FilterName::ALL {
            let mut filter = inertial_filter(name, &settings, &recording.model, &recording.start).unwrap();
            for epoch in &recording.epochs {
                let (count, step) = allocations(|| filter.step(epoch));
                assert!(step.is_ok(), "{name}: {step:?}");
                assert_eq!(count, 0, "{name}, {front_end:?}, {transport:?}");
            }
        }
    }
}
