//! Pixels, and the few things that are drawn with them.

use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster, get_raster_width};

use super::colours::{INK, PAPER};

/// Red, green, blue.
pub type Colour = [u8; 3];

pub struct Canvas {
    pub width: usize,
    pub height: usize,
    pixels: Vec<Colour>,
}

/// How a line is drawn: with so many pixels on either side of its middle, in dashes of so many pixels.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Stroke {
    pub half: usize,
    pub dash: Option<usize>,
}

/// Height of a letter.
pub const LINE: usize = RasterHeight::Size16.val();

/// A rectangle of pixels.
#[derive(Clone, Copy)]
pub struct Frame {
    pub left: usize,
    pub top: usize,
    pub width: usize,
    pub height: usize,
}

impl Frame {
    pub fn right(&self) -> usize {
        self.left + self.width
    }

    pub fn bottom(&self) -> usize {
        self.top + self.height
    }

    /// The pixel at `s` of its width and `t` of its height from below, both 0..1.
    pub fn pixel(&self, [s, t]: [f64; 2]) -> [usize; 2] {
        [self.left + cell(s, self.width), self.top + cell(1.0 - t, self.height)]
    }

    /// The middle of its pixel in column `i` and row `j` from above, as parts of its width and its height from below.
    pub fn place(&self, i: usize, j: usize) -> [f64; 2] {
        [(i as f64 + 0.5) / self.width as f64, 1.0 - (j as f64 + 0.5) / self.height as f64]
    }
}

/// Which of `count` equal cells holds the place, 0..1.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the count")]
pub fn cell(place: f64, count: usize) -> usize {
    ((place.clamp(0.0, 1.0) * count as f64) as usize).min(count - 1)
}

/// Width of a text in pixels.
pub fn text_width(text: &str) -> usize {
    get_raster_width(FontWeight::Regular, RasterHeight::Size16) * text.chars().count()
}

impl Canvas {
    pub fn new(width: usize, height: usize, ground: Colour) -> Self {
        Self { width, height, pixels: vec![ground; width * height] }
    }

    /// A PNG file with texts (iTXt) by keyword.
    pub fn png(&self, texts: &[(&str, String)]) -> Result<Vec<u8>, png::EncodingError> {
        let side = |pixels: usize| u32::try_from(pixels).map_err(|_| png::EncodingError::LimitsExceeded);
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, side(self.width)?, side(self.height)?);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        for (keyword, text) in texts {
            encoder.add_itxt_chunk((*keyword).to_owned(), text.clone())?;
        }
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.pixels.as_flattened())?;
        writer.finish()?;
        Ok(bytes)
    }

    /// What is outside is cut off.
    pub fn set(&mut self, x: usize, y: usize, colour: Colour) {
        if x < self.width && y < self.height {
            self.pixels[y * self.width + x] = colour;
        }
    }

    pub fn fill(&mut self, frame: Frame, colour: Colour) {
        for y in frame.top..frame.bottom() {
            for x in frame.left..frame.right() {
                self.set(x, y, colour);
            }
        }
    }

    /// A line one pixel wide around the frame.
    pub fn border(&mut self, frame: Frame, colour: Colour) {
        let Frame { left, top, width, height } = frame;
        self.fill(Frame { height: 1, ..frame }, colour);
        self.fill(Frame { width: 1, ..frame }, colour);
        self.fill(Frame { left: left + width - 1, width: 1, ..frame }, colour);
        self.fill(Frame { top: top + height - 1, height: 1, ..frame }, colour);
    }

    /// The part of a straight line that lies in the frame, dark with a light rim. Its ends are parts of the frame's width and
    /// of its height from below.
    pub fn line(&mut self, frame: Frame, from: [f64; 2], to: [f64; 2], stroke: Stroke) {
        let Some([from, to]) = within_frame(from, to) else { return };
        let ([x, y], [i, j]) = (frame.pixel(from), frame.pixel(to));
        let pixels = x.abs_diff(i).max(y.abs_diff(j)).max(1);
        for (half, colour) in [(stroke.half + 1, PAPER), (stroke.half, INK)] {
            for k in 0..=pixels {
                if stroke.dash.is_some_and(|dash| k / dash % 2 == 1) {
                    continue;
                }
                let share = k as f64 / pixels as f64;
                let [x, y] =
                    frame.pixel(core::array::from_fn(|axis| from[axis] + share * (to[axis] - from[axis])));
                self.dot(frame, [x, y], half, colour);
            }
        }
    }

    /// A square of pixels about one, as far as it lies in the frame.
    fn dot(&mut self, frame: Frame, [x, y]: [usize; 2], half: usize, colour: Colour) {
        let (left, top) = (x.saturating_sub(half).max(frame.left), y.saturating_sub(half).max(frame.top));
        let (right, bottom) = ((x + half + 1).min(frame.right()), (y + half + 1).min(frame.bottom()));
        self.fill(Frame { left, top, width: right - left, height: bottom - top }, colour);
    }

    /// A text with its upper left corner there. Letters that the font lacks become question marks.
    pub fn text(&mut self, [x, y]: [usize; 2], text: &str, colour: Colour) {
        let raster = |letter| get_raster(letter, FontWeight::Regular, RasterHeight::Size16);
        let mut left = x;
        for letter in text.chars() {
            let Some(shape) = raster(letter).or_else(|| raster('?')) else { continue };
            for (j, row) in shape.rows().enumerate() {
                for (i, strength) in row.iter().enumerate() {
                    self.blend([left + i, y + j], colour, *strength);
                }
            }
            left += shape.width();
        }
    }

    fn blend(&mut self, [x, y]: [usize; 2], colour: Colour, strength: u8) {
        if x < self.width && y < self.height {
            let pixel = &mut self.pixels[y * self.width + x];
            *pixel = mixed(*pixel, colour, f64::from(strength) / 255.0);
        }
    }
}

/// The part of a line whose coordinates are all from 0 to 1 (Liang and Barsky).
fn within_frame(from: [f64; 2], to: [f64; 2]) -> Option<[[f64; 2]; 2]> {
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let along = to[axis] - from[axis];
        let [low, high] = [-from[axis], 1.0 - from[axis]];
        if along == 0.0 {
            if low > 0.0 || high < 0.0 {
                return None;
            }
            continue;
        }
        let (one, other) = (low / along, high / along);
        (first, last) = (first.max(one.min(other)), last.min(one.max(other)));
    }
    let at = |part: f64| core::array::from_fn(|axis| from[axis] + part * (to[axis] - from[axis]));
    (first <= last).then(|| [at(first), at(last)])
}

/// Between two colours: the first for a share of 0, the second for 1.
pub fn mixed(one: Colour, other: Colour, share: f64) -> Colour {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 255")]
    let between = |i: usize| (f64::from(one[i]) * (1.0 - share) + f64::from(other[i]) * share + 0.5) as u8;
    [between(0), between(1), between(2)]
}
