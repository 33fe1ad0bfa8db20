//! How the curve of an estimator or a bound looks: as in the page's light theme, a mark or a dash for each colour.

use rangelab::math::float::{cos, radians, sin};
use rangelab::study::figures::report::{Curve, CurveKind};

use super::drawing::{Group, Place, Shape};
use crate::cli::picture::canvas::Colour;
pub use crate::cli::picture::colours::{INK, PAPER};

pub const SOFT: Colour = [0x4b, 0x53, 0x60];
pub const FRAME: Colour = [0xc9, 0xce, 0xd6];
pub const GRID: Colour = [0xd5, 0xd9, 0xe0];
pub const WARNING: Colour = [0x8a, 0x32, 0x00];
const BOUND: Colour = [0x4b, 0x53, 0x60];

/// Name, colour and mark of an estimator.
const ESTIMATORS: [(&str, Colour, Mark); 36] = [
    ("kf", [0xaa, 0x40, 0x00], Mark::Ring),
    ("ortho", [0xbd, 0x86, 0x00], Mark::Square),
    ("uc-kf", [0x02, 0x51, 0x92], Mark::Triangle),
    ("et-kf", [0xb4, 0x67, 0xa4], Mark::Diamond),
    ("eskf", [0x44, 0x8d, 0x65], Mark::Disc),
    ("eskf-raw", [0x57, 0x57, 0x57], Mark::Cross),
    ("classical-ls", [0x57, 0x57, 0x57], Mark::Cross),
    ("ls", [0xaa, 0x40, 0x00], Mark::Ring),
    ("suc-ls", [0xbd, 0x86, 0x00], Mark::Square),
    ("suc-tls", [0xbd, 0x86, 0x00], Mark::Square),
    ("suc-ls-weighted", [0xbd, 0x86, 0x00], Mark::Disc),
    ("ouc-ls", [0x02, 0x51, 0x92], Mark::Triangle),
    ("ouc-tls-printed", [0xb4, 0x67, 0xa4], Mark::Diamond),
    ("ouc-tls", [0x44, 0x8d, 0x65], Mark::Disc),
    ("gauss-newton", [0x57, 0x57, 0x57], Mark::Square),
    ("maximum-likelihood", [0x57, 0x57, 0x57], Mark::Disc),
    ("ekf", [0xaa, 0x40, 0x00], Mark::Ring),
    ("ekf-rie", [0x02, 0x51, 0x92], Mark::Triangle),
    ("ukf", [0xb4, 0x67, 0xa4], Mark::Diamond),
    ("ukf-rie", [0xb4, 0x67, 0xa4], Mark::Triangle),
    ("mekf", [0x44, 0x8d, 0x65], Mark::Disc),
    ("algorithm-1-rank1", [0xaa, 0x40, 0x00], Mark::Square),
    ("algorithm-1-so", [0xaa, 0x40, 0x00], Mark::Triangle),
    ("algorithm-1-literal", [0xaa, 0x40, 0x00], Mark::Cross),
    ("algorithm-2-rank1", [0xbd, 0x86, 0x00], Mark::Triangle),
    ("algorithm-2-so", [0xbd, 0x86, 0x00], Mark::Square),
    ("algorithm-2-literal", [0xbd, 0x86, 0x00], Mark::Cross),
    ("snapshot-sync", [0xb4, 0x67, 0xa4], Mark::Diamond),
    ("maximum-likelihood-distances", [0x44, 0x8d, 0x65], Mark::Disc),
    ("maximum-likelihood-accelerometers", [0x02, 0x51, 0x92], Mark::Ring),
    ("multidimensional-scaling", [0x57, 0x57, 0x57], Mark::Triangle),
    ("range-polynomial-2", [0x57, 0x57, 0x57], Mark::Cross),
    ("range-polynomial-3", [0x44, 0x8d, 0x65], Mark::Disc),
    ("range-polynomial-4", [0xb4, 0x67, 0xa4], Mark::Diamond),
    ("range-polynomial-5", [0x02, 0x51, 0x92], Mark::Square),
    ("range-polynomial-6", [0x02, 0x51, 0x92], Mark::Ring),
];
/// Estimators that are drawn over others whose numbers they often have, or whose colour.
const BROKEN: [(&str, &[f32]); 8] = [
    ("ekf-rie", DASH),
    ("ukf-rie", DASH),
    ("algorithm-1-literal", DOTS),
    ("algorithm-1-so", DASH),
    ("algorithm-2-literal", DOTS),
    ("algorithm-2-so", DASH),
    ("range-polynomial-4", DASH),
    ("range-polynomial-5", DASH),
];
/// Bounds without a dash of their own have this one too.
const DASH: &[f32] = &[7.0, 4.0];
const DOTS: &[f32] = &[2.0, 4.0];
const DASH_DOT: &[f32] = &[10.0, 3.0, 2.0, 3.0];
const DASHES: [(&str, &[f32]); 8] = [
    ("posterior_crb", DASH),
    ("posterior_crb_raw", DASH_DOT),
    ("linear_posterior_crb", DOTS),
    ("uc_crb", DASH),
    ("classical_crb", DASH_DOT),
    ("crb", DOTS),
    ("crb-distances", DASH),
    ("crb-accelerometers", DOTS),
];

/// Half of the height of a mark.
const RADIUS: f64 = 4.0;

#[derive(Clone, Copy)]
pub struct Look {
    pub colour: Colour,
    pub mark: Option<Mark>,
    pub dash: &'static [f32],
}

#[derive(Clone, Copy)]
pub enum Mark {
    Ring,
    Square,
    Triangle,
    Diamond,
    Disc,
    Cross,
}

impl Look {
    pub fn of(curve: &Curve) -> Self {
        let estimator = ESTIMATORS.iter().find(|(name, ..)| *name == curve.name);
        let colour = estimator.map_or(BOUND, |(_, colour, _)| *colour);
        match curve.kind {
            CurveKind::Estimator => {
                let dash =
                    BROKEN.iter().find(|(name, _)| *name == curve.name).map_or(&[][..], |(_, dash)| *dash);
                Self { colour, mark: estimator.map(|(.., mark)| *mark), dash }
            }
            CurveKind::Covariance => Self { colour, mark: None, dash: DOTS },
            CurveKind::Bound => {
                let dash =
                    DASHES.iter().find(|(name, _)| *name == curve.name).map_or(DASH, |(_, dash)| *dash);
                Self { colour, mark: None, dash }
            }
        }
    }
}

impl Mark {
    pub fn draw(self, group: &mut Group, [x, y]: Place, colour: Colour) {
        let scaled = |corners: &[Place]| -> Vec<Place> {
            corners.iter().map(|[dx, dy]| [x + RADIUS * dx, y + RADIUS * dy]).collect()
        };
        match self {
            Self::Ring => group.line(closed(scaled(&round())), colour, 1.6),
            Self::Cross => {
                group.line(scaled(&[[-0.8, -0.8], [0.8, 0.8]]), colour, 1.6);
                group.line(scaled(&[[-0.8, 0.8], [0.8, -0.8]]), colour, 1.6);
            }
            _ => group.shapes.push(Shape::Area { points: scaled(&self.corners()), colour, opacity: 1.0 }),
        }
    }

    fn corners(self) -> Vec<Place> {
        match self {
            Self::Square => vec![[-0.8, -0.8], [0.8, -0.8], [0.8, 0.8], [-0.8, 0.8]],
            Self::Triangle => vec![[0.0, -1.0], [0.95, 0.75], [-0.95, 0.75]],
            Self::Diamond => vec![[0.0, -1.1], [1.1, 0.0], [0.0, 1.1], [-1.1, 0.0]],
            Self::Disc | Self::Ring | Self::Cross => round(),
        }
    }
}

fn round() -> Vec<Place> {
    let angles = (0..20).map(|i| radians(18.0 * f64::from(i)));
    angles.map(|angle| [cos(angle), sin(angle)]).collect()
}

fn closed(mut points: Vec<Place>) -> Vec<Place> {
    points.extend(points.first().copied());
    points
}
