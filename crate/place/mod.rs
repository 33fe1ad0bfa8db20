//! Floor 3: where anchors should stand. The bound of the ranges as a number to be made small, its slope with the place of
//! each anchor, and a search that follows the slope within limits.
//!
//! | module | holds |
//! |---|---|
//! | [`figure`] | the number of one bound: A-, D- or E-optimality of position, orientation or both |
//! | [`objective`] | that number over all places of the body: [`Placement`] |
//! | [`gradient`] | its derivative with the place of each anchor |
//! | [`zone`] | where anchors may stand |
//! | [`optimise`] | the search within it |
//! | [`next`] | that number with one more anchor, over a plane |
//! | [`mod@best_next`] | the best place of one more anchor |
//! | [`landscape`] | the field of a scenario, whatever it shows |
//! | [`mod@advise`] | the value and slope of a scenario's anchors |
//! | [`mod@improve`] | a scenario with its anchors moved |

pub mod advise;
pub mod best_next;
pub mod figure;
pub mod gradient;
pub mod improve;
pub mod landscape;
pub mod next;
pub mod objective;
pub mod optimise;
mod poses;
pub mod zone;

pub use advise::{Advice, advise};
pub use best_next::{NextPlace, best_next, next_at};
pub use improve::{Improvement, improve};
pub use landscape::field_rows;
pub use next::NextAnchor;
pub use objective::Placement;
pub use zone::Zone;
