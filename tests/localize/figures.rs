//! The figures of the localization paper, each with its standard error: a figure may miss its target by three of them, which is
//! far less than what each claim is about.

use rangelab::math::rotation::Manifold;
use rangelab::model::localize_settings::LocalizerName as Name;
use rangelab::model::noise::RangeNoise;
use rangelab::model::presets::preset;
use rangelab::study::localization::report::{LocalizationReport, SnapshotBoundSummary, SnapshotSummary};
use rangelab::study::localization::{LocalizationStudy, SnapshotBound};
use rangelab::study::moments::Estimate;

const TRIALS: usize = 2000;

struct Experiment {
    preset: &'static str,
    enabled: &'static [Name],
    zeta: &'static [f64],
    manifold: Manifold,
    mounting_sigma: f64,
}

struct Result {
    report: LocalizationReport,
    zeta: &'static [f64],
}

impl Experiment {
    fn run(&self) -> Result {
        let mut scenario = preset(self.preset).unwrap();
        scenario.localize.enabled = self.enabled.to_vec();
        scenario.localize.manifold = self.manifold;
        scenario.mounting_sigma = self.mounting_sigma;
        let points = self.zeta.iter().map(|&zeta_db| RangeNoise::Toa { zeta_db }).collect();
        let report = LocalizationStudy::new(&scenario, points, TRIALS).unwrap().run().unwrap();
        Result { report, zeta: self.zeta }
    }
}

impl Result {
    fn point(&self, zeta: f64) -> usize {
        self.zeta.iter().position(|&x| (x - zeta).abs() < 1e-9).unwrap()
    }

    fn of(&self, name: Name, zeta: f64) -> SnapshotSummary {
        let found = self.report.estimators.iter().find(|each| each.name == name).unwrap();
        let summary = found.points[self.point(zeta)];
        assert_eq!((summary.trials, summary.failures), (TRIALS, 0), "{name} at {zeta} dB");
        summary
    }

    fn bound(&self, kind: SnapshotBound, zeta: f64) -> SnapshotBoundSummary {
        let found = self.report.bounds.iter().find(|each| each.name == kind.name()).unwrap();
        found.points[self.point(zeta)]
    }

    /// `RMSE(Q)` over the bound.
    fn ratio(&self, name: Name, kind: SnapshotBound, zeta: f64) -> Estimate {
        let (rmse, bound) = (self.of(name, zeta).rmse_orientation, self.bound(kind, zeta).orientation);
        // Anchors of a fixed draw have one bound; redrawn ones share the trials with the error, whose own spread counts.
        rmse.unwrap().over(Estimate { standard_error: 0.0, ..bound.unwrap() }).unwrap()
    }
}

/// In the target within three standard errors, which may not be wider than `sharp`.
#[track_caller]
fn lies(what: &str, found: Estimate, target: (f64, f64), sharp: f64) {
    let Estimate { value, standard_error } = found;
    println!("{what}: {value:.4} +- {standard_error:.4}, target {} to {}", target.0, target.1);
    assert!(standard_error <= sharp, "{what}: {found:?} is too blunt");
    let slack = 3.0 * standard_error;
    assert!(value >= target.0 - slack && value <= target.1 + slack, "{what}: {found:?} not in {target:?}");
}

fn about(value: f64, part: f64) -> (f64, f64) {
    (value * (1.0 - part), value * (1.0 + part))
}

const SHARP: f64 = 0.02;

#[test]
fn fixed_anchors() {
    use Name::{ClassicalLs, Ls, OucLs, SucLs};
    let experiment = Experiment {
        preset: "localization-paper",
        enabled: &[ClassicalLs, Ls, SucLs, OucLs],
        zeta: &[0.0, 10.0, 20.0, 30.0, 40.0, 60.0, 80.0, 100.0],
        manifold: Manifold::So,
        mounting_sigma: 0.0,
    };
    let found = experiment.run();
    for zeta in [20.0, 30.0, 40.0, 60.0, 80.0, 100.0] {
        lies(&format!("LS/RCRB, {zeta} dB"), found.ratio(Ls, SnapshotBound::Crb, zeta), (0.97, 1.03), SHARP);
    }
    for zeta in [60.0, 80.0, 100.0] {
        let ratio = found.ratio(OucLs, SnapshotBound::UnitaryCrb, zeta);
        lies(&format!("OUC-LS/UC-RCRB, {zeta} dB"), ratio, (0.95, 1.03), SHARP);
        let simple = found.ratio(SucLs, SnapshotBound::UnitaryCrb, zeta);
        lies(&format!("SUC-LS/UC-RCRB, {zeta} dB"), simple, (1.22, 1.42), 1.4 * SHARP);
        let summary = found.of(OucLs, zeta);
        assert!(summary.iterations.value < 2.5 && summary.most_iterations < 5, "{summary:?}");
        assert_eq!(summary.uncertain_rate.unwrap().value, 0.0, "an optimum is not certified at {zeta} dB");
    }
    for zeta in [0.0, 10.0] {
        let level = found.of(OucLs, zeta).rmse_orientation.unwrap();
        lies(&format!("saturation, {zeta} dB"), level, about(6f64.sqrt(), 0.04), SHARP);
        assert!(found.bound(SnapshotBound::UnitaryCrb, zeta).orientation.unwrap().value > 20.0);
    }
    for zeta in found.zeta {
        assert_eq!(found.of(OucLs, *zeta).reflection_rate.unwrap().value, 0.0, "SO(3) at {zeta} dB");
    }
    gains(&found, 80.0);
    bias(&found);
}

/// The body is found sqrt N times as well as one of its sensors (N times as plotted, for eq. 53 sums over the sensors).
fn gains(found: &Result, zeta: f64) {
    let classical = found.of(Name::ClassicalLs, zeta).rmse_sensors;
    let body = found.of(Name::OucLs, zeta);
    let plotted = classical.over(body.rmse_position.unwrap()).unwrap();
    lies("classical LS over t, as plotted", plotted, about(10.0, 0.03), 0.25);
    let each = Estimate {
        value: plotted.value / 10f64.sqrt(),
        standard_error: plotted.standard_error / 10f64.sqrt(),
    };
    lies("classical LS over t, per position", each, about(10f64.sqrt(), 0.03), 0.08);
    let aware = classical.over(body.rmse_sensors).unwrap();
    lies("classical LS over TA-localization", aware, about(2.48, 0.04), 0.06);
}

/// LS has no bias; that of a rotation is at least `RMSE^2/(2 sqrt 3)`, which vanishes.
fn bias(found: &Result) {
    for zeta in [20.0, 60.0, 100.0] {
        let bias = found.of(Name::Ls, zeta).bias_orientation.unwrap();
        assert!(bias.value < 2.0 * bias.standard_error, "LS at {zeta} dB: {bias:?}");
    }
    let summary = found.of(Name::OucLs, 40.0);
    let (bias, rmse) = (summary.bias_orientation.unwrap(), summary.rmse_orientation.unwrap().value);
    assert!(bias.value + 3.0 * bias.standard_error > rmse * rmse / (2.0 * 3f64.sqrt()), "{bias:?} {rmse}");
    assert!(found.of(Name::OucLs, 80.0).bias_orientation.unwrap().value < 0.003);
}

#[test]
fn reflections() {
    let experiment = Experiment {
        preset: "localization-paper",
        enabled: &[Name::OucLs],
        zeta: &[0.0, 10.0, 20.0, 30.0, 60.0],
        manifold: Manifold::O,
        mounting_sigma: 0.0,
    };
    let found = experiment.run();
    for zeta in [0.0, 10.0, 20.0, 30.0] {
        let rate = found.of(Name::OucLs, zeta).reflection_rate.unwrap();
        lies(&format!("reflections over O(3), {zeta} dB"), rate, (0.44, 0.54), 0.012);
    }
    assert_eq!(found.of(Name::OucLs, 60.0).reflection_rate.unwrap().value, 0.0);
}

#[test]
fn redrawn_anchors() {
    let mut experiment = Experiment {
        preset: "localization-paper-redrawn",
        enabled: &[Name::OucLs],
        zeta: &[50.0, 60.0, 80.0, 100.0],
        manifold: Manifold::So,
        mounting_sigma: 0.0,
    };
    let found = experiment.run();
    for zeta in [50.0, 60.0, 80.0, 100.0] {
        let ratio = found.ratio(Name::OucLs, SnapshotBound::UnitaryCrb, zeta);
        lies(&format!("OUC-LS/UC-RCRB redrawn, {zeta} dB"), ratio, (0.94, 1.06), 0.045);
    }
    // Over O(3) the same estimator does not come near the bound.
    experiment.manifold = Manifold::O;
    let found = experiment.run();
    for zeta in [60.0, 80.0, 100.0] {
        let ratio = found.ratio(Name::OucLs, SnapshotBound::UnitaryCrb, zeta);
        println!("over O(3), {zeta} dB: {ratio:?}");
        assert!(ratio.value - 3.0 * ratio.standard_error > 1.1 || ratio.value > 2.0, "{ratio:?}");
    }
}

#[test]
fn mounting_errors() {
    use Name::{Ls, OucLs, OucTls, OucTlsPrinted, SucLs, SucTls};
    let experiment = Experiment {
        preset: "localization-paper",
        enabled: &[Ls, SucLs, OucLs, SucTls, OucTlsPrinted, OucTls],
        zeta: &[60.0, 80.0, 100.0],
        manifold: Manifold::So,
        mounting_sigma: 0.1,
    };
    let found = experiment.run();
    let orientation = |name, zeta| found.of(name, zeta).rmse_orientation.unwrap();
    let floors = [(Ls, 0.054), (OucLs, 0.0371), (SucLs, 0.0309), (OucTls, 0.0309), (OucTlsPrinted, 0.0309)];
    for (name, floor) in floors {
        lies(&format!("floor of {name}"), orientation(name, 100.0), about(floor, 0.03), 0.001);
    }
    let position = found.of(OucLs, 100.0).rmse_position.unwrap();
    lies("floor of t", position, about(0.1 * (3f64 / 10.0).sqrt(), 0.02), 0.001);
    for zeta in [60.0, 80.0, 100.0] {
        let ratio = found.ratio(OucTls, SnapshotBound::UnitaryCrb, zeta);
        lies(&format!("OUC-TLS over its bound, {zeta} dB"), ratio, (0.96, 1.03), SHARP);
        assert_eq!(orientation(SucTls, zeta).value.to_bits(), orientation(SucLs, zeta).value.to_bits());
    }
    // As printed it is worse than the OUC-LS at 60 dB, better at 100 dB; matched it is never worse.
    let worse = orientation(OucTlsPrinted, 60.0).over(orientation(OucLs, 60.0)).unwrap();
    lies("printed OUC-TLS over OUC-LS, 60 dB", worse, about(1.13, 0.03), 0.03);
    let better = orientation(OucTls, 100.0).over(orientation(OucLs, 100.0)).unwrap();
    lies("OUC-TLS over OUC-LS, 100 dB", better, about(0.833, 0.03), 0.03);
}

/// Beyond the paper: nothing projected out, the unprojected bound is met.
#[test]
fn the_ranges_themselves() {
    let experiment = Experiment {
        preset: "localization-paper",
        enabled: &[Name::GaussNewton, Name::MaximumLikelihood],
        zeta: &[60.0, 80.0],
        manifold: Manifold::So,
        mounting_sigma: 0.0,
    };
    let found = experiment.run();
    for name in [Name::GaussNewton, Name::MaximumLikelihood] {
        for zeta in [60.0, 80.0] {
            let ratio = found.ratio(name, SnapshotBound::UnitaryCrbRaw, zeta);
            lies(&format!("{name} over the unprojected bound, {zeta} dB"), ratio, (0.96, 1.03), SHARP);
        }
        let projected = found.ratio(name, SnapshotBound::UnitaryCrb, 80.0);
        assert!(projected.value < 0.9, "{name} is not below the bound of projected ranges: {projected:?}");
    }
}
