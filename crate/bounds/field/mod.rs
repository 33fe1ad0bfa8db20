//! A bound over a plane: what the UC-CRB says of a body at each point of a grid.

pub mod kernel;
pub mod layout;
mod program;
mod sum;
mod trace;

use alloc::vec::Vec;

use crate::error::Result;
use crate::math::float::{cos, sin, sqrt};
use crate::math::number::{Lanes, Number};
use crate::math::pose::Pose;
use crate::math::rotation::rotation_angles;
use crate::model::availability::{Availability, Block};
use crate::model::field_settings::{FieldSettings, Quantity};
use crate::model::noise::SQUARED_RANGE_FLOOR;
use crate::model::ranging::{RangeForm, RangeModel};
use crate::model::scenario::Scenario;
use kernel::{least_part, trace_of_bound};
pub use layout::FieldLayout;

/// Stands where no bound exists: some motion of the body is not seen there.
pub const NONE: f64 = 1e30;

/// Less information than this part of what there would be with all else known is rounding, as in
/// [`crate::bounds::unitary_crb`].
const LEAST_PART: f64 = 1e-12;

/// Points that are computed together.
const LANES: usize = 4;

/// All that the bound at a point depends on, as plain numbers; flat scenes have third coordinates 0.
#[derive(Clone, Debug)]
pub struct Field {
    dimension: usize,
    anchors: Vec<[f64; 3]>,
    max_squared_ranges: Vec<f64>,
    /// For each heading the levers of the sensors in the world frame, in lengths of the body.
    levers: Vec<Vec<[f64; 3]>>,
    /// Length that levers are measured in, m: angles times it compare with shifts.
    size: f64,
    /// `var d = linear r^2 + quadratic r^4`.
    law: [f64; 2],
    blocks: Vec<Block>,
    form: RangeForm,
    quantity: Quantity,
}

impl Field {
    /// The field of a body with the attitude of `pose`.
    ///
    /// The noise is that of each pair, as in all bounds. Where the settings ask for several headings, the body is turned
    /// about the vertical (in the plane: turned) by equal parts of a full turn.
    pub fn new<const D: usize>(
        model: &RangeModel<D>,
        availability: &Availability<D>,
        pose: &Pose<D>,
        settings: &FieldSettings,
    ) -> Self {
        let lift = |v: &[f64]| core::array::from_fn(|i| v.get(i).copied().unwrap_or(0.0));
        let topology = model.topology();
        let size = topology.size();
        let levers = |heading: usize| {
            let angle = core::f64::consts::TAU * heading as f64 / settings.headings as f64;
            let (sine, cosine) = if heading == 0 { (0.0, 1.0) } else { (sin(angle), cos(angle)) };
            let sensors = topology.sensors().iter();
            let turned = sensors.map(|c| {
                let [x, y, z] = lift((pose.rotation.matrix() * c).as_slice());
                [(cosine * x - sine * y) / size, (sine * x + cosine * y) / size, z / size]
            });
            turned.collect()
        };
        let law = model.noise().law();
        Self {
            dimension: D,
            anchors: model.anchors().positions().iter().map(|a| lift(a.as_slice())).collect(),
            max_squared_ranges: (0..model.anchors().len())
                .map(|m| availability.max_squared_range(m))
                .collect(),
            levers: (0..settings.headings).map(levers).collect(),
            size,
            law: law.coefficients(),
            blocks: availability.blocks().to_vec(),
            form: settings.form,
            quantity: settings.quantity,
        }
    }

    /// The bound at some points of the world, m or rad; [`NONE`] where there is none. The same bits whatever points are
    /// computed together.
    pub fn values(&self, points: &[[f64; 3]], values: &mut Vec<f64>) {
        for chunk in points.chunks(LANES) {
            let lane = |i: usize| chunk.get(i).unwrap_or(&chunk[0]);
            let point = core::array::from_fn(|axis| Lanes::<LANES>(core::array::from_fn(|i| lane(i)[axis])));
            values.extend_from_slice(&self.at(point).0[..chunk.len()]);
        }
    }

    /// The bound at one point.
    pub fn value(&self, point: [f64; 3]) -> f64 {
        // Side by side with itself: the same code, and no second copy of it in the module.
        self.at(point.map(|x| Lanes([x; LANES]))).0[0]
    }

    /// Rows of a grid, row by row.
    pub fn rows(&self, layout: &FieldLayout, first: usize, count: usize) -> Vec<f64> {
        let mut values = Vec::with_capacity(layout.width * count);
        let mut points = Vec::with_capacity(layout.width);
        for row in first..first.saturating_add(count).min(layout.height) {
            points.clear();
            points.extend((0..layout.width).map(|column| layout.centre(column, row)));
            self.values(&points, &mut values);
        }
        values
    }

    #[inline(never)]
    fn at<N: Number + Root>(&self, point: [N; 3]) -> N {
        let zero = point[0].constant(0.0);
        let mut sum = zero;
        for levers in &self.levers {
            let j = self.information(point, levers);
            sum = sum + self.squared(&j);
        }
        let mean = sum / zero.constant(self.levers.len() as f64);
        let none = zero.constant(NONE);
        N::choose(none.above(sum), mean.root() * zero.constant(self.scale()), none)
    }

    /// What the body's lengths make of the root of the trace: rad for angles.
    fn scale(&self) -> f64 {
        match self.quantity {
            Quantity::Position => 1.0,
            Quantity::Orientation => 1.0 / self.size,
        }
    }

    /// The trace of the bound from the information, in square metres; at least [`NONE`] where there is none.
    fn squared<N: Number>(&self, j: &kernel::Information<N>) -> N {
        let (trace, digits) = self.judged(j);
        let seen = N::both(digits.above(trace.constant(LEAST_PART)), trace.above(trace.constant(0.0)));
        N::choose(seen, trace, trace.constant(NONE))
    }

    /// The trace, and the least part of an information that it rests on.
    fn judged<N: Number>(&self, j: &kernel::Information<N>) -> (N, N) {
        let (order, angles) = self.order();
        let wanted = match self.quantity {
            Quantity::Position => self.dimension,
            Quantity::Orientation => angles,
        };
        let order = &order[..angles + self.dimension];
        let (trace, digits) = trace_of_bound(j, order, wanted);
        let (eliminated, kept) = order.split_at(order.len() - wanted);
        let smaller = |one: N, other: N| N::choose(one.above(other), other, one);
        (trace, smaller(digits, smaller(least_part(j, eliminated), least_part(j, kept))))
    }

    /// The parameters of the information, those that are wanted last, and how many angles there are.
    fn order(&self) -> ([usize; 6], usize) {
        let angles = rotation_angles(self.dimension);
        let order = match (self.dimension, self.quantity) {
            (2, Quantity::Position) => [2, 3, 4, 0, 0, 0],
            (2, Quantity::Orientation) => [3, 4, 2, 0, 0, 0],
            (_, Quantity::Position) => [0, 1, 2, 3, 4, 5],
            (_, Quantity::Orientation) => [3, 4, 5, 0, 1, 2],
        };
        (order, angles)
    }
}

/// Square roots of numbers and lanes.
trait Root {
    fn root(self) -> Self;
}

impl<const L: usize> Root for Lanes<L> {
    fn root(self) -> Self {
        Self(self.0.map(sqrt))
    }
}

/// The field of a scenario: its settings, the pose that its body starts from, its anchors as they are listed.
///
/// # Errors
/// [`crate::Error::Invalid`] with every problem of the scenario, [`crate::Error::Size`] for another dimension.
pub fn field_of<const D: usize>(scenario: &Scenario) -> Result<Field> {
    let setup = scenario.setup::<D>()?;
    Ok(Field::new(&setup.model, &setup.availability, &setup.start, &scenario.field))
}

/// The grid of a scenario's field with `resolution` cells along its longer edge.
///
/// # Errors
/// As [`field_of`], and those of [`FieldLayout::new`].
pub fn layout_of<const D: usize>(scenario: &Scenario, resolution: usize) -> Result<FieldLayout> {
    let setup = scenario.setup::<D>()?;
    FieldLayout::new(setup.model.anchors(), &setup.start, &scenario.field.plane, resolution)
}

/// Squared ranges below this are weighted as if they were this long.
const FLOOR: f64 = SQUARED_RANGE_FLOOR;
