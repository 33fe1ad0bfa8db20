//! Where in its dash pattern each segment starts, so that dashes run on along a track of many short segments.

use crate::data::SEGMENTS;
use crate::view::View;

/// Whether any segment is dashed, so that phases matter at all.
pub fn any_dashed(segments: &[f32]) -> bool {
    segments.chunks_exact(SEGMENTS.stride()).any(|segment| dash_px(segment) > 0.0)
}

/// Fills `phases` with one number a segment: pixels of the pattern already used where it starts.
///
/// The pattern restarts wherever a segment does not start exactly at the end of the one before it, with equal dashes.
#[expect(clippy::float_cmp, reason = "continuing means the very same numbers")]
pub fn phases(segments: &[f32], view: &View, phases: &mut Vec<f32>) {
    phases.clear();
    let mut before: Option<(&[f32], f32)> = None;
    for segment in segments.chunks_exact(SEGMENTS.stride()) {
        let (start, dash) = (position(segment, 0), dash_px(segment));
        let phase = match before {
            Some((last, reached)) if position(last, 3) == start && dash_px(last) == dash => reached,
            _ => 0.0,
        };
        phases.push(phase);
        let reached = if dash > 0.0 { phase + view.length_px(start, position(segment, 3)) } else { 0.0 };
        before = Some((segment, if dash > 0.0 { reached % (2.0 * dash) } else { 0.0 }));
    }
}

fn position(segment: &[f32], at: usize) -> [f32; 3] {
    [segment[at], segment[at + 1], segment[at + 2]]
}

fn dash_px(segment: &[f32]) -> f32 {
    segment[7]
}
