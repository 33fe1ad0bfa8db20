//! The bounds at one point: of the body there, or with one more anchor there.

use rangelab::math::float::degrees;
use rangelab::model::field_settings::Subject;
use rangelab::model::scenario::Scenario;
use rangelab::place::{NextPlace, next_at};
use rangelab::study::exploration::{PointBound, bound_at};

/// Coordinates beyond this are none, as in a scenario.
const FARTHEST: f64 = 1e9;

pub enum Found {
    Body(PointBound),
    NextAnchor(NextPlace),
}

pub fn found(scenario: &Scenario, point: &[f64]) -> rangelab::Result<Found> {
    if let Some(value) = point.iter().copied().find(|coordinate| !(coordinate.abs() <= FARTHEST)) {
        let (what, limit) = ("a coordinate of --at", "from -1e9 to 1e9 m");
        return Err(rangelab::Error::Number { what, value, limit });
    }
    Ok(match scenario.field.subject {
        Subject::Body => Found::Body(bound_at(scenario, point)?),
        Subject::NextAnchor => Found::NextAnchor(next_at(scenario, point)?),
    })
}

impl Found {
    pub fn sentence(&self) -> String {
        match self {
            Self::Body(bound) => {
                let [position, orientation] = [
                    bound.position_sigma.map(|sigma| format!("{sigma} m")),
                    bound.angle_sigma.map(|sigma| format!("{} deg", degrees(sigma))),
                ]
                .map(|sigma| sigma.unwrap_or_else(|| "none".to_owned()));
                format!("position bound: {position}\norientation bound: {orientation}\n{}\n", bound.sentence)
            }
            Self::NextAnchor(place) => {
                let [now, with] = [place.before, place.after].map(|value| {
                    value
                        .map_or("none".to_owned(), |value| format!("{} {}", shown(place, value), unit(place)))
                });
                let cause = place.cause.as_ref().map_or_else(String::new, |cause| format!("{cause}\n"));
                format!("bound now: {now}\nbound with one more anchor there: {with}\n{cause}")
            }
        }
    }

    /// Numbers in m and degrees; null where there is no bound.
    pub fn json(&self) -> String {
        let document = match self {
            Self::Body(bound) => serde_json::json!({
                "position_bound_m": bound.position_sigma,
                "orientation_bound_deg": bound.angle_sigma.map(degrees),
                "position_covariance": bound.position_covariance,
                "rotation_covariance_in_world": bound.rotation_covariance_in_world,
                "sentence": bound.sentence,
            }),
            Self::NextAnchor(place) => serde_json::json!({
                "unit": unit(place),
                "bound_now": place.before.map(|value| shown(place, value)),
                "bound_with_one_more_anchor": place.after.map(|value| shown(place, value)),
                "cause": place.cause,
            }),
        };
        document.to_string()
    }
}

fn unit(place: &NextPlace) -> &'static str {
    if place.unit == "rad" { "deg" } else { "m" }
}

fn shown(place: &NextPlace, value: f64) -> f64 {
    if place.unit == "rad" { degrees(value) } else { value }
}
