//! The field of a bound: the same numbers as the bound itself, at every point.

#![allow(clippy::float_cmp, reason = "what is copied is the same")]

mod availability;
mod layout;

use nalgebra::{SMatrix, SVector};
use rangelab::bounds::field::{Field, FieldLayout, NONE};
use rangelab::bounds::{fisher_information_of, unitary_crb};
use rangelab::math::float::{cos, sin};
use rangelab::math::pose::{Pose, Theta};
use rangelab::math::rotation::Rotation;
use rangelab::model::availability::Availability;
use rangelab::model::field_settings::{FieldSettings, Quantity};
use rangelab::model::presets::{PRESETS, preset};
use rangelab::model::ranges::Ranges;
use rangelab::model::ranging::{RangeForm, RangeModel, Weighting};
use rangelab::model::scenario::Scenario;
use rangelab::with_dimension;

/// The bound at one pose as `bounds` gives it, with the ranges that can be measured; `None` where there is none.
fn bound_at<const D: usize>(
    model: &RangeModel<D>,
    availability: &Availability<D>,
    pose: &Pose<D>,
    settings: &FieldSettings,
) -> Option<f64> {
    let (anchors, topology) = (model.anchors().clone(), model.topology().clone());
    let model = RangeModel::new(anchors, topology, *model.noise(), Weighting::PerPair).unwrap();
    let exact = model.exact_ranges(&Theta::from(*pose)).unwrap();
    let measurable = model.measurable(pose, availability);
    let measured = Ranges::from_fn(exact.anchors(), exact.sensors(), |m, n| {
        measurable[m * exact.sensors() + n].then(|| exact.get(m, n).unwrap())
    });
    let information =
        fisher_information_of(&model, pose, &measured.unwrap(), settings.form, &mut model.range_buffer());
    let bound = unitary_crb(&information.unwrap()).ok()?;
    Some(match settings.quantity {
        Quantity::Position => bound.shift_block().trace().sqrt(),
        Quantity::Orientation => bound.angle_trace().sqrt(),
    })
}

/// A body turned about the vertical.
fn turned<const D: usize>(pose: &Pose<D>, angle: f64) -> Pose<D> {
    let (s, c) = (sin(angle), cos(angle));
    let mut matrix = SMatrix::<f64, D, D>::identity();
    (matrix[(0, 0)], matrix[(0, 1)], matrix[(1, 0)], matrix[(1, 1)]) = (c, -s, s, c);
    let rotation = Rotation::from_matrix(&(matrix * pose.rotation.matrix())).unwrap();
    Pose { rotation, ..*pose }
}

/// Root mean square over headings, `None` where one of them has no bound.
fn averaged<const D: usize>(
    model: &RangeModel<D>,
    availability: &Availability<D>,
    pose: &Pose<D>,
    settings: &FieldSettings,
) -> Option<f64> {
    let headings = settings.headings as f64;
    let mut sum = 0.0;
    for k in 0..settings.headings {
        let pose = turned(pose, std::f64::consts::TAU * k as f64 / headings);
        let bound = bound_at(model, availability, &pose, settings)?;
        sum += bound * bound;
    }
    Some((sum / headings).sqrt())
}

/// Compares a grid of points of a scenario; returns how many had a bound.
fn compare<const D: usize>(scenario: &Scenario, settings: &FieldSettings) -> usize {
    let setup = scenario.setup::<D>().unwrap();
    let field = Field::new(&setup.model, &setup.availability, &setup.start, settings);
    let layout = FieldLayout::new(setup.model.anchors(), &setup.start, &settings.plane, 13).unwrap();
    let values = field.rows(&layout, 0, layout.height);
    assert_eq!(values.len(), layout.width * layout.height);
    let mut seen = 0;
    for (k, &value) in values.iter().enumerate() {
        let centre = layout.centre(k % layout.width, k / layout.width);
        assert_eq!(value.to_bits(), field.value(centre).to_bits(), "alone and side by side");
        let position = SVector::<f64, D>::from_fn(|i, _| centre[i]);
        let pose = Pose { position, ..setup.start };
        let expected = averaged(&setup.model, &setup.availability, &pose, settings);
        let name = &scenario.name;
        match expected {
            None => assert!(value >= NONE, "{name} {settings:?} {centre:?}: {value} where no bound is"),
            Some(expected) => {
                let error = (value / expected - 1.0).abs();
                assert!(error < 1e-9, "{name} {settings:?} {centre:?}: {value} against {expected}");
                seen += 1;
            }
        }
    }
    seen
}

fn all_settings() -> impl Iterator<Item = FieldSettings> {
    [Quantity::Position, Quantity::Orientation].into_iter().flat_map(|quantity| {
        [RangeForm::Raw, RangeForm::Projected].into_iter().flat_map(move |form| {
            [1, 3].map(|headings| FieldSettings { quantity, form, headings, ..FieldSettings::default() })
        })
    })
}

#[test]
fn equals_the_bound_itself_in_every_preset() {
    let mut seen = 0;
    for each in PRESETS {
        let scenario = each.scenario();
        for settings in all_settings() {
            let points = with_dimension!(scenario.dimension, D => Ok(compare::<D>(&scenario, &settings)));
            seen += points.unwrap();
        }
    }
    assert!(seen > 5000, "{seen} points had a bound");
}

#[test]
fn a_sensor_on_an_anchor_is_no_trouble() {
    let mut scenario = preset("room").unwrap();
    let setup = scenario.setup::<3>().unwrap();
    let lever = setup.start.rotation.matrix() * setup.model.topology().sensors()[0];
    let anchor = setup.model.anchors().positions()[2];
    scenario.start.position = (anchor - lever).as_slice().to_vec();
    let setup = scenario.setup::<3>().unwrap();
    for settings in all_settings().filter(|settings| settings.headings == 1) {
        let field = Field::new(&setup.model, &setup.availability, &setup.start, &settings);
        let expected = bound_at(&setup.model, &setup.availability, &setup.start, &settings).unwrap();
        let value = field.value([0, 1, 2].map(|i| setup.start.position[i]));
        assert!((value / expected - 1.0).abs() < 1e-9, "{settings:?}: {value} against {expected}");
    }
}
