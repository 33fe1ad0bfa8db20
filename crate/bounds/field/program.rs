//! The field as a program for a graphics card: the statements are those of the kernel itself, written down by numbers
//! that trace it ([`super::trace`]); here are only the loops around them.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::kernel::{Information, Scatter, add_sensor, add_square, weight};
use super::layout::FieldLayout;
use super::trace::{Tape, Traced};
use super::{FLOOR, Field};
use crate::math::number::Number;
use crate::model::availability::{BlockNumbers, line_is_free};
use crate::model::ranging::RangeForm;

/// Below this part of an information, single precision leaves fewer than three digits: the program answers -1, and the
/// value in double precision is shown instead.
const LEAST_PART_SINGLE: f64 = 2e-3;

/// Counts and numbers before the lists in the parameters. Arrays get their zeros explicitly: there are browsers that keep
/// the numbers of the last turn of a loop in a variable that is declared without a value.
const HEAD: &str = "
@group(0) @binding(0) var<storage, read> parameters: array<f32>;
@group(0) @binding(1) var values: texture_storage_2d<r32float, write>;

fn at(index: u32) -> f32 { return parameters[index]; }
fn place(index: u32) -> vec3<f32> { return vec3(at(index), at(index + 1u), at(index + 2u)); }

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
let size = textureDimensions(values);
if (id.x >= size.x || id.y >= size.y) { return; }
let headings = u32(at(0u));
let sensors = u32(at(1u));
let anchors = u32(at(2u));
let blocks = u32(at(3u));
let length = at(4u);
let law = vec2(at(5u), at(6u));
let scale = at(7u);
let first_anchor = 17u;
let first_block = first_anchor + 4u * anchors;
let first_lever = first_block + 8u * blocks;
let cell = (vec2<f32>(id.xy) + 0.5) / vec2<f32>(size);
let point = place(8u) + cell.x * place(11u) + cell.y * place(14u);
var sum = 0.0;
var resolved = true;
for (var heading = 0u; heading < headings; heading++) {
var j = array<f32, 36>();
for (var n = 0u; n < sensors; n++) {
let lever = place(first_lever + 3u * (heading * sensors + n));
let sensor = point + length * lever;
var r = array<f32, 6>();
var mean = array<f32, 3>();
var total = 0.0;
for (var m = 0u; m < anchors; m++) {
let anchor = place(first_anchor + 4u * m);
let reach = at(first_anchor + 4u * m + 3u);
let u = anchor - sensor;
";

const BLOCKS: &str = "
for (var b = 0u; b < blocks; b++) {
let k = first_block + 8u * b;
let centre = place(k);
let direction = vec2(at(k + 3u), at(k + 4u));
let half = place(k + 5u);
";

impl Field {
    /// The program (WGSL, entry point `main`, 8 x 8 threads). It reads [`Field::parameters`] and stores, for each cell of a
    /// texture over the rectangle of the layout, the bound in single precision (m or rad), or -1 where that has too few
    /// digits. It depends on the dimension, the form and the quantity alone.
    pub fn program(&self) -> String {
        let tape = Tape::default();
        tape.write(format_args!("{HEAD}"));
        self.pair(&tape);
        tape.write(format_args!("}}"));
        sensor(&tape);
        tape.write(format_args!("}}"));
        self.finish(&tape);
        tape.write(format_args!("}}"));
        tape.write(format_args!("let value = select(-1.0, sqrt(sum / f32(headings)) * scale, resolved);"));
        tape.write(format_args!("textureStore(values, id.xy, vec4(value, 0.0, 0.0, 0.0));\n}}"));
        tape.into_text()
    }

    /// The numbers that the program reads.
    #[allow(clippy::cast_possible_truncation, reason = "single precision is what the card computes in")]
    pub fn parameters(&self, layout: &FieldLayout) -> Vec<f32> {
        let sensors = self.levers.first().map_or(0, Vec::len);
        let counts = [self.levers.len(), sensors, self.anchors.len(), self.blocks.len()];
        // From the middle of the anchors, so that far from the origin nothing is lost to rounding.
        let middle = self.middle();
        let off = |point: &[f64; 3]| -> [f64; 3] { core::array::from_fn(|i| point[i] - middle[i]) };
        let mut all: Vec<f64> = counts.map(|count| count as f64).to_vec();
        all.extend([self.size, self.law[0], self.law[1], self.scale()]);
        all.extend(off(&layout.corner).into_iter().chain(layout.u).chain(layout.v));
        for (anchor, reach) in self.anchors.iter().zip(&self.max_squared_ranges) {
            all.extend(off(anchor));
            all.push(reach.min(1e30));
        }
        for block in &self.blocks {
            all.extend(off(&block.centre).into_iter().chain(block.heading).chain(block.half));
        }
        all.extend(self.levers.iter().flatten().flatten());
        all.into_iter().map(|x| x as f32).collect()
    }

    fn middle(&self) -> [f64; 3] {
        let count = self.anchors.len() as f64;
        core::array::from_fn(|i| self.anchors.iter().map(|a| a[i]).sum::<f64>() / count)
    }

    /// What one range adds to its sensor.
    fn pair(&self, tape: &Tape) {
        let u = vector(tape, ["u.x", "u.y", "u.z"]);
        let law = [tape.variable("law.x"), tape.variable("law.y")];
        let squared = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
        let w = weight(squared, law, u[0].constant(FLOOR), tape.variable("reach"));
        tape.write(format_args!("var w = {w};"));
        tape.write(format_args!("{BLOCKS}"));
        let block = BlockNumbers {
            centre: vector(tape, ["centre.x", "centre.y", "centre.z"]),
            heading: [tape.variable("direction.x"), tape.variable("direction.y")],
            half: vector(tape, ["half.x", "half.y", "half.z"]),
        };
        let anchor = vector(tape, ["anchor.x", "anchor.y", "anchor.z"]);
        let free = line_is_free(&block, anchor, vector(tape, ["sensor.x", "sensor.y", "sensor.z"]));
        let (w, zero) = (tape.variable("w"), u[0].constant(0.0));
        tape.write(format_args!("w = {};\n}}", Traced::choose(free, w, zero)));
        let mut scatter = Scatter {
            weight: tape.variable("total"),
            mean: core::array::from_fn(|i| tape.entry("mean", i)),
            square: core::array::from_fn(|i| tape.entry("r", i)),
        };
        match self.form {
            RangeForm::Raw => add_square(&mut scatter.square, w, u),
            RangeForm::Projected => scatter.add(w, u),
        }
        store(tape, "r", &scatter.square);
        if self.form == RangeForm::Projected {
            store(tape, "mean", &scatter.mean);
            tape.write(format_args!("total = {};", scatter.weight));
        }
    }

    /// What the information says of one heading.
    fn finish(&self, tape: &Tape) {
        let (trace, digits) = self.judged(&information(tape));
        let enough = digits.above(digits.constant(LEAST_PART_SINGLE));
        let one = Traced::choose(enough, digits.constant(1.0), digits.constant(0.0));
        tape.write(format_args!("sum += {trace};\nresolved = resolved && {one} > 0.5;"));
    }
}

/// What one sensor adds to the information.
fn sensor(tape: &Tape) {
    let mut j = information(tape);
    let r = core::array::from_fn(|i| tape.entry("r", i));
    add_sensor(&mut j, &r, vector(tape, ["lever.x", "lever.y", "lever.z"]));
    for (i, row) in j.iter().enumerate() {
        for (k, entry) in row.iter().enumerate().take(i + 1) {
            tape.write(format_args!("j[{}] = {entry};", 6 * i + k));
        }
    }
}

fn information(tape: &Tape) -> Information<Traced<'_>> {
    core::array::from_fn(|i| core::array::from_fn(|k| tape.entry("j", 6 * i + k)))
}

fn vector<'a>(tape: &'a Tape, names: [&'static str; 3]) -> [Traced<'a>; 3] {
    names.map(|name| tape.variable(name))
}

/// Values first, then variables: an entry that is read may be one that is stored.
fn store(tape: &Tape, name: &str, values: &[Traced]) {
    let text: Vec<String> = values.iter().map(|value| format!("{value}")).collect();
    for (i, value) in text.iter().enumerate() {
        tape.write(format_args!("{name}[{i}] = {value};"));
    }
}
