//! The field that is timed: 8 anchors on the walls of a room, a body of 5 sensors, 128 x 128 points.

use nalgebra::Vector3;
use rangelab::bounds::field::{Field, FieldLayout};
use rangelab::math::pose::Pose;
use rangelab::model::anchors::Anchors;
use rangelab::model::availability::Availability;
use rangelab::model::field_settings::FieldSettings;
use rangelab::model::noise::RangeNoise;
use rangelab::model::ranging::{RangeForm, RangeModel, Weighting};
use rangelab::model::topology::Topology;

/// A field and its grid.
pub struct FieldCase {
    field: Field,
    layout: FieldLayout,
}

impl FieldCase {
    /// The squared ranges as they are, or `||s||^2` projected out.
    pub fn new(form: RangeForm) -> Self {
        let corners =
            |z: f64| [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]].map(|[x, y]| Vector3::new(x, y, z));
        let anchors = Anchors::new([corners(0.3), corners(2.7)].concat()).unwrap();
        let sensors =
            [[-0.2, -0.2, -0.1], [0.2, -0.2, -0.1], [0.2, 0.2, -0.1], [-0.2, 0.2, -0.1], [0.0, 0.0, 0.4]];
        let topology = Topology::new(sensors.map(Vector3::from).to_vec()).unwrap();
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
