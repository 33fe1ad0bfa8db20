//! Thin WebAssembly facade over rangelab.
