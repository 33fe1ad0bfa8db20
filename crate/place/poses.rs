//! The placement that a scenario asks for.

use alloc::vec::Vec;
use core::f64::consts::TAU;

use nalgebra::SVector;

use super::figure::Figure;
use super::objective::Placement;
use crate::error::Result;
use crate::math::pose::Pose;
use crate::math::rotation::Rotation;
use crate::model::document::entries::{points, vector};
use crate::model::placement_settings::Region;
use crate::model::scenario::Scenario;

/// Places of the body along each edge of the region: both ends and the middle.
const PLACES: usize = 3;

impl<const D: usize> Placement<D> {
    /// Reads the `placement` of a scenario; form of the ranges and headings are those of its `field`. A region is a grid
    /// of 3 places along each axis, its ends included; each place is combined with each heading.
    ///
    /// # Errors
    /// As [`Scenario::setup`].
    pub fn of(scenario: &Scenario) -> Result<Self> {
        let setup = scenario.setup::<D>()?;
        let (settings, topology) = (&scenario.placement, setup.model.topology().clone());
        let figure =
            Figure { criterion: settings.criterion, target: settings.target, body_size: topology.size() };
        let places = settings.region.as_ref().map_or_else(|| [setup.start.position].into(), grid);
        let turned =
            |k: usize| turned(&setup.start.rotation, TAU * k as f64 / scenario.field.headings as f64);
        let rotations: Vec<_> = (0..scenario.field.headings).map(turned).collect();
        let at =
            |position: SVector<f64, D>| rotations.iter().map(move |&rotation| Pose { rotation, position });
        Ok(Self {
            noise: *setup.model.noise(),
            availability: setup.availability,
            poses: places.into_iter().flat_map(at).collect(),
            form: scenario.field.form,
            over: settings.over,
            figure,
            topology,
        })
    }

    /// The anchors of a scenario that was validated, m.
    pub(super) fn anchors_of(scenario: &Scenario) -> Vec<SVector<f64, D>> {
        points(&scenario.anchors)
    }
}

fn grid<const D: usize>(region: &Region) -> Vec<SVector<f64, D>> {
    let (low, high) = (vector::<D>(&region.low), vector::<D>(&region.high));
    let mut places = Vec::from([low]);
    for axis in 0..D {
        let along = |place: SVector<f64, D>| {
            (0..PLACES).map(move |k| {
                let mut place = place;
                place[axis] += (high[axis] - low[axis]) * k as f64 / (PLACES - 1) as f64;
                place
            })
        };
        places = places.into_iter().flat_map(along).collect();
    }
    places
}

/// Turned about the vertical of the world by an angle; in the plane there is only that turn.
fn turned<const D: usize>(rotation: &Rotation<D>, angle: f64) -> Rotation<D> {
    let phi = if D == 2 { [angle, 0.0, 0.0] } else { [0.0, 0.0, angle] };
    Rotation::exp(&phi).compose(rotation)
}
