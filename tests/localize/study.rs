//! Studies of snapshot estimators: blocks, documents, clouds.

use rangelab::math::rotation::Manifold;
use rangelab::model::localize_settings::LocalizerName as Name;
use rangelab::model::noise::RangeNoise;
use rangelab::model::presets::preset;
use rangelab::model::scenario::Scenario;
use rangelab::study::localization::run::{cloud_stride, localization_cloud, localize_trial};
use rangelab::study::localization::{LocalizationBlock, LocalizationStudy, TRIALS_PER_BLOCK, paper_sweep};

fn sweep() -> Vec<RangeNoise> {
    [20.0, 60.0].map(|zeta_db| RangeNoise::Toa { zeta_db }).to_vec()
}

#[test]
fn any_split_gives_the_same_bits() {
    let scenario = preset("localization-paper-redrawn").unwrap();
    let trials = 2 * TRIALS_PER_BLOCK + 3;
    let study = LocalizationStudy::new(&scenario, sweep(), trials).unwrap();
    assert_eq!(study.blocks(), 3);
    let blocks: Vec<LocalizationBlock> = (0..3).rev().map(|index| study.block(index).unwrap()).collect();
    let mut sum = study.start();
    for block in blocks.iter().rev() {
        let numbers = block.to_numbers();
        assert_eq!(numbers.len(), LocalizationBlock::length(&scenario, 2));
        sum.merge(&LocalizationBlock::from_numbers(&scenario, 2, &numbers).unwrap()).unwrap();
    }
    assert_eq!(study.report(&sum), study.run().unwrap());
    assert_eq!(sum.trials(), trials);
    assert!(study.start().merge(&blocks[0]).is_err(), "blocks out of order");
    assert!(LocalizationBlock::from_numbers(&scenario, 3, &blocks[0].to_numbers()).is_err());
}

#[test]
fn bad_studies_are_refused() {
    let scenario = preset("localization-paper").unwrap();
    let refused = |noise, trials| LocalizationStudy::new(&scenario, noise, trials).unwrap_err().to_string();
    assert!(refused(sweep(), 0).contains("number of trials is 0"));
    assert!(refused(Vec::new(), 5).contains("points of a sweep is 0"));
    assert!(refused(vec![RangeNoise::Toa { zeta_db: f64::NAN }], 5).contains("zeta"));
}

#[test]
fn settings_are_checked_and_have_defaults() {
    let mut scenario = preset("room").unwrap();
    scenario.localize.enabled = vec![Name::Ls, Name::OucLs, Name::Ls];
    scenario.localize.tls_sigma = Some(-1.0);
    scenario.localize.loss = rangelab::model::localize_settings::Loss::Huber { scale: 0.0 };
    let paths: Vec<String> = scenario.validate().into_iter().map(|problem| problem.path).collect();
    assert_eq!(paths, ["localize.enabled[2]", "localize.tls_sigma", "localize.loss.scale"]);
    let text = preset("room").unwrap().to_json();
    let mut document: serde_json::Value = serde_json::from_str(&text).unwrap();
    document.as_object_mut().unwrap().remove("localize");
    assert_eq!(Scenario::from_json(&document.to_string()).unwrap(), preset("room").unwrap());
    document["localize"] =
        serde_json::json!({"enabled": ["ouc-ls"], "manifold": "o", "loss": {"kind": "huber", "scale": 2.0}});
    let read = Scenario::from_json(&document.to_string()).unwrap();
    assert_eq!((read.localize.enabled, read.localize.manifold), (vec![Name::OucLs], Manifold::O));
}

#[test]
fn clouds_are_the_trials() {
    let scenario = preset("localization-paper").unwrap();
    let names = scenario.localize.enabled.len();
    let stride = cloud_stride(3);
    let cloud = localization_cloud(&scenario, 2, 3).unwrap();
    assert_eq!(cloud.len(), 3 * names * stride);
    for trial in 0..3 {
        let run = localize_trial(&scenario, trial as u64 + 2).unwrap();
        for (index, estimate) in run.estimators.iter().enumerate() {
            let numbers = &cloud[(trial * names + index) * stride..][..stride];
            match &estimate.pose {
                Some(pose) => {
                    let mirrored = f64::from(u8::from(estimate.reflected));
                    assert_eq!(numbers[..3], [1.0, mirrored, estimate.iterations as f64]);
                    let (turned, moved) = numbers[3..].split_at(9);
                    for row in 0..3 {
                        let error = pose.position[row] - run.truth.position[row];
                        assert_eq!(moved[row], error, "{}", estimate.label);
                        for (column, true_row) in run.truth.orientation.iter().enumerate() {
                            let products = pose.orientation[row].iter().zip(true_row);
                            let entry: f64 = products.map(|(a, b)| a * b).sum();
                            assert!((turned[3 * row + column] - entry).abs() < 1e-12, "{}", estimate.label);
                        }
                    }
                }
                None => assert!(numbers.iter().all(|x| *x == 0.0)),
            }
        }
    }
}

#[test]
fn one_trial_is_a_document_without_gaps() {
    for name in ["localization-paper", "planar", "room", "rod", "three-anchors", "coplanar-ceiling"] {
        let run = localize_trial(&preset(name).unwrap(), 0).unwrap();
        for estimate in &run.estimators {
            assert!(estimate.failure.is_some() || !estimate.sensors.is_empty(), "{name}: {}", estimate.label);
            assert!(estimate.failure.is_some() || estimate.sensors_error.is_finite());
        }
        let text = serde_json::to_string(&run).unwrap();
        let back = serde_json::from_str(&text).unwrap();
        assert_eq!(run, back, "{name}: what is no number would come back as another");
    }
}

/// `cargo test --release --test localize full_size -- --ignored --nocapture` prints what each estimator costs and the whole
/// experiment of the paper on one core.
#[test]
#[ignore = "a timing, for a release build"]
fn full_size_run() {
    #[allow(clippy::disallowed_methods, reason = "a timing needs a clock")]
    let run = |enabled: Vec<Name>, trials: usize| {
        let mut scenario = preset("localization-paper").unwrap();
        scenario.localize.enabled = enabled;
        let start = std::time::Instant::now();
        let study = LocalizationStudy::new(&scenario, paper_sweep(), trials).unwrap();
        study.run().unwrap();
        start.elapsed().as_secs_f64() / (21 * trials) as f64
    };
    let alone = run(Vec::new(), 400);
    println!("draws, bounds: {:.1} us a trial and noise", 1e6 * alone);
    for name in Name::ALL {
        println!("{name}: {:.2} us", 1e6 * (run(vec![name], 400) - alone));
    }
    let each = run(Name::ALL.to_vec(), 2000);
    println!("2000 trials x 21 noises, all estimators: {:.2} s on one core", each * 42_000.0);
    assert!(each * 42_000.0 < 60.0, "{} s on one core is more than 30 s on two", each * 42_000.0);
}
