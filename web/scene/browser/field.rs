//! The field of the scene on a canvas: a grid of numbers, and a finer one that a kernel fills.
//!
//! What takes time returns a promise and borrows nothing, so that the scene can be drawn meanwhile.

use std::pin::Pin;

use js_sys::{Float32Array, Promise};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsError, JsValue};
use wasm_bindgen_futures::future_to_promise;

use super::{Scene, copy};
use crate::data::{FIELD_PARAMETERS, FIELD_VALUES};
use crate::error::SceneError;

#[wasm_bindgen]
impl Scene {
    /// Replaces the field, under everything else: positive numbers row by row at the centres of the cells of a rectangle
    /// (corner xyz, edge u xyz, edge v xyz); 1e30 and more means that no bound exists there. `style` is low, high,
    /// `worse_than` (0: no limit), opacity, hatch rgb, no-bound rgb, count of stops (2 to 16), then the rgb of each stop.
    /// Without a column or a row there is no field. Another rectangle drops the fine field.
    ///
    /// # Errors
    /// A sentence that names the first bad number; the old field is kept.
    pub fn set_field(
        &mut self,
        values: &Float32Array,
        width: u32,
        height: u32,
        rectangle: &Float32Array,
        style: &Float32Array,
    ) -> Result<(), JsError> {
        let field = &mut self.incoming_field;
        (field.width, field.height) = (width, height);
        if !field.is_empty() {
            copy(values, &FIELD_VALUES, &mut field.values)?;
            (field.rectangle, field.style) = (rectangle.to_vec(), style.to_vec());
        }
        Ok(self.renderer.field.set(field)?)
    }

    /// Whether fine fields can be computed: never with WebGL2.
    pub fn can_compute(&self) -> bool {
        self.renderer.field.can_compute()
    }

    /// Compiles the kernel that fills fine fields, and drops the one before: a WGSL module whose entry point `main` has
    /// `@workgroup_size(8, 8)`, reads `@group(0) @binding(0) var<storage, read> parameters: array<f32>` and stores into
    /// `@group(0) @binding(1) var values: texture_storage_2d<r32float, write>`. It may be used once the promise resolves;
    /// the promise rejects with the compiler's message.
    #[wasm_bindgen(unchecked_return_type = "Promise<void>")]
    pub fn set_field_kernel(&mut self, wgsl: &str) -> Promise {
        promise(self.renderer.field.set_kernel(wgsl), |()| JsValue::UNDEFINED)
    }

    /// Submits the computation of a fine field over the rectangle of the field. It is drawn from now on where it is not
    /// negative ("not resolved"); the promise resolves when it is filled, and rejects with the reason why it is not.
    #[wasm_bindgen(unchecked_return_type = "Promise<void>")]
    pub fn compute_field(&mut self, parameters: &Float32Array, width: u32, height: u32) -> Promise {
        let copied = copy(parameters, &FIELD_PARAMETERS, &mut self.incoming);
        let submitted = copied.and_then(|()| self.renderer.field.compute(&self.incoming, width, height));
        promise(submitted, |()| JsValue::UNDEFINED)
    }

    /// Draws only the numbers of the field itself from now on.
    pub fn drop_fine_field(&mut self) {
        self.renderer.field.drop_fine();
    }

    /// The numbers of the fine field, row by row; the promise rejects if there is none.
    #[wasm_bindgen(unchecked_return_type = "Promise<Float32Array>")]
    pub fn read_fine_field(&self) -> Promise {
        promise(self.renderer.field.read_fine(), |numbers| Float32Array::from(&numbers[..]).into())
    }
}

type Pending = Pin<Box<dyn Future<Output = Result<JsValue, SceneError>>>>;

/// Work that was submitted, or why not, as a promise of what `value` makes of its result.
fn promise<T: 'static>(
    submitted: Result<impl Future<Output = Result<T, SceneError>> + 'static, SceneError>,
    value: impl FnOnce(T) -> JsValue + 'static,
) -> Promise {
    // Boxed, so that the module carries the machinery of promises once.
    let pending: Result<Pending, SceneError> = match submitted {
        Ok(future) => Ok(Box::pin(async move { future.await.map(value) })),
        Err(error) => Err(error),
    };
    future_to_promise(async move {
        let finished = async { pending?.await };
        finished.await.map_err(|error| JsError::from(error).into())
    })
}
