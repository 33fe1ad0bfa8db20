//! Floor 2: estimators that follow a moving body, epoch by epoch.

use alloc::boxed::Box;

use crate::model::epoch::Recording;
use crate::model::estimator_settings::{EstimatorName, EstimatorSettings};
use crate::model::ranging::RangeForm;
use error_state::ErrorStateKalmanFilter;
use event_triggered::{EventTriggeredKalmanFilter, ProjectionSettings, Trigger};
use filter::Estimator;
use kalman::KalmanFilter;
use unitary::UnitaryKalmanFilter;

pub mod error_state;
pub mod event_triggered;
pub mod filter;
pub mod kalman;
pub mod unitary;

/// The estimator of a name, ready for the first epoch of a recording.
pub fn estimator<const D: usize>(
    name: EstimatorName,
    settings: &EstimatorSettings,
    recording: &Recording<D>,
) -> Box<dyn Estimator<D> + Send> {
    let (model, initial, process) = (recording.model.clone(), &recording.initial, recording.process);
    let projected = |trigger| ProjectionSettings {
        trigger,
        metric: settings.metric,
        manifold: settings.manifold,
        feedback: settings.feedback,
    };
    match name {
        EstimatorName::Kf => Box::new(KalmanFilter::new(model, initial, process)),
        EstimatorName::Ortho => {
            Box::new(EventTriggeredKalmanFilter::new(model, initial, process, projected(Trigger::Always)))
        }
        EstimatorName::EtKf => {
            let trigger = Trigger::Above(settings.threshold);
            Box::new(EventTriggeredKalmanFilter::new(model, initial, process, projected(trigger)))
        }
        EstimatorName::UcKf => {
            Box::new(UnitaryKalmanFilter::new(model, initial, process, settings.manifold, settings.decoupled))
        }
        EstimatorName::Eskf => {
            Box::new(ErrorStateKalmanFilter::new(model, initial, process, RangeForm::Projected))
        }
        EstimatorName::EskfRaw => {
            Box::new(ErrorStateKalmanFilter::new(model, initial, process, RangeForm::Raw))
        }
    }
}
