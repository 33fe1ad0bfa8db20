//! A field as text: a row for each cell, or rows of numbers as JSON.

use std::fmt::Write;

use super::grid::Grid;

/// Comments with title, units, rectangle and scenario; then a row for each cell, its value empty without a bound.
pub fn csv(grid: &Grid) -> String {
    let layout = &grid.layout;
    let mut text = format!("# {}\n# {}\n", grid.title(), grid.subtitle());
    let _ = writeln!(
        text,
        "# x, y, z: the middle of a cell, m; the bound: {}, empty where none exists",
        grid.unit()
    );
    let _ = writeln!(
        text,
        "# rectangle, m: corner {:?}, edge along a row {:?}, edge from row to row {:?}; {} x {} cells",
        layout.corner, layout.u, layout.v, layout.width, layout.height
    );
    let _ = writeln!(text, "# scenario: {}", grid.scenario.to_json().trim_end());
    let _ = writeln!(text, "x_m,y_m,z_m,{}", grid.column());
    for (i, value) in grid.values.iter().enumerate() {
        let [x, y, z] = layout.centre(i % layout.width, i / layout.width);
        let value = value.map_or_else(String::new, |value| value.to_string());
        let _ = writeln!(text, "{x},{y},{z},{value}");
    }
    text
}

/// The same as JSON; a row of `values` is a row of the grid.
pub fn json(grid: &Grid) -> String {
    let scenario: serde_json::Value =
        serde_json::from_str(&grid.scenario.to_json()).unwrap_or(serde_json::Value::Null);
    let rows: Vec<&[Option<f64>]> = grid.values.chunks(grid.layout.width).collect();
    let document = serde_json::json!({
        "title": grid.title(),
        "subtitle": grid.subtitle(),
        "quantity": grid.quantity(),
        "one_more_anchor": grid.of_next_anchor(),
        "unit": grid.unit(),
        "limit": grid.limit,
        "best_next_anchor": grid.best.as_ref().map(|best| &best.point),
        "layout": grid.layout,
        "values": rows,
        "scenario": scenario,
    });
    document.to_string()
}
