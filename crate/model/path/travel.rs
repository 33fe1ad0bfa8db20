//! A body that travels along a path: where it is when, and its motion over each interval.

use core::f64::consts::TAU;
use core::iter::once;

use nalgebra::SVector;

use super::{Curve, PathSettings, Side};
use crate::math::float::{atan2, cos, sin, sqrt};
use crate::math::pose::Pose;
use crate::math::rotation::{MAX_ANGLES, Rotation, rotation_angles};
use crate::model::document::entries::points;
use crate::model::motion::Motion;

/// A path laid into the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Path<const D: usize> {
    shape: Shape<D>,
    period: f64,
    start: Pose<D>,
    heading: Direction,
}

#[derive(Clone, Debug, PartialEq)]
enum Shape<const D: usize> {
    Circle { radius: f64, climb: f64, side: Side },
    Eight { radius: f64 },
    Drawn { curve: Curve<D>, closed: bool },
}

/// A unit vector over the ground: cosine and sine of a heading.
type Direction = [f64; 2];

/// Where the path is at a time, and in which direction it goes on.
#[derive(Clone, Copy, Debug)]
struct Place<const D: usize> {
    position: SVector<f64, D>,
    direction: Direction,
}

/// Below this part of its length a direction that is not level counts as vertical.
const VERTICAL: f64 = 1e-9;

impl<const D: usize> Path<D> {
    /// Lays the path out from a start; settings and start were validated.
    pub(in crate::model) fn new(settings: &PathSettings, start: &Pose<D>) -> Self {
        let (period, shape) = match settings {
            PathSettings::Turn { radius, period, side } => {
                (period, Shape::Circle { radius: *radius, climb: 0.0, side: *side })
            }
            PathSettings::FigureEight { radius, period } => (period, Shape::Eight { radius: *radius }),
            PathSettings::Helix { radius, period, climb, side } => {
                (period, Shape::Circle { radius: *radius, climb: *climb, side: *side })
            }
            PathSettings::Drawn { points: drawn, closed, period } => {
                let through: alloc::vec::Vec<_> = once(start.position).chain(points(drawn)).collect();
                (period, Shape::Drawn { curve: Curve::through(&through, *closed), closed: *closed })
            }
        };
        let nose = start.rotation.matrix().column(0).into_owned();
        // A body whose x axis points straight up has no heading; the world's x axis stands in.
        let heading = level(&nose).unwrap_or([1.0, 0.0]);
        Self { shape, period: *period, start: *start, heading }
    }

    /// The pose at time 0: the start, turned about the vertical until it looks along the path.
    pub fn start(&self) -> Pose<D> {
        let turn = turn_between(self.heading, self.place(0.0, self.heading).direction);
        Pose {
            rotation: Rotation::exp(&about_vertical::<D>(turn)).compose(&self.start.rotation),
            ..self.start
        }
    }

    /// The motion over each interval: velocity is the displacement over the interval, angular velocity the turn about
    /// the vertical over it (by less than half a turn), so that a prediction with them is on the path to the last digit.
    pub fn motions(&self, interval: f64) -> impl Iterator<Item = Motion<D>> {
        let mut before = self.place(0.0, self.heading);
        (1_u32..).map(move |k| {
            let after = self.place(interval * f64::from(k), before.direction);
            let turn = turn_between(before.direction, after.direction);
            let velocity = (after.position - before.position) / interval;
            before = after;
            Motion { interval, velocity, angular_velocity: about_vertical::<D>(turn / interval) }
        })
    }

    /// The place at a time; `before` is the direction where the path has none, straight up or where it turns back.
    fn place(&self, time: f64, before: Direction) -> Place<D> {
        let rounds = time / self.period;
        match &self.shape {
            Shape::Circle { radius, climb, side } => {
                self.on_circle(rounds % 1.0, *radius, *side).raised(climb * rounds)
            }
            Shape::Eight { radius } => {
                let part = 2.0 * (rounds % 1.0);
                let side = if part < 1.0 { Side::Left } else { Side::Right };
                self.on_circle(part % 1.0, *radius, side)
            }
            Shape::Drawn { curve, closed } => {
                let part = if *closed { rounds % 1.0 } else { rounds.min(1.0) };
                let (position, tangent) = curve.position_and_tangent(part);
                Place { position, direction: level(&tangent).unwrap_or(before) }
            }
        }
    }

    /// A circle that leaves the start along the heading, after a part of the whole round.
    fn on_circle(&self, part: f64, radius: f64, side: Side) -> Place<D> {
        let angle = TAU * part;
        let (sine, half) = (sin(angle), sin(0.5 * angle));
        let sign = if side == Side::Left { 1.0 } else { -1.0 };
        let offset = turned(self.heading, [radius * sine, sign * radius * 2.0 * half * half]);
        let mut position = self.start.position;
        position[0] += offset[0];
        position[1] += offset[1];
        Place { position, direction: turned(self.heading, [cos(angle), sign * sine]) }
    }
}

impl<const D: usize> Place<D> {
    /// Higher by so much; in the plane there is no height.
    fn raised(mut self, height: f64) -> Self {
        if D == 3 {
            self.position[2] += height;
        }
        self
    }
}

/// The part of a vector over the ground, of length 1; none if the vector is zero or vertical.
fn level<const D: usize>(vector: &SVector<f64, D>) -> Option<Direction> {
    let length = sqrt(vector[0] * vector[0] + vector[1] * vector[1]);
    (length > VERTICAL * vector.norm()).then(|| [vector[0] / length, vector[1] / length])
}

/// A vector over the ground, forward and to the left of a heading, in the world frame.
fn turned([c, s]: Direction, [forward, left]: [f64; 2]) -> [f64; 2] {
    [c * forward - s * left, s * forward + c * left]
}

/// The angle that takes one direction to another, more than `-pi` and at most `pi`.
fn turn_between(from: Direction, to: Direction) -> f64 {
    atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1])
}

/// Rotation coordinates of a turn about the vertical: the only angle in the plane, the third in space.
fn about_vertical<const D: usize>(angle: f64) -> [f64; MAX_ANGLES] {
    let mut angles = [0.0; MAX_ANGLES];
    angles[rotation_angles(D) - 1] = angle;
    angles
}
