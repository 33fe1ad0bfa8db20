//! The bounds at one point.

use rangelab::math::float::degrees;
use rangelab::model::scenario::Scenario;
use rangelab::study::exploration::{PointBound, bound_at};

/// Coordinates beyond this are none, as in a scenario.
const FARTHEST: f64 = 1e9;

pub fn bound(scenario: &Scenario, point: &[f64]) -> rangelab::Result<PointBound> {
    if let Some(value) = point.iter().copied().find(|coordinate| !(coordinate.abs() <= FARTHEST)) {
        let (what, limit) = ("a coordinate of --at", "from -1e9 to 1e9 m");
        return Err(rangelab::Error::Number { what, value, limit });
    }
    bound_at(scenario, point)
}

pub fn sentence(bound: &PointBound) -> String {
    let [position, orientation] = [
        bound.position_sigma.map(|sigma| format!("{sigma} m")),
        bound.angle_sigma.map(|sigma| format!("{} deg", degrees(sigma))),
    ]
    .map(|sigma| sigma.unwrap_or_else(|| "none".to_owned()));
    format!("position bound: {position}\norientation bound: {orientation}\n{}\n", bound.sentence)
}

/// Numbers in m and degrees; null where there is no bound.
pub fn json(bound: &PointBound) -> String {
    let document = serde_json::json!({
        "position_bound_m": bound.position_sigma,
        "orientation_bound_deg": bound.angle_sigma.map(degrees),
        "position_covariance": bound.position_covariance,
        "rotation_covariance_in_world": bound.rotation_covariance_in_world,
        "sentence": bound.sentence,
    });
    document.to_string()
}
