//! The field that a graphics device computes in single precision, held against that of the crate in double precision.

#![allow(clippy::cast_possible_truncation, reason = "single precision is what the card computes in")]

use rangelab::bounds::field::{Field, FieldLayout, NONE};
use rangelab::model::availability::Obstacle;
use rangelab::model::field_settings::{FieldSettings, Quantity};
use rangelab::model::presets::{PRESETS, preset};
use rangelab::model::ranging::RangeForm;
use rangelab::model::scenario::Scenario;
use rangelab::with_dimension;
use rangelab_scene::Offscreen;
use rangelab_scene::field::FieldData;

const RESOLUTION: usize = 96;

/// What a comparison of all cells came to.
#[derive(Default)]
struct Tally {
    /// Cells whose bound was given in single precision.
    resolved: usize,
    /// Cells that were left to double precision although there is a bound.
    left: usize,
    /// Cells without a bound.
    none: usize,
    /// Largest relative difference of the resolved ones.
    worst: f64,
}

fn compute(scene: &mut Offscreen, field: &Field, layout: &FieldLayout) -> Vec<f32> {
    let (width, height) = (u32::try_from(layout.width).unwrap(), u32::try_from(layout.height).unwrap());
    let rectangle: Vec<f32> =
        [layout.corner, layout.u, layout.v].as_flattened().iter().map(|&x| x as f32).collect();
    let style =
        [0.1, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0].to_vec();
    let coarse = FieldData { values: vec![1.0], width: 1, height: 1, rectangle, style };
    scene.set_field(&coarse).unwrap();
    scene.set_field_kernel(&field.program()).unwrap();
    scene.compute_field(&field.parameters(layout), width, height).unwrap();
    scene.read_fine_field().unwrap()
}

fn compare<const D: usize>(scene: &mut Offscreen, scenario: &Scenario, settings: &FieldSettings) -> Tally {
    let setup = scenario.setup::<D>().unwrap();
    let field = Field::new(&setup.model, &setup.availability, &setup.start, settings);
    let layout = FieldLayout::new(setup.model.anchors(), &setup.start, &settings.plane, RESOLUTION).unwrap();
    let single = compute(scene, &field, &layout);
    let double = field.rows(&layout, 0, layout.height);
    assert_eq!(single.len(), double.len());
    let mut tally = Tally::default();
    let mut differing = Vec::new();
    for (single, double) in single.iter().map(|&x| f64::from(x)).zip(double) {
        match (single >= 0.0, double < NONE) {
            (true, true) => {
                tally.resolved += 1;
                differing.push((single / double - 1.0).abs());
            }
            (true, false) => panic!("{}: {single} where there is no bound", scenario.name),
            (false, true) => tally.left += 1,
            (false, false) => tally.none += 1,
        }
    }
    // A cell on the edge of a shadow may lie on either side of it in single precision; only there, and few.
    differing.sort_by(f64::total_cmp);
    let edges = if setup.availability.is_unlimited() { 0 } else { differing.len() / 200 };
    differing.truncate(differing.len() - edges);
    tally.worst = differing.last().copied().unwrap_or(0.0);
    tally
}

fn settings() -> impl Iterator<Item = FieldSettings> {
    [Quantity::Position, Quantity::Orientation].into_iter().flat_map(|quantity| {
        [(RangeForm::Raw, 1), (RangeForm::Projected, 1), (RangeForm::Raw, 5)]
            .map(|(form, headings)| FieldSettings { quantity, form, headings, ..FieldSettings::default() })
    })
}

fn hold(scenarios: &[Scenario], least_resolved: f64) {
    let mut scene = Offscreen::new(8, 8).unwrap();
    assert!(scene.can_compute(), "this device cannot compute");
    let (mut resolved, mut bounded) = (0, 0);
    for scenario in scenarios {
        for settings in settings() {
            let tally =
                with_dimension!(scenario.dimension, D => Ok(compare::<D>(&mut scene, scenario, &settings)));
            let Tally { resolved: here, left, none, worst } = tally.unwrap();
            let (quantity, form, headings) = (settings.quantity, settings.form, settings.headings);
            println!(
                "{:24} {quantity:?} {form:?} x{headings}: {here} cells to {worst:.1e}, {left} left, {none} none",
                scenario.name
            );
            assert!(worst < 1e-3, "{}: {worst}", scenario.name);
            resolved += here;
            bounded += here + left;
        }
    }
    let share = resolved as f64 / bounded as f64;
    println!("{:.1} % of the cells with a bound are resolved in single precision", 100.0 * share);
    assert!(share > least_resolved, "{share}");
}

#[test]
fn single_precision_agrees_in_every_preset() {
    hold(&PRESETS.map(|each| each.scenario()), 0.7);
}

#[test]
fn shadows_lie_where_they_are() {
    let mut scenario = preset("room").unwrap();
    let [x, y] = [scenario.start.position[0], scenario.start.position[1]];
    scenario.availability.max_ranges = vec![None, Some(4.0), None, None, Some(5.0), None];
    scenario.availability.obstacles = vec![
        Obstacle::Wall {
            from: vec![x + 0.8, y - 1.0],
            to: vec![x + 1.2, y + 1.5],
            bottom: None,
            top: Some(2.0),
        },
        Obstacle::Box { low: vec![x - 2.0, y - 2.0, 0.0], high: vec![x - 1.5, y + 1.0, 1.8] },
    ];
    hold(&[scenario], 0.5);
}
