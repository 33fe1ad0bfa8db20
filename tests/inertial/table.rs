use rangelab::model::imu::Convention;
use rangelab::model::indoor::presets::indoor_preset;
use rangelab::study::indoor::monte_carlo::IndoorMonteCarlo;

#[test]
#[ignore]
fn explore() {
    let trials: usize = std::env::var("TRIALS").map_or(60, |t| t.parse().unwrap());
    for (name, convention) in [Convention::Sample, Convention::Disc, Convention::Mean]
        .into_iter()
        .flat_map(|c| ["indoor-u", "indoor-zigzag", "indoor-bridge", "indoor-stair", "indoor-tumble"].map(|n| (n, c)))
    {
        let mut scenario = indoor_preset(name).unwrap();
        scenario.imu.convention = convention;
        let trials = if name == "indoor-stair" { trials / 4 } else { trials };
        let report = IndoorMonteCarlo::new(&scenario, trials).unwrap().run().unwrap();
        println!("{name} {convention:?}");
        for f in report.filters {
            let s = f.summary;
            let last = s.steps.last().unwrap();
            println!(
                "  {:<22} {:.4} +- {:.4} m  {:.3} deg  nees {:.2}  sv {:.3} {:.3} fail {} rep {}",
                f.label,
                s.position.value,
                s.position.standard_error,
                s.angle.value.to_degrees(),
                s.nees.value,
                last.largest_singular_value.value,
                last.smallest_singular_value.value,
                s.failures,
                s.repairs.value,
            );
        }
    }
}
