//! A quantity that changes from one value to the next in smooth steps.

use alloc::vec::Vec;

/// Value, first and second derivative by time.
pub type Jet = [f64; 3];

/// One change: by how much, from when to when (s).
#[derive(Clone, Copy, Debug)]
pub struct Change {
    pub from: f64,
    pub to: f64,
    pub by: f64,
}

/// A start value and the changes added to it, each by the quintic smooth step `6 x^5 - 15 x^4 + 10 x^3`.
#[derive(Clone, Debug, Default)]
pub struct Profile {
    pub start: f64,
    pub changes: Vec<Change>,
}

impl Profile {
    /// Always the same.
    pub fn constant(start: f64) -> Self {
        Self { start, changes: Vec::new() }
    }

    /// Begins at the first value and goes to each of the next within its span of time.
    pub fn through(start: f64, steps: &[(f64, f64, f64)]) -> Self {
        let mut value = start;
        let mut change = |&(from, to, target): &(f64, f64, f64)| {
            let by = target - value;
            value = target;
            Change { from, to, by }
        };
        Self { start, changes: steps.iter().map(&mut change).collect() }
    }

    /// The quantity at a time, s.
    pub fn at(&self, time: f64) -> Jet {
        let mut jet = [self.start, 0.0, 0.0];
        for change in &self.changes {
            let length = change.to - change.from;
            let [value, slope, bend] = smooth_step((time - change.from) / length);
            jet[0] += change.by * value;
            jet[1] += change.by * slope / length;
            jet[2] += change.by * bend / (length * length);
        }
        jet
    }
}

/// 0 before 0, 1 after 1, twice continuously differentiable.
fn smooth_step(x: f64) -> Jet {
    if x <= 0.0 {
        return [0.0; 3];
    }
    if x >= 1.0 {
        return [1.0, 0.0, 0.0];
    }
    let y = 1.0 - x;
    [x * x * x * (10.0 - x * (15.0 - 6.0 * x)), 30.0 * x * x * y * y, 60.0 * x * y * (1.0 - 2.0 * x)]
}
