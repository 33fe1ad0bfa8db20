//! The fields that are timed: 8 anchors on the walls of a room, a body of 5 sensors, 128 x 128 points.

use nalgebra::Vector3;
use rangelab::bounds::field::{Field, FieldLayout, layout_of};
use rangelab::math::pose::Pose;
use rangelab::model::anchors::Anchors;
use rangelab::model::availability::Availability;
use rangelab::model::field_settings::FieldSettings;
use rangelab::model::noise::RangeNoise;
use rangelab::model::ranging::{RangeForm, RangeModel, Weighting};
use rangelab::model::scenario::Scenario;
use rangelab::model::topology::Topology;
use rangelab::place::NextAnchor;

/// A field and its grid.
pub struct FieldCase {
    field: Field,
    layout: FieldLayout,
}

/// One more anchor over the same grid, in the same scene.
pub struct NextCase {
    next: NextAnchor<3>,
    layout: FieldLayout,
}

/// The cases by number: the bound of the raw ranges, that of the projected ones, one more anchor.
pub fn pass(case: usize) -> f64 {
    match case {
        0 => FieldCase::new(RangeForm::Raw).pass(),
        1 => FieldCase::new(RangeForm::Projected).pass(),
        _ => NextCase::new().pass(),
    }
}

const SENSORS: [[f64; 3]; 5] =
    [[-0.2, -0.2, -0.1], [0.2, -0.2, -0.1], [0.2, 0.2, -0.1], [-0.2, 0.2, -0.1], [0.0, 0.0, 0.4]];

fn anchors() -> Vec<[f64; 3]> {
    let corners = |z: f64| [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]].map(|[x, y]| [x, y, z]);
    [corners(0.3), corners(2.7)].concat()
}

impl FieldCase {
    /// The squared ranges as they are, or `||s||^2` projected out.
    pub fn new(form: RangeForm) -> Self {
        let anchors = Anchors::new(anchors().into_iter().map(Vector3::from).collect()).unwrap();
        let topology = Topology::new(SENSORS.map(Vector3::from).to_vec()).unwrap();
        let noise = RangeNoise::Range { sigma: 0.05 };
        let model = RangeModel::new(anchors, topology, noise, Weighting::PerPair).unwrap();
        let pose = Pose { position: Vector3::new(4.0, 4.0, 1.2), ..Pose::identity() };
        let settings = FieldSettings { form, ..FieldSettings::default() };
        let field = Field::new(&model, &Availability::unlimited(), &pose, &settings);
        let layout = FieldLayout::new(model.anchors(), &pose, &settings.plane, 128).unwrap();
        assert_eq!((layout.width, layout.height), (128, 128));
        Self { field, layout }
    }

    /// Computes it; the sum keeps the work from being optimized away.
    pub fn pass(&self) -> f64 {
        self.field.rows(&self.layout, 0, self.layout.height).iter().sum()
    }
}

impl NextCase {
    /// Judged by the root of the trace of the bound on the position.
    pub fn new() -> Self {
        let text = format!(
            r#"{{"version": 1, "dimension": 3, "anchors": {:?}, "sensors": {SENSORS:?},
                "noise": {{"kind": "range", "sigma": 0.05}}, "start": {{"orientation": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "position": [4.0, 4.0, 1.2]}}}}"#,
            anchors()
        );
        let scenario = Scenario::from_json(&text).unwrap();
        let layout = layout_of::<3>(&scenario, 128).unwrap();
        assert_eq!((layout.width, layout.height), (128, 128));
        Self { next: NextAnchor::of(&scenario).unwrap(), layout }
    }

    /// Computes it.
    pub fn pass(&self) -> f64 {
        self.next.rows(&self.layout, 0, self.layout.height).iter().sum()
    }
}
