//! The sums over anchors and sensors behind the information at a point.

use super::kernel::{Information, Scatter, Symmetric, add_sensor, add_square, weight};
use super::{FLOOR, Field};
use crate::math::number::Number;
use crate::model::availability::line_is_free;
use crate::model::ranging::RangeForm;

impl Field {
    /// The information about the pose of a body at a point, with these levers.
    pub(super) fn information<N: Number>(&self, point: [N; 3], levers: &[[f64; 3]]) -> Information<N> {
        let zero = point[0].constant(0.0);
        let mut j = [[zero; 6]; 6];
        for lever in levers {
            let sensor = core::array::from_fn(|i| point[i] + zero.constant(self.size * lever[i]));
            let r = match self.form {
                RangeForm::Raw => self.raw(sensor),
                RangeForm::Projected => self.projected(sensor),
            };
            add_sensor(&mut j, &r, lever.map(|x| zero.constant(x)));
        }
        j
    }

    /// `4 sum_m w u u^T`.
    #[inline]
    fn raw<N: Number>(&self, sensor: [N; 3]) -> Symmetric<N> {
        let mut r = [sensor[0].constant(0.0); 6];
        for m in 0..self.anchors.len() {
            let u = core::array::from_fn(|i| sensor[0].constant(self.anchors[m][i]) - sensor[i]);
            add_square(&mut r, self.weight_of(m, sensor, u), u);
        }
        r
    }

    /// The same about the weighted mean of the anchors.
    #[inline]
    fn projected<N: Number>(&self, sensor: [N; 3]) -> Symmetric<N> {
        let zero = sensor[0].constant(0.0);
        let mut scatter = Scatter::empty(zero);
        for m in 0..self.anchors.len() {
            let u = core::array::from_fn(|i| zero.constant(self.anchors[m][i]) - sensor[i]);
            scatter.add(self.weight_of(m, sensor, u), u);
        }
        scatter.square
    }

    #[inline]
    fn weight_of<N: Number>(&self, m: usize, sensor: [N; 3], u: [N; 3]) -> N {
        let constant = |x: f64| sensor[0].constant(x);
        let squared = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
        let limit = constant(self.max_squared_ranges[m]);
        let mut w = weight(squared, self.law.map(constant), constant(FLOOR), limit);
        for block in &self.blocks {
            let free = line_is_free(&block.map(constant), self.anchors[m].map(constant), sensor);
            w = N::choose(free, w, constant(0.0));
        }
        w
    }
}
