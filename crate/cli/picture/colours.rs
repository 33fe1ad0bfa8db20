//! Colours of all pictures, those of the page's light theme.

use super::canvas::Colour;

pub const INK: Colour = [0x16, 0x19, 0x1f];
pub const PAPER: Colour = [0xff, 0xff, 0xff];
