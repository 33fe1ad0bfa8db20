//! The module of the lab Anchorless, in a browser: the same bits as the native library.
#![cfg(target_arch = "wasm32")]
