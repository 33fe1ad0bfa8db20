//! A drawing as pixels: lines and areas by tiny-skia, letters as in the other pictures.

use tiny_skia::{
    FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};

use super::drawing::{Drawing, Place, Shape, Side};
use super::looks::PAPER;
use crate::cli::picture::canvas::{Canvas, Colour, LINE, text_width};

/// The drawing; none where it has no pixels.
pub fn pixels(drawing: &Drawing) -> Option<Canvas> {
    let side = |pixels: usize| u32::try_from(pixels).ok();
    let mut pixmap = Pixmap::new(side(drawing.width)?, side(drawing.height)?)?;
    let [red, green, blue] = PAPER;
    pixmap.fill(tiny_skia::Color::from_rgba8(red, green, blue, 255));
    let shapes = || drawing.groups.iter().flat_map(|group| &group.shapes);
    shapes().for_each(|shape| paint(&mut pixmap, shape));
    let mut canvas = Canvas::new(drawing.width, drawing.height, PAPER);
    for (i, pixel) in pixmap.pixels().iter().enumerate() {
        canvas.set(i % drawing.width, i / drawing.width, [pixel.red(), pixel.green(), pixel.blue()]);
    }
    shapes().for_each(|shape| letters(&mut canvas, shape));
    Some(canvas)
}

fn paint(pixmap: &mut Pixmap, shape: &Shape) {
    match shape {
        Shape::Line { points, colour, width, dash } => {
            let Some(path) = path(points, false) else { return };
            let stroke = Stroke {
                width: single(*width),
                line_cap: LineCap::Butt,
                line_join: LineJoin::Round,
                dash: StrokeDash::new(dash.to_vec(), 0.0),
                ..Stroke::default()
            };
            pixmap.stroke_path(&path, &filled(*colour, 1.0), &stroke, Transform::identity(), None);
        }
        Shape::Area { points, colour, opacity } => {
            let Some(path) = path(points, true) else { return };
            let paint = filled(*colour, *opacity);
            pixmap.fill_path(&path, &paint, FillRule::Winding, Transform::identity(), None);
        }
        Shape::Text { .. } => (),
    }
}

/// Beside thin lines: a letter's place is rounded to a pixel.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "inside of the picture")]
fn letters(canvas: &mut Canvas, shape: &Shape) {
    let Shape::Text { at: [x, y], text, colour, side, strong } = shape else { return };
    let width = text_width(text);
    let before = match side {
        Side::Start => 0,
        Side::Middle => width / 2,
        Side::End => width,
    };
    let (left, top) =
        ((x.round() as usize).saturating_sub(before), (y.round() as usize).saturating_sub(LINE / 2));
    canvas.text([left, top], text, *colour);
    if *strong {
        canvas.text([left + 1, top], text, *colour);
    }
}

fn path(points: &[Place], close: bool) -> Option<Path> {
    let (first, rest) = points.split_first()?;
    let mut builder = PathBuilder::new();
    builder.move_to(single(first[0]), single(first[1]));
    for [x, y] in rest {
        builder.line_to(single(*x), single(*y));
    }
    if close {
        builder.close();
    }
    builder.finish()
}

fn filled(colour: Colour, opacity: f64) -> Paint<'static> {
    let mut paint = Paint::default();
    let [red, green, blue] = colour.map(|part| f32::from(part) / 255.0);
    if let Some(colour) = tiny_skia::Color::from_rgba(red, green, blue, single(opacity.clamp(0.0, 1.0))) {
        paint.set_color(colour);
    }
    paint.anti_alias = true;
    paint
}

#[allow(clippy::cast_possible_truncation, reason = "a place in a picture")]
fn single(value: f64) -> f32 {
    value as f32
}
