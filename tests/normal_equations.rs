//! Normal equations against the papers' own route: explicit isometry `U_M`, whitening, stacked `H = C_e^T (x) Abar`.
#![allow(clippy::float_cmp, reason = "where bits are compared, bits are meant")]

mod support;

use nalgebra::{DMatrix, DVector, SMatrix, SVector};
use rangelab::math::pose::{Pose, Theta};
use rangelab::model::anchors::Anchors;
use rangelab::model::noise::RangeNoise;
use rangelab::model::normal_equations::NormalEquations;
use rangelab::model::ranges::Ranges;
use rangelab::model::ranging::{RangeForm, RangeModel, Weighting};
use rangelab::model::topology::Topology;
use support::sampling::Sampler;
use support::{at_most, caught, dense, gain_form};

in_plane_and_space!(
    projected_form_is_the_papers_stacked_form,
    planted_errors_are_seen,
    raw_form_is_the_derivative_of_the_ranges,
    a_rigid_motion_of_everything_changes_nothing,
    the_order_of_anchors_does_not_matter,
    the_order_of_sensors_does_not_matter_with_pair_weights,
    kilometres_lose_no_digits,
    one_range_a_sensor_says_nothing_when_projected,
    ranges_without_a_weight_are_left_out,
);

const NOISES: [RangeNoise; 3] = [
    RangeNoise::SquaredRange { sigma: 0.3 },
    RangeNoise::Toa { zeta_db: 30.0 },
    RangeNoise::Range { sigma: 0.1 },
];

/// A model with noisy ranges, some missing if asked, and a reference away from the truth.
struct Problem<const D: usize> {
    model: RangeModel<D>,
    ranges: Ranges,
    weight_ranges: Ranges,
    reference: Theta<D>,
}

impl<const D: usize> Problem<D> {
    fn random(sampler: &mut Sampler, index: usize, missing: f64) -> Self {
        let weighting = if index.is_multiple_of(2) { Weighting::Common } else { Weighting::PerPair };
        let count = 2 + sampler.below(8);
        let anchors = sampler.anchors(count, 10.0);
        let count = 1 + sampler.below(7);
        let topology = sampler.topology(count, index % 4 < 2);
        let model = RangeModel::new(anchors, topology, NOISES[index % 3], weighting).unwrap();
        let exact = model.exact_ranges(&Theta::from(sampler.pose(2.0))).unwrap();
        let noisy = |keep: f64, sampler: &mut Sampler| {
            Ranges::from_fn(exact.anchors(), exact.sensors(), |m, n| {
                let noise = sampler.normal();
                (sampler.uniform(0.0, 1.0) < keep).then(|| exact.get(m, n).unwrap() + noise)
            })
            .unwrap()
        };
        let ranges = noisy(1.0 - missing, sampler);
        let weight_ranges = if index % 5 < 2 { exact.clone() } else { ranges.clone() };
        Self { model, ranges, weight_ranges, reference: sampler.theta(3.0) }
    }

    fn normal(&self, form: RangeForm) -> NormalEquations<D> {
        let mut buffer = self.model.range_buffer();
        self.model
            .normal_equations(&self.ranges, &self.weight_ranges, &self.reference, form, &mut buffer)
            .unwrap()
    }

    fn weight(&self, m: usize, n: usize) -> f64 {
        1.0 / gain_form::variance(self.model.noise(), self.model.weighting(), &self.weight_ranges, m, n)
    }
}

/// `H^T H`, `H^T (z - H theta_0)` and `||z - H theta_0||^2` of the stacked form.
fn stacked<const D: usize>(problem: &Problem<D>) -> (DMatrix<f64>, DVector<f64>, f64, usize) {
    let white = gain_form::measurements(&problem.model, &problem.ranges, &problem.weight_ranges);
    let residual = &white.values - &white.matrix * dense::vector(&problem.reference);
    let energy = residual.norm_squared();
    (white.matrix.tr_mul(&white.matrix), white.matrix.tr_mul(&residual), energy, white.values.len())
}

fn dense_information<const D: usize>(normal: &NormalEquations<D>) -> DMatrix<f64> {
    dense::matrix(&normal.information.to_blocks())
}

fn projected_form_is_the_papers_stacked_form<const D: usize>() {
    let mut sampler = Sampler::new(100);
    for index in 0..400 {
        let missing = if index % 7 < 3 { 0.3 } else { 0.0 };
        let problem = Problem::<D>::random(&mut sampler, index, missing);
        let (information, innovation, energy, residuals) = stacked(&problem);
        if residuals == 0 {
            continue;
        }
        let normal = problem.normal(RangeForm::Projected);
        at_most("Lambda", dense::difference(&dense_information(&normal), &information), 1e-11);
        at_most(
            "innovation",
            dense::vector_difference(&dense::vector(&normal.innovation), &innovation),
            1e-10,
        );
        at_most("energy", (normal.energy / energy - 1.0).abs(), 1e-10);
        assert_eq!(normal.residuals, residuals);
        let count = problem.ranges.anchors() * problem.ranges.sensors() - problem.ranges.missing();
        assert_eq!(normal.ranges, count);
        let theta = sampler.theta(1.0);
        let product = dense::vector(&normal.information.times(&theta));
        at_most(
            "Lambda x",
            dense::vector_difference(&product, &(information * dense::vector(&theta))),
            1e-11,
        );
    }
}

/// The effect of small mistakes, far above the tolerances of the comparison.
fn planted_errors_are_seen<const D: usize>() {
    let mut sampler = Sampler::new(101);
    for index in 0..40 {
        let problem = Problem::<D>::random(&mut sampler, index, 0.0);
        let (information, innovation, energy, _) = stacked(&problem);
        let mut spoiled = problem;
        let bent = Ranges::from_fn(spoiled.ranges.anchors(), spoiled.ranges.sensors(), |m, n| {
            let bend = if (m, n) == (0, 0) { 1.0 + 1e-3 } else { 1.0 };
            spoiled.ranges.get(m, n).map(|d| bend * d)
        });
        spoiled.weight_ranges = bent.unwrap();
        let normal = spoiled.normal(RangeForm::Projected);
        caught("a weight off by 1e-3", dense::difference(&dense_information(&normal), &information), 1e-9);
        let error = dense::vector_difference(&dense::vector(&normal.innovation), &innovation);
        caught("a weight off by 1e-3", error, 1e-9);
        caught("a weight off by 1e-3", (normal.energy / energy - 1.0).abs(), 1e-9);
    }
}

/// What the raw form must be, `J^T W J`, `J^T W e` and `e^T W e`. Squared ranges are quadratic in `theta`: central
/// differences of any step are exact.
fn by_differences<const D: usize>(problem: &Problem<D>) -> (DMatrix<f64>, DVector<f64>, f64) {
    let at = |theta: &DVector<f64>| problem.model.exact_ranges(&dense::theta(theta)).unwrap();
    let reference = dense::vector(&problem.reference);
    let slopes: Vec<(Ranges, Ranges)> = (0..reference.len())
        .map(|k| {
            let mut step = DVector::zeros(reference.len());
            step[k] = 0.5;
            (at(&(&reference + &step)), at(&(&reference - &step)))
        })
        .collect();
    let (mut information, mut innovation, mut energy) =
        (DMatrix::zeros(reference.len(), reference.len()), DVector::zeros(reference.len()), 0.0);
    let predicted = at(&reference);
    for n in 0..problem.ranges.sensors() {
        for m in 0..problem.ranges.anchors() {
            let Some(d) = problem.ranges.get(m, n) else { continue };
            let row = DVector::from_fn(reference.len(), |k, _| {
                slopes[k].0.get(m, n).unwrap() - slopes[k].1.get(m, n).unwrap()
            });
            let (w, e) = (problem.weight(m, n), d - predicted.get(m, n).unwrap());
            information += &row * row.transpose() * w;
            innovation += &row * (w * e);
            energy += w * e * e;
        }
    }
    (information, innovation, energy)
}

fn raw_form_is_the_derivative_of_the_ranges<const D: usize>() {
    let mut sampler = Sampler::new(102);
    for index in 0..200 {
        let problem = Problem::<D>::random(&mut sampler, index, if index % 2 == 0 { 0.3 } else { 0.0 });
        let normal = problem.normal(RangeForm::Raw);
        if normal.ranges == 0 {
            continue;
        }
        let (information, innovation, energy) = by_differences(&problem);
        at_most("Lambda", dense::difference(&dense_information(&normal), &information), 1e-11);
        at_most(
            "innovation",
            dense::vector_difference(&dense::vector(&normal.innovation), &innovation),
            1e-11,
        );
        at_most("energy", (normal.energy / energy - 1.0).abs(), 1e-11);
        let projected = dense_information(&problem.normal(RangeForm::Projected));
        caught("the projected form instead", dense::difference(&projected, &information), 1e-4);
    }
}

fn moved<const D: usize>(problem: &Problem<D>, motion: &Pose<D>) -> Problem<D> {
    let anchors = problem.model.anchors().positions().iter().map(|a| motion.act(a)).collect();
    let rotation = motion.rotation.matrix();
    Problem {
        model: RangeModel::new(
            Anchors::new(anchors).unwrap(),
            problem.model.topology().clone(),
            *problem.model.noise(),
            problem.model.weighting(),
        )
        .unwrap(),
        ranges: problem.ranges.clone(),
        weight_ranges: problem.weight_ranges.clone(),
        reference: Theta {
            orientation: rotation * problem.reference.orientation,
            position: motion.act(&problem.reference.position),
        },
    }
}

fn a_rigid_motion_of_everything_changes_nothing<const D: usize>() {
    let mut sampler = Sampler::new(103);
    for index in 0..100 {
        let problem = Problem::<D>::random(&mut sampler, index, 0.2);
        let motion = sampler.pose::<D>(5.0);
        let turn = DMatrix::identity(D + 1, D + 1)
            .kronecker(&DMatrix::from_fn(D, D, |i, j| motion.rotation.matrix()[(i, j)]));
        for form in [RangeForm::Projected, RangeForm::Raw] {
            let (before, after) = (problem.normal(form), moved(&problem, &motion).normal(form));
            let expected = &turn * dense_information(&before) * turn.transpose();
            let scale = expected.norm() + 1e-9;
            at_most("Lambda turns along", (dense_information(&after) - expected).norm(), 1e-11 * scale);
            let expected = &turn * dense::vector(&before.innovation);
            let scale = expected.norm() + 1e-9;
            at_most("innovation", (dense::vector(&after.innovation) - expected).norm(), 1e-10 * scale);
            at_most("energy", (after.energy - before.energy).abs(), 1e-10 * before.energy + 1e-12);
        }
    }
}

fn reordered(ranges: &Ranges, anchor: &[usize], sensor: &[usize]) -> Ranges {
    Ranges::from_fn(ranges.anchors(), ranges.sensors(), |m, n| ranges.get(anchor[m], sensor[n])).unwrap()
}

/// The problem with anchors and sensors listed in other orders.
fn permuted<const D: usize>(problem: &Problem<D>, anchor: &[usize], sensor: &[usize]) -> Problem<D> {
    let anchors = anchor.iter().map(|&m| problem.model.anchors().positions()[m]).collect();
    let sensors = sensor.iter().map(|&n| problem.model.topology().sensors()[n]).collect();
    Problem {
        model: RangeModel::new(
            Anchors::new(anchors).unwrap(),
            Topology::new(sensors).unwrap(),
            *problem.model.noise(),
            problem.model.weighting(),
        )
        .unwrap(),
        ranges: reordered(&problem.ranges, anchor, sensor),
        weight_ranges: reordered(&problem.weight_ranges, anchor, sensor),
        reference: problem.reference,
    }
}

#[track_caller]
fn same<const D: usize>(before: &NormalEquations<D>, after: &NormalEquations<D>) {
    let (a, b) = (dense_information(after), dense_information(before));
    at_most("Lambda", (&a - &b).norm(), 1e-12 * (b.norm() + 1e-9));
    let (a, b) = (dense::vector(&after.innovation), dense::vector(&before.innovation));
    at_most("innovation", (&a - &b).norm(), 1e-11 * (b.norm() + 1e-9));
    at_most("energy", (after.energy - before.energy).abs(), 1e-11 * before.energy + 1e-12);
    assert_eq!((after.ranges, after.residuals), (before.ranges, before.residuals));
}

fn the_order_of_anchors_does_not_matter<const D: usize>() {
    let mut sampler = Sampler::new(104);
    for index in 0..100 {
        let problem = Problem::<D>::random(&mut sampler, index, 0.2);
        let anchor: Vec<usize> = (0..problem.ranges.anchors()).rev().collect();
        let sensor: Vec<usize> = (0..problem.ranges.sensors()).collect();
        for form in [RangeForm::Projected, RangeForm::Raw] {
            same(&problem.normal(form), &permuted(&problem, &anchor, &sensor).normal(form));
        }
    }
}

fn the_order_of_sensors_does_not_matter_with_pair_weights<const D: usize>() {
    let mut sampler = Sampler::new(105);
    for index in (1..200).step_by(2) {
        let problem = Problem::<D>::random(&mut sampler, index, 0.2);
        let anchor: Vec<usize> = (0..problem.ranges.anchors()).collect();
        let sensor: Vec<usize> = (0..problem.ranges.sensors()).rev().collect();
        for form in [RangeForm::Projected, RangeForm::Raw] {
            same(&problem.normal(form), &permuted(&problem, &anchor, &sensor).normal(form));
        }
    }
}

/// Moving the origin 1000 km away costs the digits of the coordinates and no more.
fn kilometres_lose_no_digits<const D: usize>() {
    let mut sampler = Sampler::new(106);
    for index in 0..40 {
        let near = Problem::<D>::random(&mut sampler, index, 0.0);
        let away = Pose { position: SVector::repeat(1_048_576.0), ..Pose::identity() };
        let (before, after) =
            (near.normal(RangeForm::Projected), moved(&near, &away).normal(RangeForm::Projected));
        let expected = dense_information(&before);
        at_most("Lambda", dense::difference(&dense_information(&after), &expected), 1e-8);
    }
}

fn one_range_a_sensor_says_nothing_when_projected<const D: usize>() {
    let mut sampler = Sampler::new(107);
    for index in 0..40 {
        let mut problem = Problem::<D>::random(&mut sampler, index, 0.0);
        let all = problem.ranges.clone();
        let (anchors, sensors) = (all.anchors(), all.sensors());
        problem.ranges =
            Ranges::from_fn(anchors, sensors, |m, n| all.get(m, n).filter(|_| m == n % anchors)).unwrap();
        let normal = problem.normal(RangeForm::Projected);
        assert_eq!((normal.ranges, normal.residuals), (sensors, 0));
        at_most("Lambda", dense_information(&normal).norm(), 1e-20);
        at_most("energy", normal.energy, 1e-20);
        problem.ranges = Ranges::from_fn(anchors, sensors, |_, _| None).unwrap();
        for form in [RangeForm::Projected, RangeForm::Raw] {
            let normal = problem.normal(form);
            assert_eq!((normal.ranges, normal.residuals, normal.energy), (0, 0, 0.0));
            assert_eq!(dense_information(&normal).norm(), 0.0);
        }
    }
}

/// A range whose pair has no range to take a weight from counts as missing.
fn ranges_without_a_weight_are_left_out<const D: usize>() {
    let mut sampler = Sampler::new(108);
    for index in 0..40 {
        let mut problem = Problem::<D>::random(&mut sampler, index, 0.0);
        let all = problem.ranges.clone();
        let weightless =
            Ranges::from_fn(all.anchors(), all.sensors(), |m, n| all.get(m, n).filter(|_| m > 0)).unwrap();
        problem.weight_ranges = weightless.clone();
        let found = [RangeForm::Projected, RangeForm::Raw].map(|form| problem.normal(form));
        problem.ranges = weightless;
        let expected = [RangeForm::Projected, RangeForm::Raw].map(|form| problem.normal(form));
        for (found, expected) in found.iter().zip(&expected) {
            same(expected, found);
        }
    }
}

/// A plane body among plane anchors, written in space: the same information on the entries that exist in the plane.
#[test]
fn the_plane_is_a_slice_of_space() {
    let mut sampler = Sampler::new(109);
    for index in 0..60 {
        let plane = Problem::<2>::random(&mut sampler, index, 0.2);
        let lift = |p: &SVector<f64, 2>| SVector::<f64, 3>::new(p.x, p.y, 0.0);
        let mut orientation = SMatrix::<f64, 3, 3>::identity();
        orientation.fixed_view_mut::<2, 2>(0, 0).copy_from(&plane.reference.orientation);
        let space = Problem::<3> {
            model: RangeModel::new(
                Anchors::new(plane.model.anchors().positions().iter().map(lift).collect()).unwrap(),
                Topology::new(plane.model.topology().sensors().iter().map(lift).collect()).unwrap(),
                *plane.model.noise(),
                plane.model.weighting(),
            )
            .unwrap(),
            ranges: plane.ranges.clone(),
            weight_ranges: plane.weight_ranges.clone(),
            reference: Theta { orientation, position: lift(&plane.reference.position) },
        };
        let place = |k: usize| [0, 1, 3, 4, 9, 10][k];
        for form in [RangeForm::Projected, RangeForm::Raw] {
            let (flat, full) = (plane.normal(form), space.normal(form));
            let (small, large) = (dense_information(&flat), dense_information(&full));
            let slice = DMatrix::from_fn(6, 6, |i, j| large[(place(i), place(j))]);
            at_most("Lambda", (&slice - &small).norm(), 1e-13 * (small.norm() + 1e-9));
            let large = dense::vector(&full.innovation);
            let slice = DVector::from_fn(6, |i, _| large[place(i)]);
            let small = dense::vector(&flat.innovation);
            at_most("innovation", (&slice - &small).norm(), 1e-13 * (small.norm() + 1e-9));
            at_most("energy", (flat.energy - full.energy).abs(), 1e-13 * flat.energy + 1e-20);
        }
    }
}
