//! The figures of the paper's network against those of an independent implementation.

use rangelab::anchorless::estimate;
use rangelab::model::kinematics::presets::kinematics_preset;
use rangelab::model::kinematics::settings::KinematicsName;
use rangelab::model::kinematics::stamps::Stamps;
use rangelab::simulate::kinematics::simulate_kinematics;

#[test]
fn quick() {
    for k in [10, 100, 1000] {
        let mut scenario = kinematics_preset("kinematics-paper").unwrap();
        scenario.stamps = Stamps::Regular { first: -5.0, last: 5.0, count: k };
        let trials = 200;
        let names = &KinematicsName::ALL[..8];
        let mut sums = vec![[0.0; 3]; 8];
        let mut times = vec![0.0; 8];
        for trial in 0..trials {
            let drawn = simulate_kinematics(&scenario, trial).unwrap();
            for (i, &name) in names.iter().enumerate() {
                let start = std::time::Instant::now();
                let found = match estimate(name, &scenario.estimators, &drawn.record) {
                    Ok(f) => f,
                    Err(e) => {
                        println!("{name}: {e}");
                        continue;
                    }
                };
                times[i] += start.elapsed().as_secs_f64();
                let found = found.kinematics.unwrap().aligned_to(&drawn.truth).unwrap();
                for l in 0..3 {
                    sums[i][l] += (found.coefficient(l) - drawn.truth.coefficient(l)).norm_squared() / 20.0;
                }
            }
        }
        for (i, name) in names.iter().enumerate() {
            let r = sums[i].map(|s| (s / trials as f64).sqrt() * 1e3);
            println!(
                "{k} {name}: {:.3} {:.3} {:.3}   {:.0} us",
                r[0],
                r[1],
                r[2],
                times[i] / trials as f64 * 1e6
            );
        }
    }
}
