//! Runs.

use rangelab::model::document::entries::PoseEntries;
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
use rangelab::model::run::{
    BoundRecord, BoundRun, ConsistencyRecord, CovarianceTrace, EstimatorRun, Failure, Flat, Geometry,
    PointCloud, PoseErrors, Run, StepRecord,
};
use serde_json::json;

fn sample_pose() -> PoseEntries {
    PoseEntries { orientation: vec![vec![0.1, 1e-300], vec![-1.0 / 3.0, 1.0]], position: vec![2.0, 5e300] }
}

fn sample_line() -> Flat {
    Flat { thickness: 0.25, direction: vec![0.6, 0.8] }
}

fn sample_step() -> StepRecord {
    StepRecord {
        time: 0.1,
        prior: sample_pose(),
        innovation: sample_pose(),
        posterior: sample_pose(),
        covariance_trace: CovarianceTrace { orientation: 0.25, position: 1.0 },
        position_covariance: vec![vec![0.5, 0.1], vec![0.1, 0.5]],
        rotation_covariance: Some(vec![vec![0.25]]),
        defect: f64::MIN_POSITIVE,
        event: true,
        nis: ConsistencyRecord { value: 5.5, degrees_of_freedom: 6 },
        errors: Some(PoseErrors { orientation_frobenius: 0.5, angle: 0.25, position: 0.125 }),
        nees: Some(ConsistencyRecord { value: 3.5, degrees_of_freedom: 3 }),
    }
}

fn sample_run() -> Run {
    let bound = BoundRecord {
        orientation_trace: 0.5,
        angle_variance: Some(0.25),
        position_trace: 4.0,
        position_covariance: vec![vec![2.0, 0.0], vec![0.0, 2.0]],
        rotation_covariance: None,
    };
    Run {
        version: 1,
        name: "sample".into(),
        dimension: 2,
        anchors: vec![vec![0.0, 1.0]],
        sensors: vec![vec![0.0, 0.0], vec![0.5, 0.0]],
        geometry: Geometry {
            anchors: PointCloud { plane: None, line: sample_line() },
            sensors: PointCloud { plane: Some(sample_line()), line: sample_line() },
            unseen: Some("One anchor.".into()),
        },
        times: vec![0.1, 0.2],
        missing: vec![vec![(0, 1)], Vec::new()],
        truth: vec![Some(sample_pose()), None],
        settings: EstimatorSettings::default(),
        estimators: vec![EstimatorRun {
            name: EstimatorName::UcKf,
            label: EstimatorName::UcKf.label().into(),
            steps: vec![sample_step(), StepRecord { errors: None, nees: None, ..sample_step() }],
            failure: Some(Failure { step: 2, message: "the end".into() }),
        }],
        bounds: vec![BoundRun {
            name: "crb".into(),
            label: "CRB".into(),
            steps: vec![Some(bound), None],
            failure: None,
        }],
    }
}

#[test]
fn runs_survive_json_to_the_bit() {
    let run = sample_run();
    assert_eq!(Run::from_json(&run.to_json()), Ok(run));
}

#[test]
fn a_run_as_a_table_names_its_units_and_leaves_the_unknown_empty() {
    let table = sample_run().to_csv();
    let lines: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines.len(), 3);
    assert!(lines.iter().all(|cells| cells.len() == lines[0].len()), "{table}");
    let cell = |row: usize, name: &str| {
        let column = lines[0].iter().position(|each| *each == name).unwrap_or_else(|| panic!("{name}"));
        lines[row][column]
    };
    assert_eq!((cell(1, "estimator"), cell(1, "step"), cell(1, "time_s")), ("uc-kf", "0", "0.1"));
    assert_eq!(cell(1, "orientation_12"), "1e-300");
    assert_eq!(cell(1, "orientation_21").parse(), Ok(-1.0_f64 / 3.0));
    assert_eq!((cell(1, "position_2_m"), cell(1, "event")), ("5e300", "1"));
    assert_eq!((cell(1, "orientation_error_rad"), cell(2, "orientation_error_rad")), ("0.25", ""));
    assert_eq!((cell(1, "crb_orientation_rad"), cell(1, "crb_position_m")), ("0.5", "2.0"));
    assert_eq!((cell(2, "crb_position_m"), cell(2, "nees")), ("", ""));
}

#[test]
fn estimators_have_one_name_each() {
    for name in EstimatorName::ALL {
        assert_eq!(json!(name), json!(name.name()));
        assert_eq!(name.name().parse(), Ok(name));
    }
}
