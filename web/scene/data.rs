//! The arrays that the scene draws: what each number means, and the check that refuses bad ones.
//!
//! Positions are in world metres, sizes in physical pixels, colours are sRGB with straight
//! (non-premultiplied) alpha, each in 0..1.

use crate::error::SceneError;

/// Most records in one array; 2^20 segments are 54 MB, far beyond what a page can usefully show.
pub const MAX_RECORDS: usize = 1 << 20;

/// Largest width, dash or radius in pixels.
const MAX_SIZE_PX: f32 = 4096.0;

/// One number of a record.
#[derive(Debug)]
pub struct Component {
    /// Its name in messages.
    pub name: &'static str,
    /// Smallest allowed value.
    pub low: f32,
    /// Largest allowed value.
    pub high: f32,
    /// Whether only whole numbers are allowed.
    pub whole: bool,
}

const fn finite(name: &'static str) -> Component {
    Component { name, low: f32::MIN, high: f32::MAX, whole: false }
}

const fn size_px(name: &'static str) -> Component {
    Component { name, low: 0.0, high: MAX_SIZE_PX, whole: false }
}

const fn fraction(name: &'static str) -> Component {
    Component { name, low: 0.0, high: 1.0, whole: false }
}

const fn choice(name: &'static str, high: f32) -> Component {
    Component { name, low: 0.0, high, whole: true }
}

/// An end of a logarithmic scale.
const fn scale(name: &'static str) -> Component {
    Component { name, low: 1e-9, high: 1e9, whole: false }
}

/// Above zero by however little, to infinity.
const fn positive(name: &'static str) -> Component {
    Component { name, low: f32::from_bits(1), high: f32::INFINITY, whole: false }
}

const RED: Component = fraction("red");
const GREEN: Component = fraction("green");
const BLUE: Component = fraction("blue");
const ALPHA: Component = fraction("alpha");

/// The order and the meaning of the numbers of one array.
#[derive(Debug)]
pub struct Layout {
    /// Its name in messages.
    pub name: &'static str,
    /// The numbers of one record, in order.
    pub components: &'static [Component],
    /// How many records make one shape: 3 vertices for a triangle, else 1.
    pub records_per_shape: usize,
}

/// Straight lines of constant width on the screen, 13 numbers each.
///
/// A segment that starts exactly where the one before it ends, with the same width, continues it: the joint is
/// round and painted once, also where translucent, and dashes run on. `dash_px` 0 is a solid line, else dashes
/// and gaps of that length. `overlay` 1 is drawn over everything else.
pub const SEGMENTS: Layout = Layout {
    name: "segments",
    components: &[
        finite("start x"),
        finite("start y"),
        finite("start z"),
        finite("end x"),
        finite("end y"),
        finite("end z"),
        size_px("width_px"),
        size_px("dash_px"),
        RED,
        GREEN,
        BLUE,
        ALPHA,
        choice("overlay", 1.0),
    ],
    records_per_shape: 1,
};

/// Markers that face the viewer, 9 numbers each; `shape` is 0 disc, 1 ring, 2 square, 3 triangle, 4 diamond, 5 cross.
pub const POINTS: Layout = Layout {
    name: "points",
    components: &[
        finite("x"),
        finite("y"),
        finite("z"),
        size_px("radius_px"),
        RED,
        GREEN,
        BLUE,
        ALPHA,
        choice("shape", 5.0),
    ],
    records_per_shape: 1,
};

/// Translucent ellipsoids, 16 numbers each: centre, three semi-axis vectors (one may be zero: a flat ellipse), colour.
pub const ELLIPSOIDS: Layout = Layout {
    name: "ellipsoids",
    components: &[
        finite("centre x"),
        finite("centre y"),
        finite("centre z"),
        finite("axis 1 x"),
        finite("axis 1 y"),
        finite("axis 1 z"),
        finite("axis 2 x"),
        finite("axis 2 y"),
        finite("axis 2 z"),
        finite("axis 3 x"),
        finite("axis 3 y"),
        finite("axis 3 z"),
        RED,
        GREEN,
        BLUE,
        ALPHA,
    ],
    records_per_shape: 1,
};

/// Triangles, 10 numbers a vertex: position, normal (zero: the colour is shown unshaded), colour.
pub const TRIANGLES: Layout = Layout {
    name: "triangles",
    components: &[
        finite("x"),
        finite("y"),
        finite("z"),
        finite("normal x"),
        finite("normal y"),
        finite("normal z"),
        RED,
        GREEN,
        BLUE,
        ALPHA,
    ],
    records_per_shape: 3,
};

/// Numbers of a field, one for each cell of its grid.
pub const FIELD_VALUES: Layout =
    Layout { name: "field values", components: &[positive("number")], records_per_shape: 1 };

/// Where a field is, 9 numbers: its corner and the two edges from there, metres.
pub const FIELD_RECTANGLE: Layout = Layout {
    name: "field rectangle",
    components: &[
        finite("corner x"),
        finite("corner y"),
        finite("corner z"),
        finite("edge u x"),
        finite("edge u y"),
        finite("edge u z"),
        finite("edge v x"),
        finite("edge v y"),
        finite("edge v z"),
    ],
    records_per_shape: 1,
};

/// How a field looks, 11 numbers before its [`FIELD_STOPS`].
///
/// `low` and `high` are the ends of the scale. Numbers above `worse_than` are hatched (0: none are), places without a
/// bound get their own colour, cross-hatched.
pub const FIELD_STYLE: Layout = Layout {
    name: "field style",
    components: &[
        scale("low"),
        scale("high"),
        Component { name: "worse_than", low: 0.0, high: 1e9, whole: false },
        fraction("opacity"),
        fraction("hatch red"),
        fraction("hatch green"),
        fraction("hatch blue"),
        fraction("no-bound red"),
        fraction("no-bound green"),
        fraction("no-bound blue"),
        Component { name: "count of stops", low: 2.0, high: 16.0, whole: true },
    ],
    records_per_shape: 1,
};

/// The colours along the scale of a field.
pub const FIELD_STOPS: Layout =
    Layout { name: "field stops", components: &[RED, GREEN, BLUE], records_per_shape: 1 };

/// What the kernel of a field reads.
pub const FIELD_PARAMETERS: Layout =
    Layout { name: "field parameters", components: &[finite("number")], records_per_shape: 1 };

impl Layout {
    /// Numbers in one record.
    pub const fn stride(&self) -> usize {
        self.components.len()
    }

    /// Numbers in one shape: a record, or the three vertices of a triangle.
    pub const fn shape_stride(&self) -> usize {
        self.stride() * self.records_per_shape
    }

    /// Refuses lengths that make no whole shapes, and arrays too long to draw.
    ///
    /// # Errors
    /// [`SceneError::Length`] or [`SceneError::TooMany`].
    pub fn check_length(&self, length: usize) -> Result<(), SceneError> {
        let (layout, record) = (self.name, self.shape_stride());
        if !length.is_multiple_of(record) {
            return Err(SceneError::Length { layout, length, record });
        }
        let records = length / self.stride();
        if records > MAX_RECORDS {
            return Err(SceneError::TooMany { layout, records, limit: MAX_RECORDS });
        }
        Ok(())
    }

    /// Refuses arrays of the wrong length and numbers that cannot be drawn.
    ///
    /// # Errors
    /// Those of [`Layout::check_length`], or [`SceneError::Value`] for the first bad number.
    pub fn check(&self, values: &[f32]) -> Result<(), SceneError> {
        self.check_length(values.len())?;
        let layout = self.name;
        for (record, numbers) in values.chunks_exact(self.stride()).enumerate() {
            for (component, &value) in self.components.iter().zip(numbers) {
                if !component.allows(value) {
                    let (component, allowed) = (component.name, component.allowed());
                    return Err(SceneError::Value { layout, record, component, value, allowed });
                }
            }
        }
        Ok(())
    }

    /// Appends to `sorted` first the shapes for which `first` holds, then the others, each group in its order;
    /// returns how many shapes are in the first group.
    pub fn split(&self, values: &[f32], sorted: &mut Vec<f32>, first: impl Fn(&[f32]) -> bool) -> usize {
        let shapes = || values.chunks_exact(self.shape_stride());
        let before = sorted.len();
        shapes().filter(|shape| first(shape)).for_each(|shape| sorted.extend_from_slice(shape));
        let count = (sorted.len() - before) / self.shape_stride();
        shapes().filter(|shape| !first(shape)).for_each(|shape| sorted.extend_from_slice(shape));
        count
    }
}

impl Component {
    fn allows(&self, value: f32) -> bool {
        let inside = self.low <= value && value <= self.high;
        inside && (!self.whole || value.fract() == 0.0)
    }

    fn allowed(&self) -> String {
        let kind = if self.whole { "a whole number" } else { "a number" };
        if self.high > f32::MAX {
            "a positive number".into()
        } else if self.low < 0.0 {
            "a finite number".into()
        } else {
            format!("{kind} from {} to {}", self.low, self.high)
        }
    }
}
