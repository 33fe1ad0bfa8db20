//! Only tests: see `field.rs`.
