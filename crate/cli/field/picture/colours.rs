//! The colours of a field, those of the page's light theme.

use crate::cli::picture::canvas::{Colour, mixed};
pub use crate::cli::picture::colours::{INK, PAPER};

/// Viridis (S. van der Walt and N. Smith, 2015, CC0) at sixteen even places.
const STOPS: [Colour; 16] = [
    [0x44, 0x01, 0x54],
    [0x48, 0x1a, 0x6c],
    [0x47, 0x2f, 0x7d],
    [0x41, 0x44, 0x87],
    [0x39, 0x56, 0x8c],
    [0x31, 0x68, 0x8e],
    [0x2a, 0x78, 0x8e],
    [0x23, 0x88, 0x8e],
    [0x1f, 0x98, 0x8b],
    [0x22, 0xa8, 0x84],
    [0x35, 0xb7, 0x79],
    [0x54, 0xc5, 0x68],
    [0x7a, 0xd1, 0x51],
    [0xa5, 0xdb, 0x36],
    [0xd2, 0xe2, 0x1b],
    [0xfd, 0xe7, 0x25],
];
pub const NO_BOUND: Colour = [0xc9, 0xce, 0xd6];

/// Pixels from one line of a hatch to the next.
const HATCH: usize = 8;

/// The colour at a place of the scale, linear between the stops.
pub fn colour_at(place: f64) -> Colour {
    let last = STOPS.len() - 1;
    let along = place.clamp(0.0, 1.0) * last as f64;
    let stop = crate::cli::picture::canvas::cell(place, last);
    mixed(STOPS[stop], STOPS[stop + 1], along - stop as f64)
}

/// What is seen on the colour of a place.
pub fn ink_on(place: f64) -> Colour {
    if place < 0.5 { PAPER } else { INK }
}

/// Whether a pixel is on a line of the hatch of what is worse than the limit.
pub fn hatched(x: usize, y: usize) -> bool {
    (x + y).is_multiple_of(HATCH)
}

/// The same for what has no bound: lines both ways, so that grey is not the only sign.
pub fn cross_hatched(x: usize, y: usize) -> bool {
    hatched(x, y) || (x + HATCH * y - y).is_multiple_of(HATCH)
}
