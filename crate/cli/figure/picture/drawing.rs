//! A picture as plain shapes, which are written as SVG or as pixels.

use crate::cli::picture::canvas::Colour;

/// Pixels from the upper left corner.
pub type Place = [f64; 2];

pub struct Drawing {
    pub width: usize,
    pub height: usize,
    pub groups: Vec<Group>,
}

/// Shapes that belong together.
pub struct Group {
    /// What they are, for who asks; empty where that is plain.
    pub title: String,
    pub shapes: Vec<Shape>,
}

pub enum Shape {
    /// Solid where `dash` is empty; else drawn and left out in turns, pixels.
    Line {
        points: Vec<Place>,
        colour: Colour,
        width: f64,
        dash: &'static [f32],
    },
    /// Filled, from 0, nothing, to 1.
    Area {
        points: Vec<Place>,
        colour: Colour,
        opacity: f64,
    },
    Text {
        at: Place,
        text: String,
        colour: Colour,
        side: Side,
        strong: bool,
    },
}

/// Which part of a text is at its place; that is at the middle of the height of its letters.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Side {
    Start,
    Middle,
    End,
}

impl Group {
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), shapes: Vec::new() }
    }

    pub fn line(&mut self, points: Vec<Place>, colour: Colour, width: f64) {
        self.shapes.push(Shape::Line { points, colour, width, dash: &[] });
    }

    pub fn text(&mut self, at: Place, text: impl Into<String>, colour: Colour, side: Side) {
        self.shapes.push(Shape::Text { at, text: text.into(), colour, side, strong: false });
    }
}
