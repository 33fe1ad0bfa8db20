//! A drawing as SVG: text stays text, and each curve says what it is.

use std::fmt::Write;

use super::drawing::{Drawing, Group, Place, Shape, Side};
use crate::cli::picture::canvas::Colour;

/// Sizes of letters, pixels.
const FONT: usize = 14;
const STRONG: usize = 15;
/// From the middle of the letters down to the line on which they stand.
const BASELINE: f64 = 5.0;
const FAMILY: &str = "system-ui, 'Segoe UI', Roboto, 'Noto Sans', 'DejaVu Sans', sans-serif";

/// The picture, with a title, a description and data that are not seen.
pub fn svg(drawing: &Drawing, title: &str, description: &str, metadata: &str) -> String {
    let Drawing { width, height, groups } = drawing;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\" font-family=\"{FAMILY}\" font-size=\"{FONT}\">\n"
    );
    for (name, content) in [("title", title), ("desc", description), ("metadata", metadata)] {
        let _ = writeln!(text, "<{name}>{}</{name}>", escaped(content));
    }
    let _ = writeln!(text, "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>");
    for each in groups {
        group(&mut text, each);
    }
    text + "</svg>\n"
}

fn group(text: &mut String, group: &Group) {
    text.push_str("<g>");
    if !group.title.is_empty() {
        let _ = write!(text, "<title>{}</title>", escaped(&group.title));
    }
    text.push('\n');
    group.shapes.iter().for_each(|each| shape(text, each));
    text.push_str("</g>\n");
}

fn shape(to: &mut String, shape: &Shape) {
    let _ = match shape {
        Shape::Line { points, colour, width, dash } => {
            let dash: Vec<String> = dash.iter().map(f32::to_string).collect();
            let dash = if dash.is_empty() {
                String::new()
            } else {
                format!(" stroke-dasharray=\"{}\"", dash.join(" "))
            };
            writeln!(
                to,
                "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\"{dash}/>",
                places(points),
                hex(*colour)
            )
        }
        Shape::Area { points, colour, opacity } => {
            let opacity = if *opacity < 1.0 { format!(" fill-opacity=\"{opacity}\"") } else { String::new() };
            writeln!(to, "<polygon points=\"{}\" fill=\"{}\"{opacity}/>", places(points), hex(*colour))
        }
        Shape::Text { at: [x, y], text, colour, side, strong } => {
            let anchor = match side {
                Side::Start => "",
                Side::Middle => " text-anchor=\"middle\"",
                Side::End => " text-anchor=\"end\"",
            };
            let strong =
                if *strong { format!(" font-size=\"{STRONG}\" font-weight=\"600\"") } else { String::new() };
            let (x, y) = (rounded(*x), rounded(y + BASELINE));
            writeln!(
                to,
                "<text x=\"{x}\" y=\"{y}\" fill=\"{}\"{anchor}{strong}>{}</text>",
                hex(*colour),
                escaped(text)
            )
        }
    };
}

fn places(points: &[Place]) -> String {
    let place = |[x, y]: &Place| format!("{},{}", rounded(*x), rounded(*y));
    points.iter().map(place).collect::<Vec<_>>().join(" ")
}

/// Hundredths of a pixel.
fn rounded(value: f64) -> f64 {
    (100.0 * value).round() / 100.0
}

fn hex([red, green, blue]: Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
