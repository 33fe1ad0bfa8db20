//! Ranges made into positions of the transmitters, which is what most filters update with.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use super::rigid_fix::rigid_fix;
use super::trilateration::trilaterate;
use crate::model::indoor::TRANSMITTERS;
use crate::model::indoor::epoch::{BeaconRanges, IndoorModel};
use crate::model::indoor::filter_settings::{FilterSettings, FixCovariance, FrontEndKind, TransmitterChoice};

/// Ranges that a transmitter needs to be found by itself.
pub const LEAST_RANGES: usize = 4;

/// Makes fixes of ranges.
#[derive(Clone, Debug)]
pub struct FrontEnd {
    kind: FrontEndKind,
    covariance: FixCovariance,
    transmitters: TransmitterChoice,
}

/// Where the transmitters are, as far as they were found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fix {
    /// Position in the world frame (m) and its covariance (m^2), transmitter by transmitter.
    pub transmitters: [Option<(Vector3<f64>, Matrix3<f64>)>; TRANSMITTERS],
}

impl FrontEnd {
    /// The front end of the settings.
    pub fn new(settings: &FilterSettings) -> Self {
        Self {
            kind: settings.front_end,
            covariance: settings.fix_covariance,
            transmitters: settings.transmitters,
        }
    }

    /// Positions of the transmitters from the ranges of one epoch; `None` where none is found. `expected`, where they are
    /// believed to be, only says where the search starts and on which side of coplanar beacons the body is.
    ///
    /// A transmitter with fewer than [`LEAST_RANGES`] ranges is not found, and neither is one whose search ends on a
    /// beacon or not at all; the triangle as a whole is fitted where all three are, and where that fails none is found.
    pub fn fix(
        &self,
        model: &IndoorModel,
        ranges: &[BeaconRanges],
        expected: &[Vector3<f64>; TRANSMITTERS],
    ) -> Option<Fix> {
        let variance = model.sigma * model.sigma;
        let mut fix = Fix { transmitters: [None; TRANSMITTERS] };
        let count = match self.transmitters {
            TransmitterChoice::All => TRANSMITTERS,
            TransmitterChoice::First => 1,
        };
        for (i, found) in fix.transmitters.iter_mut().enumerate().take(count) {
            let seen =
                model.beacons.iter().zip(ranges).filter_map(|(beacon, ranges)| Some((beacon, ranges[i]?)));
            if seen.clone().count() < LEAST_RANGES {
                continue;
            }
            let Ok(solution) = trilaterate(&seen, &expected[i]) else { continue };
            let shape = match self.covariance {
                FixCovariance::Isotropic => Matrix3::identity(),
                FixCovariance::Geometry => solution.geometry,
            };
            *found = Some((solution.position, shape * variance));
        }
        if let (FrontEndKind::Isosceles, [Some(a), Some(b), Some(c)]) = (self.kind, fix.transmitters) {
            let corners = rigid_fix(&model.beacons, ranges, &model.transmitters, &[a.0, b.0, c.0]).ok();
            let covariances = [a.1, b.1, c.1];
            fix.transmitters = core::array::from_fn(|i| corners.map(|corners| (corners[i], covariances[i])));
        }
        (fix.coordinates() > 0).then_some(fix)
    }
}

impl Fix {
    /// Coordinates that were found.
    pub fn coordinates(&self) -> usize {
        3 * self.transmitters.iter().flatten().count()
    }

    /// `y - expected`; zero where a transmitter was not found.
    pub fn innovation(&self, expected: &[Vector3<f64>; TRANSMITTERS]) -> SVector<f64, 9> {
        SVector::from_fn(|k, _| {
            self.transmitters[k / 3].map_or(0.0, |(position, _)| (position - expected[k / 3])[k % 3])
        })
    }

    /// Covariance of the nine coordinates; 1 where a transmitter was not found, whose rows of `H` are zero.
    pub fn covariance(&self) -> SMatrix<f64, 9, 9> {
        let mut z = SMatrix::<f64, 9, 9>::identity();
        for (i, found) in self.transmitters.iter().enumerate() {
            if let Some((_, block)) = found {
                z.fixed_view_mut::<3, 3>(3 * i, 3 * i).copy_from(block);
            }
        }
        z
    }

    /// 1 for each coordinate that was found, else 0.
    pub fn mask(&self) -> [f64; 9] {
        core::array::from_fn(|k| f64::from(u8::from(self.transmitters[k / 3].is_some())))
    }
}
