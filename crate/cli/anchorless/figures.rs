//! What a trial and a study show of an estimator or a bound.

use rangelab::study::kinematics::bounds::KinematicsBoundReport;
use rangelab::study::moments::Estimate;

/// What the columns of numbers mean.
pub const LEGEND: &str = "
  Y0, Y1, Y2  root mean square error of a coordinate of position, velocity and acceleration at time 0, with one alignment;
              the paper's RMSE is this over the root of the number of coordinates
  B0          the same of an entry of the Gram matrix of the positions at time 0
  at the end  of a coordinate of the positions at the last instant, with that alignment, and aligned there
  CRB         what no unbiased estimator can beat, for the true motion
";

/// The errors of an estimator, or the bounds on them; a list is empty where there are none.
pub struct Figures<'a, T> {
    pub coefficients: &'a [T],
    pub gram: &'a [T],
    pub positions: &'a [T],
    pub aligned_positions: &'a [T],
}

impl<'a> Figures<'a, f64> {
    pub fn of_bound(bound: &'a KinematicsBoundReport) -> Self {
        let KinematicsBoundReport { coefficients, gram, positions, aligned_positions, .. } = bound;
        Self { coefficients, gram, positions, aligned_positions }
    }
}

/// The header of a table.
pub fn header(last: &'static str) -> [&'static str; 8] {
    ["", "Y0, m", "Y1, m/s", "Y2, m/s^2", "B0, m^2", "at the end, m", "aligned, m", last]
}

impl<T> Figures<'_, T> {
    /// A row of a table: who, the figures, and what comes last.
    pub fn row(&self, label: &str, cell: impl Fn(&T) -> String, last: String) -> [String; 8] {
        let cell = |figure: Option<&T>| figure.map_or_else(String::new, &cell);
        let [y0, y1, y2] = [0, 1, 2].map(|l| cell(self.coefficients.get(l)));
        let b0 = cell(self.gram.first());
        let [end, aligned] = [self.positions, self.aligned_positions].map(|list| cell(list.last()));
        [label.to_owned(), y0, y1, y2, b0, end, aligned, last]
    }

    /// The rows of a file with all of them: `start`, what the figure is of, the order l of a coefficient or the instant (s)
    /// of positions, and the figure.
    pub fn rows(&self, start: &str, instants: &[f64], cell: impl Fn(&T) -> String) -> Vec<String> {
        let mut rows = Vec::new();
        for (quantity, list) in [("coefficient", self.coefficients), ("gram", self.gram)] {
            rows.extend(
                list.iter().enumerate().map(|(l, it)| format!("{start},{quantity},{l},,{}", cell(it))),
            );
        }
        for (quantity, list) in [("position", self.positions), ("aligned_position", self.aligned_positions)] {
            let each = list.iter().zip(instants);
            rows.extend(each.map(|(it, instant)| format!("{start},{quantity},,{instant:?},{}", cell(it))));
        }
        rows
    }
}

/// Four digits, whatever the size.
pub fn exact(figure: f64) -> String {
    Estimate { value: figure, standard_error: 0.0 }.to_string()
}

/// Each sentence that says why there is nothing, once, behind those it holds for.
pub fn failures<'a>(each: impl Iterator<Item = (&'a str, Option<&'a String>)>) -> String {
    let mut reasons: Vec<(&str, Vec<&str>)> = Vec::new();
    for (label, failure) in each {
        let Some(reason) = failure else { continue };
        match reasons.iter_mut().find(|(known, _)| known == reason) {
            Some((_, labels)) => labels.push(label),
            None => reasons.push((reason, vec![label])),
        }
    }
    let lines = reasons.iter().map(|(reason, labels)| format!("{}: {reason}\n", labels.join("; ")));
    let lines: String = lines.collect();
    if lines.is_empty() { lines } else { format!("\n{lines}") }
}
