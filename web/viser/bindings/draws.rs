//! Anchors fixed against anchors redrawn, in numbered jobs.

use pyo3::prelude::*;
use rangelab::study::anchor_draws::{AnchorDraws as Inner, Deviation, Draw};

use crate::array::array;
use crate::compute::compute;
use crate::documents::Scenario;

/// A study of draws of anchors.
#[pyclass(frozen, module = "rangelab._core")]
pub struct AnchorDraws(Inner);

#[pymethods]
impl AnchorDraws {
    #[new]
    fn new(py: Python<'_>, scenario: &Scenario, draws: usize) -> PyResult<Self> {
        compute(py, || Inner::new(&scenario.0, draws).map(Self))
    }

    #[getter]
    fn half_width(&self) -> f64 {
        self.0.half_width()
    }

    /// How many jobs there are.
    #[getter]
    fn jobs(&self) -> usize {
        self.0.blocks()
    }

    /// The draws of job `index`, from 0: draws x 2 x 7. Fixed, then redrawn anchors; the condition, then angle and position of
    /// the bound, of the KF and of the UC-KF; NaN for what is not there.
    fn job<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyAny>> {
        let pairs = compute(py, || self.0.block(index))?;
        let numbers = pairs.iter().flat_map(|pair| [row(&pair.fixed), row(&pair.redrawn)]);
        array(py, &[pairs.len(), 2, 7], numbers.flatten())
    }
}

fn row(draw: &Draw) -> [f64; 7] {
    let numbers = |of: Option<Deviation>| of.map_or([f64::NAN; 2], |each| [each.angle, each.position]);
    let ([a, b], [c, d], [e, f]) = (numbers(draw.bound), numbers(draw.errors[0]), numbers(draw.errors[1]));
    [draw.condition.unwrap_or(f64::NAN), a, b, c, d, e, f]
}
