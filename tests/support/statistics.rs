//! Moments with their standard errors, for data whose law is known.

/// Sums of a sample.
pub struct Sample {
    values: Vec<f64>,
}

impl Sample {
    pub fn new(values: impl IntoIterator<Item = f64>) -> Self {
        let values: Vec<f64> = values.into_iter().collect();
        assert!(values.len() > 100, "too few for a statistic: {}", values.len());
        Self { values }
    }

    fn mean_of(&self, f: impl Fn(f64) -> f64) -> f64 {
        self.values.iter().map(|&x| f(x)).sum::<f64>() / self.values.len() as f64
    }

    /// How far mean, variance, skewness and kurtosis are from those of N(0, 1), in standard errors.
    pub fn standard_normal_deviations(&self) -> [f64; 4] {
        let n = self.values.len() as f64;
        // Exact standard errors of the mean powers of N(0, 1): var x^p = E x^2p - (E x^p)^2.
        [
            self.mean_of(|x| x) * n.sqrt(),
            (self.mean_of(|x| x * x) - 1.0) * (n / 2.0).sqrt(),
            self.mean_of(|x| x * x * x) * (n / 15.0).sqrt(),
            (self.mean_of(|x| x * x * x * x) - 3.0) * (n / 96.0).sqrt(),
        ]
    }

    /// The same for mean and second moment of the uniform law on [0, 1).
    pub fn uniform_deviations(&self) -> [f64; 2] {
        let n = self.values.len() as f64;
        [
            (self.mean_of(|x| x) - 0.5) * (12.0 * n).sqrt(),
            (self.mean_of(|x| x * x) - 1.0 / 3.0) * (n / (1.0 / 5.0 - 1.0 / 9.0)).sqrt(),
        ]
    }

    pub fn is_standard_normal(&self) -> bool {
        self.standard_normal_deviations().iter().all(|deviation| deviation.abs() < LIMIT)
    }
}

/// Deviations beyond this many standard errors refute a law: by chance once in 150,000 comparisons.
pub const LIMIT: f64 = 4.5;

/// The mean product of two standard normal samples, in standard errors: 0 where they are independent.
pub fn correlation_deviation(x: &[f64], y: &[f64]) -> f64 {
    assert_eq!(x.len(), y.len());
    let n = x.len() as f64;
    x.iter().zip(y).map(|(a, b)| a * b).sum::<f64>() / n.sqrt()
}
