//! The field: a rectangle in space that shows a grid of positive numbers by colours on a logarithmic scale.

use crate::data::{FIELD_RECTANGLE, FIELD_STOPS, FIELD_STYLE, FIELD_VALUES, Layout};
use crate::error::SceneError;

/// Numbers of this size and larger mean that no bound exists there.
pub const UNBOUNDED: f32 = 1e30;

/// A grid of numbers over a rectangle, and the colours that show them. No column or no row: no field.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FieldData {
    /// Row by row, [`FIELD_VALUES`]: `values[j * width + i]` belongs to the centre of cell (i, j), which is at
    /// `corner + (i + 0.5) / width * u + (j + 0.5) / height * v`. [`UNBOUNDED`] and more: no bound exists there.
    pub values: Vec<f32>,
    /// Number of columns.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
    /// See [`FIELD_RECTANGLE`].
    pub rectangle: Vec<f32>,
    /// [`FIELD_STYLE`], then as many [`FIELD_STOPS`] as it says. The colour of a number is interpolated linearly between
    /// the stops at `log(value / low) / log(high / low)`, clamped to 0..1.
    pub style: Vec<f32>,
}

impl FieldData {
    /// Whether nothing is to be drawn.
    pub fn is_empty(&self) -> bool {
        self.width == 0 || self.height == 0
    }

    /// Refuses arrays of the wrong length and numbers that cannot be drawn; an empty field passes.
    ///
    /// # Errors
    /// [`SceneError::Count`], [`SceneError::TooMany`] or [`SceneError::Value`].
    pub fn check(&self) -> Result<(), SceneError> {
        if self.is_empty() {
            return Ok(());
        }
        let cells = (self.width as usize).saturating_mul(self.height as usize);
        check_count(&FIELD_VALUES, self.values.len(), cells)?;
        FIELD_VALUES.check(&self.values)?;
        check_count(&FIELD_RECTANGLE, self.rectangle.len(), FIELD_RECTANGLE.stride())?;
        FIELD_RECTANGLE.check(&self.rectangle)?;
        check_style(&self.style)
    }

    /// The numbers that the shader reads of a field that passed the check, in vectors of four: corner, two edges,
    /// scale and opacity, hatching with the count of stops, colour without a bound, stops.
    pub fn uniform(&self) -> [f32; 88] {
        let (style, stops) = self.style.split_at(FIELD_STYLE.stride());
        let edges = self.rectangle.chunks_exact(3);
        let colours = [&style[4..7], &style[7..10]].into_iter().chain(stops.chunks_exact(3));
        let mut uniform = [0.0; 88];
        let (vectors, _) = uniform.as_chunks_mut::<4>();
        for (vector, numbers) in vectors[..3].iter_mut().zip(edges) {
            vector[..3].copy_from_slice(numbers);
        }
        vectors[3].copy_from_slice(&style[..4]);
        for (vector, colour) in vectors[4..].iter_mut().zip(colours) {
            vector[..3].copy_from_slice(colour);
        }
        vectors[4][3] = style[10];
        uniform
    }
}

fn check_count(layout: &Layout, length: usize, expected: usize) -> Result<(), SceneError> {
    if length == expected {
        return Ok(());
    }
    Err(SceneError::Count { layout: layout.name, length, expected })
}

fn check_style(style: &[f32]) -> Result<(), SceneError> {
    let (layout, fixed) = (FIELD_STYLE.name, FIELD_STYLE.stride());
    let length_with = |stops: usize| fixed + stops * FIELD_STOPS.stride();
    let Some((first, stops)) = style.split_at_checked(fixed) else {
        return Err(SceneError::Count { layout, length: style.len(), expected: length_with(2) });
    };
    FIELD_STYLE.check(first)?;
    let (low, high) = (first[0], first[1]);
    if low >= high {
        let (component, allowed) = (FIELD_STYLE.components[1].name, format!("a number above low = {low}"));
        return Err(SceneError::Value { layout, record: 0, component, value: high, allowed });
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the check above let only whole numbers from 2 to 16 pass"
    )]
    check_count(&FIELD_STYLE, style.len(), length_with(first[10] as usize))?;
    FIELD_STOPS.check(stops)
}
