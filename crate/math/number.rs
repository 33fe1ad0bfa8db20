//! What a kernel computes with: one number, several side by side, or the text of a program for a graphics card.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number that sums, products, quotients and comparisons can be formed of. A kernel written on it is one definition for
/// all that implement it.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// What a comparison gives.
    type Truth: Copy;

    /// A constant of the same kind as `self`.
    #[must_use]
    fn constant(self, value: f64) -> Self;
    /// `|self|`.
    #[must_use]
    fn abs(self) -> Self;
    /// `self > other`; false for what is no number.
    fn above(self, other: Self) -> Self::Truth;
    /// Both.
    fn both(one: Self::Truth, other: Self::Truth) -> Self::Truth;
    /// The opposite.
    fn not(truth: Self::Truth) -> Self::Truth;
    /// One where it is true, else the other.
    #[must_use]
    fn choose(truth: Self::Truth, yes: Self, no: Self) -> Self;

    /// The larger of two.
    #[must_use]
    fn larger(self, other: Self) -> Self {
        Self::choose(self.above(other), self, other)
    }
}

impl Number for f64 {
    type Truth = bool;

    #[inline]
    fn constant(self, value: f64) -> Self {
        value
    }

    #[inline]
    fn abs(self) -> Self {
        f64::abs(self)
    }

    #[inline]
    fn above(self, other: Self) -> bool {
        self > other
    }

    #[inline]
    fn both(one: bool, other: bool) -> bool {
        one && other
    }

    #[inline]
    fn not(truth: bool) -> bool {
        !truth
    }

    #[inline]
    fn choose(truth: bool, yes: Self, no: Self) -> Self {
        if truth { yes } else { no }
    }
}

/// Numbers side by side, which the machine computes with together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes<const L: usize>(pub [f64; L]);

macro_rules! lane_by_lane {
    ($operator:ident, $method:ident) => {
        impl<const L: usize> $operator for Lanes<L> {
            type Output = Self;

            #[inline]
            fn $method(self, other: Self) -> Self {
                let mut result = self;
                for i in 0..L {
                    result.0[i] = $operator::$method(self.0[i], other.0[i]);
                }
                result
            }
        }
    };
}

lane_by_lane!(Add, add);
lane_by_lane!(Sub, sub);
lane_by_lane!(Mul, mul);
lane_by_lane!(Div, div);

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(self.0.map(|x| -x))
    }
}

impl<const L: usize> Number for Lanes<L> {
    type Truth = [bool; L];

    #[inline]
    fn constant(self, value: f64) -> Self {
        Self([value; L])
    }

    #[inline]
    fn abs(self) -> Self {
        Self(self.0.map(f64::abs))
    }

    #[inline]
    fn above(self, other: Self) -> [bool; L] {
        core::array::from_fn(|i| self.0[i] > other.0[i])
    }

    #[inline]
    fn both(one: [bool; L], other: [bool; L]) -> [bool; L] {
        core::array::from_fn(|i| one[i] && other[i])
    }

    #[inline]
    fn not(truth: [bool; L]) -> [bool; L] {
        truth.map(|t| !t)
    }

    #[inline]
    fn choose(truth: [bool; L], yes: Self, no: Self) -> Self {
        let mut result = no;
        for i in 0..L {
            result.0[i] = if truth[i] { yes.0[i] } else { no.0[i] };
        }
        result
    }
}
