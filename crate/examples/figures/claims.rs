//! What the tracking paper's experiment has to show, each with the figure that shows it.

use rangelab::bounds::BoundKind;
use rangelab::model::estimator_settings::EstimatorName::{self, Eskf, EskfRaw, EtKf, Kf, Ortho, UcKf};
use rangelab::model::presets::preset;
use rangelab::study::moments::Estimate;
use rangelab::study::monte_carlo::MonteCarlo;
use rangelab::study::report::{BoundSummary, StudyReport};
use rangelab::study::tally::Summary;

/// A figure and where it should lie.
pub struct Claim {
    /// What the figure is.
    pub what: String,
    /// The figure; not there where the study has no such number.
    pub found: Option<Estimate>,
    /// Least and most that is claimed.
    pub target: (f64, f64),
}

impl Claim {
    fn new(what: impl Into<String>, found: Option<Estimate>, target: (f64, f64)) -> Self {
        Self { what: what.into(), found, target }
    }

    /// How far the figure lies outside of the target, in standard errors: 0 inside.
    pub fn missed_by(&self) -> f64 {
        let Some(Estimate { value, standard_error }) = self.found else { return f64::INFINITY };
        let outside = (self.target.0 - value).max(value - self.target.1);
        if outside > 0.0 { outside / standard_error } else { 0.0 }
    }
}

/// Runs a preset of three dimensions.
pub fn study(name: &str, trials: usize) -> rangelab::Result<StudyReport> {
    let scenario = preset(name)?;
    let study = MonteCarlo::new(&scenario, trials)?;
    let mut total = study.start();
    for index in 0..study.blocks() {
        total.merge(&study.block(index)?)?;
    }
    Ok(study.report(&total))
}

/// What `tracking-paper` has to show: anchors fixed at a well-conditioned draw.
pub fn fixed(report: &StudyReport) -> Vec<Claim> {
    let mut claims = Vec::new();
    for k in [0, 4, 9, 19] {
        let found = ratio(at(report, Kf, k), |s| s.rmse_orientation, |s| s.claimed_orientation);
        claims.push(Claim::new(
            format!("KF: RMSE(Q) over its own covariance, step {k}"),
            found,
            (0.94, 1.03),
        ));
    }
    for name in [UcKf, Eskf] {
        let orientation = |k| over_bound(report, name, k, |s| s.rmse_orientation, |b| b.orientation);
        let position = |k| over_bound(report, name, k, |s| s.rmse_position, |b| b.position);
        for (what, of) in [("Q", &orientation as &dyn Fn(usize) -> _), ("t", &position)] {
            let (k, found) = extreme(report, of, 1.0);
            let what = format!("{}: RMSE({what}) over the posterior bound, worst step ({k})", name.label());
            claims.push(Claim::new(what, found, (0.0, 1.05)));
        }
    }
    let (k, found) = extreme(report, &|k| versus(report, EtKf, Ortho, k), -1.0);
    let what = format!("ET-KF: RMSE(Q) over that of KF-ortho, best step ({k})");
    claims.push(Claim::new(what, found, (1.0, f64::INFINITY)));
    // "Near 0.6, 0.1, 0.02": whatever is rounded to that.
    for (k, target) in [(0, (0.55, 0.65)), (1, (0.05, 0.15)), (2, (0.015, 0.025))] {
        let found = at(report, EtKf, k).map(|s| s.event_rate);
        claims.push(Claim::new(format!("ET-KF: share of trials projected, step {k}"), found, target));
    }
    let position = |name| at(report, name, 0).map(|s| s.rmse_position);
    let found = position(EskfRaw).zip(position(Eskf)).and_then(|(raw, projected)| raw.over(projected));
    claims.push(Claim::new("ESKF raw: RMSE(t) over that of ESKF, step 0", found, (0.0, 0.5)));
    claims
}

/// What `tracking-paper-redrawn` has to show: new anchors in every trial.
pub fn redrawn(report: &StudyReport) -> Vec<Claim> {
    vec![
        Claim::new("UC-KF: RMSE(Q) over that of KF, step 19", versus(report, UcKf, Kf, 19), (0.0, 1.0)),
        Claim::new(
            "KF-ortho: RMSE(Q) over that of KF, step 19",
            versus(report, Ortho, Kf, 19),
            (1.0, f64::INFINITY),
        ),
    ]
}

fn at(report: &StudyReport, name: EstimatorName, k: usize) -> Option<&Summary> {
    report.estimators.iter().find(|estimator| estimator.name == name)?.steps.get(k)
}

fn ratio(
    summary: Option<&Summary>,
    a: fn(&Summary) -> Estimate,
    b: fn(&Summary) -> Estimate,
) -> Option<Estimate> {
    summary.and_then(|summary| a(summary).over(b(summary)))
}

fn versus(report: &StudyReport, a: EstimatorName, b: EstimatorName, k: usize) -> Option<Estimate> {
    at(report, a, k)?.rmse_orientation.over(at(report, b, k)?.rmse_orientation)
}

fn over_bound(
    report: &StudyReport,
    name: EstimatorName,
    k: usize,
    error: fn(&Summary) -> Estimate,
    least: fn(&BoundSummary) -> Estimate,
) -> Option<Estimate> {
    let bound = report.bounds.iter().find(|bound| bound.name == BoundKind::PosteriorCrb.name())?;
    error(at(report, name, k)?).over(least(bound.steps.get(k)?))
}

/// The step with the largest figure (`sign` 1) or the least (-1).
fn extreme(
    report: &StudyReport,
    figure: &dyn Fn(usize) -> Option<Estimate>,
    sign: f64,
) -> (usize, Option<Estimate>) {
    let steps = report.estimators.first().map_or(0, |estimator| estimator.steps.len());
    let height = |found: Option<Estimate>| found.map_or(f64::INFINITY, |found| sign * found.value);
    let found = (0..steps).map(|k| (k, figure(k)));
    found.max_by(|(_, a), (_, b)| height(*a).total_cmp(&height(*b))).unwrap_or((0, None))
}
