//! Follows a body through a room, epoch by epoch: `cargo run --release --example track_a_body`.

use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
use rangelab::model::presets::preset;
use rangelab::simulate::simulate;
use rangelab::track::estimator;

fn main() -> rangelab::Result<()> {
    // Ranges from five sensors on the body to six anchors on the walls, ten times a second, each good to 1 cm.
    // Ranges of your own come from a file: `RecordingDocument::from_json(text)?.recording::<3>()?`.
    let recording = simulate::<3>(&preset("room")?, 0)?;
    let mut filter = estimator(EstimatorName::UcKf, &EstimatorSettings::default(), &recording);
    for (k, epoch) in recording.epochs.iter().enumerate() {
        let step = filter.step(epoch)?; // sees the ranges and the known motion, never the truth
        let (position, claimed) = (step.posterior.position, step.uncertainty.position_block().trace().sqrt());
        if let Some(truth) = &recording.truth[k] {
            let error = 1000.0 * (position - truth.position).norm();
            let angle = step.rotation().inverse().compose(&truth.rotation).angle().to_degrees();
            println!(
                "{k:2}: off by {error:4.1} mm (claimed: {:4.1}) and {angle:4.2} degrees",
                1000.0 * claimed
            );
        }
    }
    Ok(())
}
