//! What is timed, shared by the native and the WebAssembly bench: a body that turns on the spot, ranged for ever.

use nalgebra::{Vector3, vector};
use rand::{RngExt, SeedableRng};
use rand_distr::StandardNormal;
use rand_pcg::Pcg64Mcg;
use rangelab::math::pose::{Pose, Theta};
use rangelab::model::anchors::Anchors;
use rangelab::model::epoch::{Epoch, Initial, Recording};
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
use rangelab::model::motion::{Motion, ProcessNoise};
use rangelab::model::noise::RangeNoise;
use rangelab::model::ranges::Ranges;
use rangelab::model::ranging::{RangeModel, Weighting};
use rangelab::model::topology::Topology;
use rangelab::track::filter::Estimator;

/// One line of the table.
pub struct Case {
    /// What is timed.
    pub name: &'static str,
    estimator: EstimatorName,
    /// Number of anchors and of sensors.
    pub size: [usize; 2],
    weighting: Weighting,
    centred: bool,
    /// What a step may take natively, us.
    pub target: Option<f64>,
}

const PAPER: [usize; 2] = [4, 5];
const LARGE: [usize; 2] = [256, 500];

const fn case(name: &'static str, estimator: EstimatorName, size: [usize; 2], target: Option<f64>) -> Case {
    Case { name, estimator, size, weighting: Weighting::Common, centred: true, target }
}

/// All that is timed.
pub const CASES: [Case; 10] = [
    case("KF, fast path", EstimatorName::Kf, PAPER, Some(0.5)),
    Case {
        centred: false,
        ..case("KF, general path (body off centre)", EstimatorName::Kf, PAPER, Some(1.5))
    },
    Case {
        weighting: Weighting::PerPair,
        ..case("KF, general path (weights per pair)", EstimatorName::Kf, PAPER, Some(1.5))
    },
    case("KF-ortho", EstimatorName::Ortho, PAPER, None),
    case("ET-KF", EstimatorName::EtKf, PAPER, None),
    case("UC-KF", EstimatorName::UcKf, PAPER, Some(5.0)),
    case("ESKF", EstimatorName::Eskf, PAPER, None),
    case("ESKF raw", EstimatorName::EskfRaw, PAPER, None),
    case("KF, fast path", EstimatorName::Kf, LARGE, None),
    Case {
        weighting: Weighting::PerPair,
        ..case("KF, general path (weights per pair)", EstimatorName::Kf, LARGE, None)
    },
];

/// Steps of a full turn, after which the same epochs come again.
const TURN: usize = 64;

/// An estimator under way, with its epochs.
pub struct Running {
    estimator: Box<dyn Estimator<3> + Send>,
    epochs: Vec<Epoch<3>>,
    next: usize,
}

impl Running {
    /// The case at its start, at the scale and noise of [T] Sec. V.
    pub fn new(case: &Case) -> Self {
        let mut random = Pcg64Mcg::seed_from_u64(1);
        let recording = record(case, &mut random);
        let estimator = rangelab::track::estimator(case.estimator, &EstimatorSettings::default(), &recording);
        Self { estimator, epochs: recording.epochs, next: 0 }
    }

    /// Makes steps; the sum of positions keeps the work from being optimized away.
    pub fn steps(&mut self, count: usize) -> f64 {
        let mut sum = 0.0;
        for _ in 0..count {
            let step = self.estimator.step(&self.epochs[self.next]).expect("a well-placed body is seen");
            sum += step.posterior.position[0];
            self.next = (self.next + 1) % TURN;
        }
        sum
    }
}

fn record(case: &Case, random: &mut Pcg64Mcg) -> Recording<3> {
    let mut uniform = |half: f64| half * (2.0 * random.random::<f64>() - 1.0);
    let mut point = |half: f64| Vector3::new(uniform(half), uniform(half), uniform(half));
    let anchors = (0..case.size[0]).map(|_| point(1000.0)).collect();
    let mut sensors: Vec<_> = (0..case.size[1]).map(|_| point(0.5)).collect();
    let mean = sensors.iter().sum::<Vector3<f64>>() / sensors.len() as f64;
    if case.centred {
        for c in &mut sensors {
            *c -= mean;
        }
    }
    let (anchors, topology) = (Anchors::new(anchors).unwrap(), Topology::new(sensors).unwrap());
    let noise = RangeNoise::SquaredRange { sigma: 0.0316 };
    let model = RangeModel::new(anchors, topology, noise, case.weighting).unwrap();
    let motion = Motion {
        interval: 1.0,
        velocity: vector![0.0, 0.0, 0.0],
        angular_velocity: [0.0, 0.0, core::f64::consts::TAU / TURN as f64],
    };
    let mut pose = Pose::identity();
    let initial = Initial { theta: Theta::from(pose), variance: 100.0 };
    let epochs = (0..TURN)
        .map(|_| {
            pose = motion.predict_pose(&pose, &motion.rotation());
            let exact = model.exact_ranges(&Theta::from(pose)).unwrap();
            let ranges = Ranges::from_fn(exact.anchors(), exact.sensors(), |m, n| {
                let noise: f64 = random.sample(StandardNormal);
                exact.get(m, n).map(|d| d + 0.0316 * d.sqrt() * noise)
            });
            Epoch { motion, ranges: ranges.unwrap(), true_ranges: None }
        })
        .collect();
    let process = ProcessNoise { sigma_q: 0.0175, sigma_t: 0.1 };
    Recording { model, initial, process, epochs, truth: Vec::new() }
}
