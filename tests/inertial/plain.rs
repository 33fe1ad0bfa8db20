//! Plain matrices and series for the reference: lists of rows, nothing clever, nothing of the crate.

pub type Matrix = Vec<Vec<f64>>;
pub type Vector = Vec<f64>;

pub fn zeros(rows: usize, columns: usize) -> Matrix {
    vec![vec![0.0; columns]; rows]
}

pub fn identity(size: usize) -> Matrix {
    let mut a = zeros(size, size);
    for i in 0..size {
        a[i][i] = 1.0;
    }
    a
}

pub fn times(a: &Matrix, b: &Matrix) -> Matrix {
    let mut c = zeros(a.len(), b[0].len());
    for i in 0..a.len() {
        for j in 0..b[0].len() {
            for k in 0..b.len() {
                c[i][j] += a[i][k] * b[k][j];
            }
        }
    }
    c
}

pub fn transpose(a: &Matrix) -> Matrix {
    (0..a[0].len()).map(|j| a.iter().map(|row| row[j]).collect()).collect()
}

/// `a + scale b`.
pub fn plus(a: &Matrix, scale: f64, b: &Matrix) -> Matrix {
    a.iter().zip(b).map(|(x, y)| x.iter().zip(y).map(|(x, y)| x + scale * y).collect()).collect()
}

pub fn on(a: &Matrix, x: &[f64]) -> Vector {
    a.iter().map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum()).collect()
}

pub fn add(x: &[f64], scale: f64, y: &[f64]) -> Vector {
    x.iter().zip(y).map(|(x, y)| x + scale * y).collect()
}

/// `F P F^T`.
pub fn congruence(f: &Matrix, p: &Matrix) -> Matrix {
    times(&times(f, p), &transpose(f))
}

/// Gauss-Jordan with row exchanges.
pub fn inverse(a: &Matrix) -> Matrix {
    let n = a.len();
    let mut left = a.clone();
    let mut right = identity(n);
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| left[i][k].abs().total_cmp(&left[j][k].abs())).unwrap();
        left.swap(k, pivot);
        right.swap(k, pivot);
        let scale = 1.0 / left[k][k];
        for matrix in [&mut left, &mut right] {
            matrix[k].iter_mut().for_each(|x| *x *= scale);
        }
        for i in (0..n).filter(|&i| i != k) {
            let factor = left[i][k];
            for matrix in [&mut left, &mut right] {
                for j in 0..n {
                    let x = matrix[k][j];
                    matrix[i][j] -= factor * x;
                }
            }
        }
    }
    right
}

/// `L` with `L L^T = A`.
pub fn cholesky(a: &Matrix) -> Matrix {
    let n = a.len();
    let mut l = zeros(n, n);
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| l[i][k] * l[j][k]).sum();
            l[i][j] = if i == j { (a[i][i] - sum).sqrt() } else { (a[i][j] - sum) / l[j][j] };
        }
    }
    l
}

pub fn hat(x: &[f64]) -> Matrix {
    vec![vec![0.0, -x[2], x[1]], vec![x[2], 0.0, -x[0]], vec![-x[1], x[0], 0.0]]
}

/// `sum_k K^k / (k + n)! * n!`-free: the series `sum_k K^k / (k + n)!`, so `Exp` for n = 0, `G_1` for 1, `G_2` for 2.
pub fn series(phi: &[f64], n: usize) -> Matrix {
    let k = hat(phi);
    let mut power = identity(3);
    let mut factorial: f64 = (1..=n).map(|i| i as f64).product();
    let mut sum = zeros(3, 3);
    for i in 0..40 {
        sum = plus(&sum, 1.0 / factorial, &power);
        power = times(&power, &k);
        factorial *= (i + 1 + n) as f64;
    }
    sum
}

/// The derivative of `series(phi, n) a` by `phi_axis`, term by term: `d K^k = sum K^m E K^(k-1-m)`.
pub fn series_slope(phi: &[f64], n: usize, a: &[f64], axis: usize) -> Vector {
    let k = hat(phi);
    let mut unit = [0.0; 3];
    unit[axis] = 1.0;
    let e = hat(&unit);
    let (mut power, mut slope) = (identity(3), zeros(3, 3));
    let mut factorial: f64 = (1..=n).map(|i| i as f64).product();
    let mut sum = zeros(3, 3);
    for i in 0..40 {
        sum = plus(&sum, 1.0 / factorial, &slope);
        slope = plus(&times(&slope, &k), 1.0, &times(&power, &e));
        power = times(&power, &k);
        factorial *= (i + 1 + n) as f64;
    }
    on(&sum, a)
}

/// Newton's iteration for the polar factor, to the end.
pub fn polar(a: &Matrix) -> Matrix {
    let mut x = a.clone();
    for _ in 0..60 {
        let next = plus(&zeros(3, 3), 0.5, &plus(&x, 1.0, &transpose(&inverse(&x))));
        x = next;
    }
    x
}

/// Gram-Schmidt, the third column the cross product of the others.
pub fn q_factor(a: &Matrix) -> Matrix {
    let column = |j: usize| [a[0][j], a[1][j], a[2][j]];
    let unit = |x: [f64; 3]| {
        let length = (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]).sqrt();
        x.map(|x| x / length)
    };
    let first = unit(column(0));
    let dot: f64 = (0..3).map(|i| first[i] * column(1)[i]).sum();
    let second = unit([0, 1, 2].map(|i| column(1)[i] - dot * first[i]));
    let third = [
        first[1] * second[2] - first[2] * second[1],
        first[2] * second[0] - first[0] * second[2],
        first[0] * second[1] - first[1] * second[0],
    ];
    (0..3).map(|i| vec![first[i], second[i], third[i]]).collect()
}
