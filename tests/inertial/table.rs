//! The figures of the corrected paper at 20 dB (sigma = 0.1 m): position error in m, orientation error in degrees.
#![allow(clippy::approx_constant, reason = "0.318 m is an error, not a part of pi")]

use rangelab::model::imu::Convention;
use rangelab::model::indoor::filter_settings::{FilterName, FilterSettings, Retraction, Transport};
use rangelab::model::indoor::presets::indoor_preset;
use rangelab::study::indoor::monte_carlo::IndoorMonteCarlo;
use rangelab::study::indoor::report::IndoorSummary;

const PATHS: [&str; 4] = ["indoor-u", "indoor-zigzag", "indoor-bridge", "indoor-stair"];

/// What may differ beside sampling: the paths of the specification are known to two or three digits.
const WITHIN: f64 = 0.03;

/// One row: inputs, filter, retraction, and for each path position and, where it was printed, orientation.
struct Row {
    convention: Convention,
    filter: FilterName,
    retraction: Retraction,
    position: [f64; 4],
    degrees: Option<[f64; 4]>,
}

const fn row(convention: Convention, filter: FilterName, position: [f64; 4], degrees: [f64; 4]) -> Row {
    Row { convention, filter, retraction: Retraction::Qr, position, degrees: Some(degrees) }
}

use Convention::{Disc, Mean, Sample};
use FilterName::{Ekf, EkfRetraction, EkfRie, Mekf, Tight, Ukf, UkfRie};

#[rustfmt::skip]
const ROWS: [Row; 16] = [
    row(Sample, Ekf, [0.390, 0.745, 0.162, 0.509], [2.48, 4.41, 2.07, 1.20]),
    row(Sample, EkfRetraction, [0.354, 0.721, 0.166, 0.105], [2.48, 4.41, 2.07, 1.25]),
    row(Sample, EkfRie, [0.354, 0.721, 0.166, 0.105], [2.48, 4.41, 2.07, 1.25]),
    row(Sample, Ukf, [0.389, 0.739, 0.162, 0.499], [2.48, 4.41, 2.07, 1.20]),
    row(Sample, UkfRie, [0.354, 0.715, 0.165, 0.105], [2.48, 4.42, 2.08, 1.24]),
    Row { retraction: Retraction::Exponential, ..row(Sample, EkfRie, [0.318, 0.712, 0.166, 0.104], [1.96, 4.15, 2.08, 1.15]) },
    row(Sample, Mekf, [0.060, 0.068, 0.070, 0.056], [1.96, 4.15, 2.08, 1.15]),
    row(Sample, Tight, [0.058, 0.067, 0.068, 0.055], [1.96, 4.15, 2.08, 1.15]),
    row(Disc, Ekf, [0.471, 0.190, 0.054, 0.513], [1.01, 1.17, 0.10, 0.35]),
    row(Disc, EkfRie, [0.054, 0.016, 0.011, 0.055], [1.01, 1.17, 0.10, 0.46]),
    Row { retraction: Retraction::Exponential, ..row(Disc, EkfRie, [0.027, 0.011, 0.011, 0.054], [0.03, 0.02, 0.02, 0.08]) },
    Row { degrees: None, ..row(Disc, Mekf, [0.309, 0.745, 0.192, 0.099], [0.0; 4]) },
    row(Mean, Ekf, [0.408, 0.783, 0.191, 0.508], [1.01, 1.17, 0.10, 0.34]),
    row(Mean, EkfRie, [0.350, 0.763, 0.193, 0.099], [1.01, 1.17, 0.10, 0.46]),
    row(Mean, Mekf, [0.027, 0.013, 0.011, 0.054], [0.03, 0.02, 0.02, 0.08]),
    row(Mean, Tight, [0.026, 0.012, 0.011, 0.052], [0.03, 0.02, 0.02, 0.07]),
];

/// The figures of all rows with the same inputs, retraction and path.
fn measure(
    convention: Convention,
    retraction: Retraction,
    path: &str,
    trials: usize,
) -> Vec<(FilterName, IndoorSummary)> {
    let mut scenario = indoor_preset(path).unwrap();
    scenario.imu.convention = convention;
    let wanted = |filter: &FilterName| {
        ROWS.iter()
            .any(|row| (row.convention, row.retraction, row.filter) == (convention, retraction, *filter))
    };
    scenario.filters = FilterSettings {
        enabled: FilterName::ALL.into_iter().filter(wanted).collect(),
        retraction,
        transport: Transport::Congruence,
        ..scenario.filters
    };
    let report = IndoorMonteCarlo::new(&scenario, trials).unwrap().run().unwrap();
    report.filters.into_iter().map(|filter| (filter.name, filter.summary)).collect()
}

/// How far a figure is outside of what is allowed: the printed figure's last digit, the paths, and sampling.
fn excess(found: f64, error: f64, printed: f64, digit: f64, errors: f64) -> f64 {
    (found - printed).abs() - (0.5 * digit + WITHIN * printed + errors * error)
}

/// Compares the table; `errors` standard errors are allowed beside.
fn compare(trials: [usize; 4], errors: f64) {
    let mut outside = Vec::new();
    for convention in [Sample, Disc, Mean] {
        for retraction in [Retraction::Qr, Retraction::Exponential] {
            for (path, name) in PATHS.iter().enumerate() {
                let measured = measure(convention, retraction, name, trials[path]);
                for row in
                    ROWS.iter().filter(|row| (row.convention, row.retraction) == (convention, retraction))
                {
                    let (_, summary) = measured.iter().find(|(filter, _)| *filter == row.filter).unwrap();
                    assert_eq!(summary.failures, 0);
                    let (position, angle) = (summary.position, summary.angle);
                    let degrees = [angle.value, angle.standard_error].map(f64::to_degrees);
                    let printed = row.degrees.map(|degrees| degrees[path]);
                    let line = format!(
                        "{convention:?} {retraction:?} {name} {}: {:.4} +- {:.4} m ({}), {:.3} +- {:.3} deg ({printed:?})",
                        row.filter,
                        position.value,
                        position.standard_error,
                        row.position[path],
                        degrees[0],
                        degrees[1]
                    );
                    println!("{line}");
                    let off =
                        excess(position.value, position.standard_error, row.position[path], 0.001, errors);
                    let turned =
                        printed.map_or(-1.0, |printed| excess(degrees[0], degrees[1], printed, 0.01, errors));
                    if off > 0.0 || turned > 0.0 {
                        outside.push(line);
                    }
                }
            }
        }
    }
    assert!(outside.is_empty(), "outside of 3 %:\n{}", outside.join("\n"));
}

#[test]
fn a_few_trials_are_within_sampling_of_the_table() {
    compare([12, 12, 12, 2], 4.0);
}

#[test]
#[ignore = "minutes: 600 trials, 150 on the stairs"]
fn the_table_holds_within_three_per_cent() {
    // The printed figures were drawn too.
    compare([600, 600, 600, 150], 2.0);
}

/// The comparison sees a tenth.
#[test]
fn a_figure_off_by_a_tenth_is_outside() {
    assert!(excess(0.390 * 1.1, 0.0015, 0.390, 0.001, 4.0) > 0.0);
    assert!(excess(0.390, 0.0015, 0.390, 0.001, 0.0) < 0.0);
}
