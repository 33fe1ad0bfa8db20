//! The motion of a network of nodes, up to what distances cannot show.

use nalgebra::DMatrix;
use pyo3::prelude::*;
use rangelab::model::kinematics::coefficients;

use crate::array::{Numbers, array};
use crate::compute::compute;
use crate::error::Error;

/// D x N matrices from rows of nodes' vectors, of which `numbers` holds `count` times `nodes`.
pub fn matrices(numbers: &[f64], [count, nodes, dimension]: [usize; 3]) -> Vec<DMatrix<f64>> {
    let size = nodes * dimension;
    (0..count)
        .map(|k| DMatrix::from_column_slice(dimension, nodes, &numbers[k * size..(k + 1) * size]))
        .collect()
}

/// A matrix, row by row.
pub fn by_rows<'py>(py: Python<'py>, matrix: &DMatrix<f64>) -> PyResult<Bound<'py, PyAny>> {
    array(py, &[matrix.nrows(), matrix.ncols()], matrix.transpose().iter().copied())
}

/// Three lengths of axes, or a sentence.
pub fn axes(what: &str, numbers: &Numbers, needed: &str) -> PyResult<[usize; 3]> {
    let shape = &numbers.shape;
    <[usize; 3]>::try_from(shape.as_slice())
        .map_err(|_| Error::new_err(format!("{what} have the shape {shape:?} where {needed} is needed")))
}

/// Coefficients `Y_0, ..., Y_L` of a motion.
#[pyclass(frozen, module = "rangelab._core")]
pub struct RelativeKinematics(pub coefficients::RelativeKinematics);

#[pymethods]
impl RelativeKinematics {
    /// From (L + 1) x N x D numbers.
    #[new]
    fn new(py: Python<'_>, coefficients: Numbers) -> PyResult<Self> {
        let shape = axes("coefficients", &coefficients, "(L + 1) x N x D")?;
        let matrices = matrices(&coefficients.entries, shape);
        compute(py, || coefficients::RelativeKinematics::new(matrices).map(Self))
    }

    fn coefficients<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let motion = &self.0;
        let shape = [motion.degree() + 1, motion.nodes(), motion.dimension()];
        array(py, &shape, motion.coefficients().iter().flatten().copied())
    }

    /// A derivative of the positions at each time: T x N x D.
    fn derivative<'py>(&self, py: Python<'py>, order: usize, times: Numbers) -> PyResult<Bound<'py, PyAny>> {
        let (motion, times) = (&self.0, &times.entries);
        let shape = [times.len(), motion.nodes(), motion.dimension()];
        let at =
            compute(py, || Ok(times.iter().map(|&time| motion.derivative(order, time)).collect::<Vec<_>>()))?;
        array(py, &shape, at.iter().flatten().copied())
    }

    /// Coefficients of the Gram matrix: (2 L + 1) x N x N.
    fn gram<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let gram = compute(py, || Ok(self.0.gram()))?;
        stack(py, self.0.nodes(), &gram)
    }

    fn centred(&self) -> Self {
        Self(self.0.centred())
    }

    fn aligned_to(&self, py: Python<'_>, truth: &RelativeKinematics) -> PyResult<Self> {
        let (found, expected) = (self.size(), truth.size());
        if found != expected {
            let sentence =
                format!("{found:?} are the nodes and dimensions of the motion where {expected:?} are needed");
            return Err(Error::new_err(sentence));
        }
        compute(py, || self.0.aligned_to(&truth.0).map(Self))
    }
}

impl RelativeKinematics {
    fn size(&self) -> [usize; 2] {
        [self.0.nodes(), self.0.dimension()]
    }
}

/// Symmetric N x N matrices one after the other.
pub fn stack<'py>(py: Python<'py>, nodes: usize, matrices: &[DMatrix<f64>]) -> PyResult<Bound<'py, PyAny>> {
    array(py, &[matrices.len(), nodes, nodes], matrices.iter().flatten().copied())
}
