//! A short fingerprint of every number of a run, the same natively and in the browser only if every bit is.
#![allow(dead_code, reason = "each module's test uses its own part")]

use rangelab::bounds::field::{Field, FieldLayout, layout_of};
use rangelab::math::rotation::Manifold;
use rangelab::model::document::entries::PoseEntries;
use rangelab::model::field_settings::{FieldSettings, Quantity, Subject};
use rangelab::model::localize_settings::Loss;
use rangelab::model::noise::RangeNoise;
use rangelab::model::placement_settings::Criterion;
use rangelab::model::presets::preset;
use rangelab::model::ranging::RangeForm;
use rangelab::model::run::{BoundRecord, Run, StepRecord};
use rangelab::model::scenario::Scenario;
use rangelab::place::{best_next, field_rows, improve};
use rangelab::study::localization::LocalizationStudy;
use rangelab::study::localization::run::localize_trial;
use rangelab::with_dimension;

/// FNV-1a, 64 bits.
struct Fingerprint(u64);

impl Fingerprint {
    fn bytes(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    fn number(&mut self, x: f64) {
        self.bytes(&x.to_bits().to_le_bytes());
    }

    fn numbers<'a>(&mut self, numbers: impl IntoIterator<Item = &'a f64>) {
        for x in numbers {
            self.number(*x);
        }
    }

    /// `None` must not look like a step that is not there.
    fn optional<T>(&mut self, value: Option<&T>, write: impl Fn(&mut Self, &T)) {
        self.bytes(&[u8::from(value.is_some())]);
        if let Some(value) = value {
            write(self, value);
        }
    }

    fn pose(&mut self, pose: &PoseEntries) {
        self.numbers(pose.orientation.iter().flatten());
        self.numbers(&pose.position);
    }

    fn step(&mut self, step: &StepRecord) {
        self.number(step.time);
        self.pose(&step.prior);
        self.pose(&step.innovation);
        self.pose(&step.posterior);
        self.numbers(&[step.covariance_trace.orientation, step.covariance_trace.position]);
        self.numbers(step.position_covariance.iter().flatten());
        self.optional(step.rotation_covariance.as_ref(), |hash, rows| hash.numbers(rows.iter().flatten()));
        self.numbers(&[step.defect, step.nis.value]);
        self.bytes(&[u8::from(step.event)]);
        self.optional(step.errors.as_ref(), |hash, errors| {
            hash.numbers(&[errors.orientation_frobenius, errors.angle, errors.position]);
        });
        self.optional(step.nees.as_ref(), |hash, nees| hash.number(nees.value));
    }

    fn bound(&mut self, bound: &BoundRecord) {
        self.numbers(&[bound.orientation_trace, bound.position_trace]);
        self.optional(bound.angle_variance.as_ref(), |hash, variance| hash.number(*variance));
        self.numbers(bound.position_covariance.iter().flatten());
        self.optional(bound.rotation_covariance.as_ref(), |hash, rows| hash.numbers(rows.iter().flatten()));
    }
}

fn line(name: &str, write: impl FnOnce(&mut Fingerprint)) -> String {
    let mut hash = Fingerprint(0xcbf2_9ce4_8422_2325);
    write(&mut hash);
    format!("{:016x} {name}\n", hash.0)
}

/// A line for the truth, each estimator and each bound, and one for the whole JSON text.
pub fn fingerprints(run: &Run) -> String {
    let mut text = line("truth", |hash| {
        hash.numbers(run.anchors.iter().flatten());
        hash.numbers(&run.times);
        run.truth.iter().for_each(|pose| hash.optional(pose.as_ref(), Fingerprint::pose));
    });
    for estimator in &run.estimators {
        text += &line(estimator.name.name(), |hash| estimator.steps.iter().for_each(|step| hash.step(step)));
    }
    for bound in &run.bounds {
        text += &line(&bound.name, |hash| {
            bound.steps.iter().for_each(|step| hash.optional(step.as_ref(), Fingerprint::bound));
        });
    }
    text + &line("json", |hash| hash.bytes(run.to_json().as_bytes()))
}

/// A line for the sums of a study, as the rows of numbers in which blocks of trials travel.
pub fn study_fingerprint(name: &str, numbers: &[f64]) -> String {
    line(name, |hash| hash.numbers(numbers))
}

/// A line for the blocks of each of these figures, as rows of numbers, and one for what the sum of them says.
pub fn figure_fingerprints(
    blocks: impl Fn(&str, usize, u64) -> Vec<Vec<f64>>,
    json: impl Fn(&str, usize, u64, &[Vec<f64>]) -> String,
) -> String {
    let each = |(name, trials, seed)| {
        let blocks = blocks(name, trials, seed);
        let text = json(name, trials, seed, &blocks);
        line(&format!("blocks of {name}"), |hash| hash.numbers(blocks.iter().flatten()))
            + &line(&format!("report of {name}"), |hash| hash.bytes(text.as_bytes()))
    };
    let figures = [
        ("tracking-3", 27, 2),
        ("localization-6", 3, 2),
        ("indoor-4", 2, 2),
        ("indoor-9", 6, 2),
        ("kinematics-1", 2, 2),
        ("kinematics-2b", 11, 2),
    ];
    figures.map(each).concat()
}

/// A line for the field, one for the next anchor and one for better anchors, of a scenario in the plane and of two in space.
pub fn geometry_fingerprints() -> String {
    let each = |name: &str| {
        let scenario = preset(name).unwrap();
        let field = with_dimension!(scenario.dimension, D => Ok(field_values::<D>(&scenario))).unwrap();
        let anchors = |restart| improve(&scenario, restart).unwrap().anchors.concat();
        let better: Vec<f64> = (0..2).flat_map(anchors).collect();
        let best = best_next(&scenario).unwrap().unwrap();
        let next = [next_values(&scenario), best.point, vec![best.after.unwrap()]].concat();
        line(&format!("field of {name}"), |hash| hash.numbers(&field))
            + &line(&format!("next anchor of {name}"), |hash| hash.numbers(&next))
            + &line(&format!("placement of {name}"), |hash| hash.numbers(&better))
    };
    ["planar", "room", "coplanar-ceiling"].map(each).concat()
}

/// The next anchor over the plane of the field, of each criterion.
fn next_values(scenario: &Scenario) -> Vec<f64> {
    let layout = with_dimension!(scenario.dimension, D => layout_of::<D>(scenario, 9)).unwrap();
    let mut scenario = scenario.clone();
    scenario.field.subject = Subject::NextAnchor;
    let values = |criterion| {
        scenario.placement.criterion = criterion;
        field_rows(&scenario, &layout, 0, layout.height).unwrap()
    };
    [Criterion::A, Criterion::D, Criterion::E].map(values).concat()
}

fn field_values<const D: usize>(scenario: &Scenario) -> Vec<f64> {
    let setup = scenario.setup::<D>().unwrap();
    let value = |quantity, form, headings| {
        let settings = FieldSettings { quantity, form, headings, ..FieldSettings::default() };
        let layout = FieldLayout::new(setup.model.anchors(), &setup.start, &settings.plane, 17).unwrap();
        Field::new(&setup.model, &setup.availability, &setup.start, &settings).rows(&layout, 0, layout.height)
    };
    [value(Quantity::Position, RangeForm::Raw, 1), value(Quantity::Orientation, RangeForm::Projected, 3)]
        .concat()
}

/// A line for one trial and one for a short study of the snapshot estimators, with every choice that leads elsewhere.
pub fn snapshot_fingerprints() -> String {
    let each = |(name, noises): (&str, [RangeNoise; 2])| {
        let mut scenario = preset(name).unwrap();
        scenario.localize.multi_start = true;
        scenario.localize.loss = Loss::Huber { scale: 1.345 };
        scenario.mounting_sigma = 0.01;
        let run = localize_trial(&scenario, 0).unwrap();
        scenario.localize.manifold = Manifold::O;
        let study = LocalizationStudy::new(&scenario, noises.to_vec(), 7).unwrap();
        line(&format!("snapshot of {name}"), |hash| {
            hash.bytes(serde_json::to_string(&run).unwrap().as_bytes());
        }) + &line(&format!("localization of {name}"), |hash| {
            hash.numbers(&study.block(0).unwrap().to_numbers());
        })
    };
    let ranges = [0.3, 0.01].map(|sigma| RangeNoise::Range { sigma });
    let times = [20.0, 60.0].map(|zeta_db| RangeNoise::Toa { zeta_db });
    [
        ("planar", ranges),
        ("missing-ranges", ranges),
        ("three-anchors", ranges),
        ("localization-paper", times),
        ("localization-paper-redrawn", times),
    ]
    .map(each)
    .concat()
}
