//! The rules of a recording.

use alloc::format;
use alloc::vec::Vec;

use super::{EpochDocument, RecordingDocument};
use crate::error::Problem;
use crate::math::rotation::rotation_angles;
use crate::model::document::check::{Check, Limit, MAX_STEPS, Readable};
use crate::model::scenario::WeightSource;
use crate::model::scenario::validate::{initial, process};

pub fn problems(recording: &RecordingDocument) -> Vec<Problem> {
    let mut check = Check::default();
    check.version(recording.version);
    check.name(&recording.name);
    let dimension = check.dimension(recording.dimension);
    check.points("anchors", &recording.anchors, dimension);
    check.points("sensors", &recording.sensors, dimension);
    check.noise(&recording.noise);
    initial(&mut check, &recording.initial, dimension);
    process(&mut check, &recording.process);
    let epochs = recording.epochs.len();
    check.count("epochs", epochs, 1, MAX_STEPS);
    check.total_ranges("epochs", recording.anchors.len(), recording.sensors.len(), epochs);
    for (k, epoch) in recording.epochs.iter().enumerate() {
        let path = format!("epochs[{k}]");
        motion(&mut check, &path, epoch, dimension);
        ranges(&mut check, &path, epoch, recording);
        match &epoch.truth {
            Some(truth) => check.pose(format_args!("{path}.truth"), truth, dimension),
            None if recording.weights == WeightSource::True => {
                check.problem(format_args!("{path}.truth"), "missing", "a pose, since weights are \"true\"");
            }
            None => {}
        }
    }
    check.into_problems()
}

fn motion(check: &mut Check, path: &str, epoch: &EpochDocument, dimension: Option<usize>) {
    let angles = dimension.map(rotation_angles);
    check.number(format_args!("{path}.interval"), epoch.interval, Limit::INTERVAL);
    check.vector(format_args!("{path}.velocity"), &epoch.velocity, dimension, Limit::VELOCITY);
    let angular = format!("{path}.angular_velocity");
    check.vector(angular, &epoch.angular_velocity, angles, Limit::ANGULAR_VELOCITY);
}

fn ranges(check: &mut Check, path: &str, epoch: &EpochDocument, recording: &RecordingDocument) {
    let size = (recording.anchors.len(), recording.sensors.len());
    match (&epoch.squared_ranges, &epoch.ranges) {
        (Some(rows), None) => {
            table(check, &format!("{path}.squared_ranges"), rows, size, Limit::SQUARED_RANGE);
        }
        (None, Some(rows)) => table(check, &format!("{path}.ranges"), rows, size, Limit::RANGE),
        (None, None) => check.problem(path, "without ranges", "squared_ranges or ranges"),
        (Some(_), Some(_)) => {
            check.problem(path, "with both squared_ranges and ranges", "one of the two");
        }
    }
}

fn table(
    check: &mut Check,
    path: &str,
    rows: &[Vec<Option<f64>>],
    (anchors, sensors): (usize, usize),
    limit: Limit,
) {
    if rows.len() != anchors {
        check.problem(
            path,
            format_args!("{} rows", rows.len()),
            format_args!("{anchors} rows, one an anchor"),
        );
    }
    for (m, row) in rows.iter().enumerate() {
        if row.len() != sensors {
            check.problem(
                format_args!("{path}[{m}]"),
                format_args!("{} long", row.len()),
                format_args!("{sensors} entries, one a sensor"),
            );
        }
        for (n, entry) in row.iter().enumerate() {
            if let Some(value) = *entry
                && !limit.allows(value)
            {
                check.problem(
                    format_args!("{path}[{m}][{n}]"),
                    Readable(value),
                    format_args!("{limit}, or null if missing"),
                );
            }
        }
    }
}
