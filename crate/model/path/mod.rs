//! Path: the track that a body would follow if nothing disturbed it, as a document.

mod curve;
mod rules;
mod travel;

use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

pub use curve::Curve;
pub(in crate::model) use rules::check;
pub use travel::Path;

/// A path through the world. At time 0 the body is at the scenario's `start.position`, and its x axis, seen from above,
/// points along the path at all times: as the path turns, the body turns with it about the vertical, its tilt kept.
///
/// Turn, figure eight and helix are level (a helix climbs) and set out in the direction in which the start looks. A drawn
/// path has a direction of its own: the body looks along it from the start, whatever the heading of `start.orientation`.
///
/// ```
/// use rangelab::model::path::{PathSettings, Side};
/// let text = r#"{"kind": "turn", "radius": 2, "period": 10}"#;
/// let turn = PathSettings::Turn { radius: 2.0, period: 10.0, side: Side::Left };
/// assert_eq!(serde_json::from_str::<PathSettings>(text).unwrap(), turn);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum PathSettings {
    /// A circle at constant speed `2 pi radius / period`.
    Turn {
        /// Radius, m.
        radius: f64,
        /// Time of one round, s.
        period: f64,
        /// To which side it turns.
        #[serde(default)]
        side: Side,
    },
    /// A circle to the left, then one to the right; they touch at the start. Constant speed `4 pi radius / period`.
    FigureEight {
        /// Radius of each circle, m.
        radius: f64,
        /// Time of both circles, s.
        period: f64,
    },
    /// A turn that climbs steadily; in space only.
    Helix {
        /// Radius seen from above, m.
        radius: f64,
        /// Time of one turn, s.
        period: f64,
        /// Height gained in one turn, m; negative goes down.
        climb: f64,
        /// To which side it turns.
        #[serde(default)]
        side: Side,
    },
    /// A smooth curve from the start through the points in order, at even speed: a centripetal Catmull-Rom curve.
    Drawn {
        /// Points in the world frame, m; the start comes before the first of them.
        points: Vec<Vec<f64>>,
        /// True: it goes on from the last point to the start, and round again. False: the body stands still at the end.
        closed: bool,
        /// Time from the start to the end, or once round, s.
        period: f64,
    },
}

/// A side of the body, seen from above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum Side {
    /// Counter-clockwise.
    #[default]
    Left,
    /// Clockwise.
    Right,
}
