//! Bounds of a snapshot: of the sensors' positions, and under mounting errors, against the stacked matrices.

use nalgebra::DMatrix;
use rangelab::bounds::constrained::image;
use rangelab::bounds::perturbed::{perturbed_information, sensor_information_traces};
use rangelab::bounds::sensors::sensor_trace;
use rangelab::bounds::{crb, fisher_information_of, unitary_crb};
use rangelab::model::ranging::RangeForm;

use crate::scenes::Scene;
use crate::support::sampling::Sampler;
use crate::support::{at_most, caught, dense, gain_form};

crate::in_plane_and_space!(
    no_mounting_errors_leave_the_bound_alone,
    mounting_errors_are_noise_that_the_ranges_of_a_sensor_share,
    the_bound_of_the_sensors_is_that_of_their_places,
    exact_ranges_leave_the_mounting_errors,
);

fn no_mounting_errors_leave_the_bound_alone<const D: usize>() {
    let mut sampler = Sampler::new(560);
    for index in 0..30 {
        let scene = Scene::<D>::random(&mut sampler, index, 0.0);
        let model = scene.model.per_pair();
        for form in [RangeForm::Projected, RangeForm::Raw] {
            let plain =
                fisher_information_of(&model, &scene.pose, &scene.ranges, form, &mut model.range_buffer())
                    .unwrap();
            let none = perturbed_information(&model, &scene.pose, &scene.ranges, form, 0.0).unwrap();
            let hardly = perturbed_information(&model, &scene.pose, &scene.ranges, form, 1e-7).unwrap();
            let (plain, none, hardly) =
                (dense::matrix(&plain.matrix), dense::matrix(&none.matrix), dense::matrix(&hardly.matrix));
            assert_eq!(plain, none);
            at_most("0.1 um", dense::difference(&hardly, &plain), 1e-9);
        }
    }
}

/// `F = H^T (Sigma + sigma_e^2 A A^T)^-1 H` on the stacked white model, where `A` is what the place of a sensor does to its rows.
fn mounting_errors_are_noise_that_the_ranges_of_a_sensor_share<const D: usize>() {
    let mut sampler = Sampler::new(561);
    let sigma = 0.1;
    for index in 0..30 {
        let scene = Scene::<D>::random(&mut sampler, index, 0.0);
        let model = scene.model.per_pair();
        let exact = model.exact_ranges(&scene.pose.into()).unwrap();
        let gain_form::Measurements { matrix, .. } = gain_form::measurements(&model, &scene.ranges, &exact);
        let mut shared = DMatrix::identity(matrix.nrows(), matrix.nrows());
        let mut first = 0;
        for n in 0..scene.ranges.sensors() {
            let rows = (0..scene.ranges.anchors()).filter(|&m| scene.ranges.get(m, n).is_some()).count() - 1;
            let abar = matrix.view((first, D * D), (rows, D)).into_owned();
            let block = &abar * abar.transpose() * (sigma * sigma);
            let sum = shared.view((first, first), (rows, rows)) + block;
            shared.view_mut((first, first), (rows, rows)).copy_from(&sum);
            first += rows;
        }
        let expected = matrix.transpose() * shared.cholesky().unwrap().inverse() * &matrix;
        let found =
            perturbed_information(&model, &scene.pose, &scene.ranges, RangeForm::Projected, sigma).unwrap();
        let found = dense::matrix(&found.matrix);
        at_most("F", dense::difference(&found, &expected), 1e-9);
        caught("F without", dense::difference(&found, &(matrix.transpose() * &matrix)), 1e-3);
    }
}

fn the_bound_of_the_sensors_is_that_of_their_places<const D: usize>() {
    let mut sampler = Sampler::new(562);
    for index in 0..30 {
        let scene = Scene::<D>::random(&mut sampler, index, 0.0);
        let model = scene.model.per_pair();
        let information =
            perturbed_information(&model, &scene.pose, &scene.ranges, RangeForm::Projected, 0.0).unwrap();
        let c = crb(&information).unwrap();
        let constrained = image(&unitary_crb(&information).unwrap(), &scene.pose.rotation);
        for covariance in [c, constrained] {
            let matrix = dense::matrix(&covariance);
            let expected: f64 = model
                .topology()
                .sensors()
                .iter()
                .map(|c| {
                    let extended = DMatrix::from_fn(1, D + 1, |_, j| if j < D { c[j] } else { 1.0 });
                    let place = extended.kronecker(&DMatrix::identity(D, D));
                    (&place * &matrix * place.transpose()).trace()
                })
                .sum();
            at_most(
                "[L] eq. 51",
                (sensor_trace(&covariance, model.topology()) - expected).abs(),
                1e-10 * expected,
            );
        }
        assert!(sensor_trace(&constrained, model.topology()) < sensor_trace(&c, model.topology()));
        let classical = sensor_information_traces(&model, &scene.pose, &scene.ranges, 0.0).unwrap();
        // With N = D + 1 sensors any matrix [Q | t] is as free as the sensors are.
        let gain = classical.unwrap().0 / sensor_trace(&c, model.topology());
        assert!(
            gain > 1.0 - 1e-9 && (gain > 1.01 || index % 3 == 0 || model.topology().len() == D + 1),
            "{gain}"
        );
    }
}

fn exact_ranges_leave_the_mounting_errors<const D: usize>() {
    let mut sampler = Sampler::new(563);
    for index in (0..30).step_by(3) {
        let scene = Scene::<D>::random(&mut sampler, index, 0.0);
        let count = scene.model.topology().len() as f64;
        let sensors = scene.model.topology().sensors();
        let mean = sensors.iter().sum::<nalgebra::SVector<f64, D>>() / count;
        let centred =
            rangelab::model::topology::Topology::new(sensors.iter().map(|c| c - mean).collect()).unwrap();
        let noise = rangelab::model::noise::RangeNoise::Range { sigma: 1e-5 };
        let model = rangelab::model::ranging::RangeModel::new(
            scene.model.anchors().clone(),
            centred,
            noise,
            rangelab::model::ranging::Weighting::PerPair,
        )
        .unwrap();
        let information =
            perturbed_information(&model, &scene.pose, &scene.ranges, RangeForm::Projected, 0.1).unwrap();
        let position = crb(&information).unwrap().position_block().trace();
        let expected = 0.01 * D as f64 / count;
        at_most("sigma_e sqrt(D/N)", (position / expected - 1.0).abs(), 1e-3);
    }
}
