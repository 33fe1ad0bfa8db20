//! Numbers that write down what is done with them, as statements of WGSL.

use alloc::string::String;
use core::cell::{Cell, RefCell};
use core::fmt::{self, Display, Write};
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::math::number::Number;

/// The statements so far.
#[derive(Default)]
pub struct Tape {
    text: RefCell<String>,
    names: Cell<usize>,
}

/// A number that the program will compute: a name of the text.
#[derive(Clone, Copy)]
pub struct Traced<'a> {
    tape: &'a Tape,
    name: Name,
}

/// A condition that the program will compute.
#[derive(Clone, Copy)]
pub struct Condition<'a> {
    tape: &'a Tape,
    name: usize,
}

#[derive(Clone, Copy)]
enum Name {
    /// A value computed before.
    Value(usize),
    /// A constant.
    Constant(f64),
    /// A variable of the program: its name and the index in it.
    Variable(&'static str, Option<usize>),
}

impl Tape {
    /// Writes program text of its own.
    pub fn write(&self, text: fmt::Arguments) {
        // A string takes everything.
        let _ = writeln!(self.text.borrow_mut(), "{text}");
    }

    /// A variable of the program.
    pub fn variable(&self, name: &'static str) -> Traced<'_> {
        Traced { tape: self, name: Name::Variable(name, None) }
    }

    /// An entry of an array of the program.
    pub fn entry(&self, name: &'static str, index: usize) -> Traced<'_> {
        Traced { tape: self, name: Name::Variable(name, Some(index)) }
    }

    /// The whole text.
    pub fn into_text(self) -> String {
        self.text.into_inner()
    }

    // One copy for all that is traced: this runs once a program, not once a point.
    #[inline(never)]
    fn value(&self, expression: fmt::Arguments) -> Traced<'_> {
        let name = self.next();
        self.write(format_args!("let v{name} = {expression};"));
        Traced { tape: self, name: Name::Value(name) }
    }

    #[inline(never)]
    fn condition(&self, expression: fmt::Arguments) -> Condition<'_> {
        let name = self.next();
        self.write(format_args!("let c{name} = {expression};"));
        Condition { tape: self, name }
    }

    fn next(&self) -> usize {
        let name = self.names.get();
        self.names.set(name + 1);
        name
    }
}

impl Display for Traced<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.name {
            Name::Value(name) => write!(f, "v{name}"),
            // An exponent makes every constant a number with a fraction, as WGSL wants it.
            Name::Constant(value) => write!(f, "f32({value:e})"),
            Name::Variable(name, None) => write!(f, "{name}"),
            Name::Variable(name, Some(index)) => write!(f, "{name}[{index}]"),
        }
    }
}

impl Traced<'_> {
    /// Whether it is that constant: sums with 0 and products with 0 or 1 need no statement.
    fn is(self, value: f64) -> bool {
        matches!(self.name, Name::Constant(own) if own.to_bits() == value.to_bits())
    }
}

impl Add for Traced<'_> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.is(0.0) {
            other
        } else if other.is(0.0) {
            self
        } else {
            self.tape.value(format_args!("{self} + {other}"))
        }
    }
}

impl Sub for Traced<'_> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        if other.is(0.0) { self } else { self.tape.value(format_args!("{self} - {other}")) }
    }
}

impl Mul for Traced<'_> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self.is(0.0) || other.is(1.0) {
            self
        } else if other.is(0.0) || self.is(1.0) {
            other
        } else {
            self.tape.value(format_args!("{self} * {other}"))
        }
    }
}

impl Div for Traced<'_> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        self.tape.value(format_args!("{self} / {other}"))
    }
}

impl Neg for Traced<'_> {
    type Output = Self;

    fn neg(self) -> Self {
        self.tape.value(format_args!("-{self}"))
    }
}

impl<'a> Number for Traced<'a> {
    type Truth = Condition<'a>;

    fn constant(self, value: f64) -> Self {
        Self { tape: self.tape, name: Name::Constant(value) }
    }

    fn abs(self) -> Self {
        self.tape.value(format_args!("abs({self})"))
    }

    fn above(self, other: Self) -> Condition<'a> {
        self.tape.condition(format_args!("{self} > {other}"))
    }

    fn both(one: Condition<'a>, other: Condition<'a>) -> Condition<'a> {
        one.tape.condition(format_args!("c{} && c{}", one.name, other.name))
    }

    fn not(truth: Condition<'a>) -> Condition<'a> {
        truth.tape.condition(format_args!("!c{}", truth.name))
    }

    fn choose(truth: Condition<'a>, yes: Self, no: Self) -> Self {
        truth.tape.value(format_args!("select({no}, {yes}, c{})", truth.name))
    }
}
