//! What can go wrong, said so that the page can show it as it is.

use std::fmt;

/// Why data, a view or a device was refused.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum SceneError {
    /// The number of values does not make whole records.
    Length {
        /// Which array.
        layout: &'static str,
        /// How many numbers came.
        length: usize,
        /// How many numbers one record has.
        record: usize,
    },
    /// An array has more or fewer numbers than belong into it.
    Count {
        /// Which array.
        layout: &'static str,
        /// How many numbers came.
        length: usize,
        /// How many it must have.
        expected: usize,
    },
    /// More records than one array may have.
    TooMany {
        /// Which array.
        layout: &'static str,
        /// How many records came.
        records: usize,
        /// How many are allowed.
        limit: usize,
    },
    /// A number is NaN, infinite or outside its allowed interval.
    Value {
        /// Which array.
        layout: &'static str,
        /// Index of the record (of the vertex, for triangles), from 0.
        record: usize,
        /// Which number of the record.
        component: &'static str,
        /// The number.
        value: f32,
        /// What it may be, in words.
        allowed: String,
    },
    /// The view cannot be drawn with: wrong length, not finite, singular or of no size.
    View(String),
    /// The size of the picture is beyond what the device can draw.
    Size {
        /// Width asked for, pixels.
        width_px: u32,
        /// Height asked for, pixels.
        height_px: u32,
        /// Largest width or height of the device, pixels.
        limit_px: u32,
    },
    /// A grid has more columns or rows than the device can hold, or none.
    Grid {
        /// Number of columns asked for.
        width: u32,
        /// Number of rows asked for.
        height: u32,
        /// Most columns or rows of the device.
        limit: u32,
    },
    /// The device refused the kernel of the field, with its own words.
    Kernel(String),
    /// The fine grid of the field can be neither computed nor read.
    FineField(&'static str),
    /// No usable graphics adapter or device.
    Device(String),
    /// The graphics device was lost; the scene has to be created again.
    Lost,
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { layout, length, record } => {
                write!(f, "{layout}: {length} numbers do not make whole records of {record}")
            }
            Self::Count { layout, length, expected } => {
                write!(f, "{layout}: {length} numbers came, but there must be {expected}")
            }
            Self::TooMany { layout, records, limit } => {
                write!(f, "{layout}: {records} records, but at most {limit} can be drawn")
            }
            Self::Value { layout, record, component, value, allowed } => {
                write!(f, "{layout}: record {record} has {component} = {value}, but it must be {allowed}")
            }
            Self::View(reason) => write!(f, "view: {reason}"),
            Self::Size { width_px, height_px, limit_px } => write!(
                f,
                "a picture of {width_px} x {height_px} pixels is too large: this device draws at most \
                 {limit_px} pixels each way"
            ),
            Self::Grid { width, height, limit } => write!(
                f,
                "a grid of {width} x {height} cells is impossible: this device holds 1 to {limit} cells each way"
            ),
            Self::Kernel(reason) => write!(f, "the kernel of the field was refused: {reason}"),
            Self::FineField(reason) => write!(f, "no fine field: {reason}"),
            Self::Device(reason) => write!(f, "no graphics device: {reason}"),
            Self::Lost => write!(f, "the graphics device was lost"),
        }
    }
}

impl std::error::Error for SceneError {}
