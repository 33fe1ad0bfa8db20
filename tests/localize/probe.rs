use rangelab::model::noise::RangeNoise;
use rangelab::model::presets::preset;
use rangelab::study::localization::{LocalizationStudy, paper_sweep};

#[test]
fn probe() {
    for name in ["localization-paper", "localization-paper-redrawn"] {
        let mut scenario = preset(name).unwrap();
        if let Ok(o) = std::env::var("O") {
            if o == "1" {
                scenario.localize.manifold = rangelab::math::rotation::Manifold::O;
            }
        }
        if let Ok(o) = std::env::var("SIG") {
            scenario.mounting_sigma = o.parse().unwrap();
        }
        if std::env::var("MS").is_ok() {
            scenario.localize.multi_start = true;
        }
        let trials = std::env::var("TRIALS").map(|t| t.parse().unwrap()).unwrap_or(200);
        let t0 = std::time::Instant::now();
        let report = LocalizationStudy::new(&scenario, paper_sweep(), trials).unwrap().run().unwrap();
        println!("{name} {trials} trials {:?}", t0.elapsed());
        for (i, p) in report.points.iter().enumerate() {
            if let RangeNoise::Toa { zeta_db } = p.noise {
                if zeta_db % 10.0 != 0.0 {
                    continue;
                }
                print!("{zeta_db:5} ");
            }
            for b in &report.bounds {
                let b = b.points[i];
                print!(
                    "[{} {:.4} {:.4} {:.4}] ",
                    b.trials,
                    b.orientation.map_or(0., |x| x.value),
                    b.position.map_or(0., |x| x.value),
                    b.sensors.map_or(0., |x| x.value)
                );
            }
            println!();
            for e in &report.estimators {
                let s = e.points[i];
                println!(
                    "      {:20} fail {:4} Q {:.4}±{:.4} ang {:.4} t {:.4} S {:.4} bias {:.4} refl {:.3} unc {:.3} it {:.2} max {}",
                    e.label,
                    s.failures,
                    s.rmse_orientation.map_or(0., |x| x.value),
                    s.rmse_orientation.map_or(0., |x| x.standard_error),
                    s.rms_angle.map_or(0., |x| x.value),
                    s.rmse_position.map_or(0., |x| x.value),
                    s.rmse_sensors.value,
                    s.bias_orientation.map_or(0., |x| x.value),
                    s.reflection_rate.map_or(0., |x| x.value),
                    s.uncertain_rate.map_or(0., |x| x.value),
                    s.iterations.value,
                    s.most_iterations
                );
            }
        }
    }
}
