//! The named bodies: centred, of unit size, and as flat as their names say.

use nalgebra::SVector;
use rangelab::model::topologies::topologies;
use rangelab::model::topology::Topology;

/// Names and the number of directions in which the sensors extend.
fn ranks<const D: usize>() -> Vec<(&'static str, usize)> {
    let measured = topologies(D).into_iter().map(|named| {
        let points: Vec<SVector<f64, D>> =
            named.sensors.iter().map(|point| SVector::from_column_slice(point)).collect();
        let apart = |a: &SVector<f64, D>| points.iter().map(|b| (a - b).norm()).fold(0.0, f64::max);
        let size = points.iter().map(apart).fold(0.0, f64::max);
        assert!((size - 1.0).abs() < 1e-15, "{}: {size} m long", named.name);
        let topology = Topology::new(points).unwrap();
        assert!(topology.is_centred(), "{}", named.name);
        (named.name, topology.spread().rank())
    });
    measured.collect()
}

#[test]
fn bodies_are_centred_of_unit_size_and_of_the_rank_that_they_are_shown_for() {
    let space = [
        ("pyramid", 3),
        ("tetrahedron", 3),
        ("cube", 3),
        ("cross", 3),
        ("square", 2),
        ("triangle", 2),
        ("rod", 1),
    ];
    assert_eq!(ranks::<3>(), space);
    assert_eq!(ranks::<2>(), [("triangle", 2), ("square", 2), ("hexagon", 2), ("rod", 1)]);
    assert_eq!(topologies(4), []);
}
