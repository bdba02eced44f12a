//! PNG rasters of figures, with the bundled font and no other.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};

use crate::error::DrawError;
use crate::figure::Figure;

/// The longest side of a raster, in pixels: one such square takes a gigabyte.
pub const RASTER_LIMIT: u32 = 16_384;

static FONT: &[u8] = include_bytes!("../fonts/DejaVuSans.ttf");

impl Figure {
    /// The picture as the bytes of a PNG file, with `scale` pixels per page unit.
    ///
    /// Letters come from the bundled font, so the raster is the same on every machine.
    ///
    /// # Errors
    /// [`DrawError::RasterSize`] if a side would be below one pixel or above
    /// [`RASTER_LIMIT`], [`DrawError::TooManyElements`] for a picture of a million shapes.
    pub fn to_png(&self, scale: f64) -> Result<Vec<u8>, DrawError> {
        let [width, height] = self.raster_size(scale)?;
        let mut fonts = fontdb::Database::new();
        fonts.load_font_data(FONT.to_vec());
        let options = Options { fontdb: Arc::new(fonts), ..Options::default() };
        let tree = Tree::from_str(&self.to_svg(), &options)
            // The text is well-formed, so the only other thing to refuse is its length.
            .map_err(|_| DrawError::TooManyElements)?;
        Ok(raster(&tree, [width, height], scale))
    }

    fn raster_size(&self, scale: f64) -> Result<[u32; 2], DrawError> {
        let sides = self.page().1.map(|side| (side * scale).round());
        if sides.iter().any(|side| !(1.0..=f64::from(RASTER_LIMIT)).contains(side)) {
            return Err(DrawError::RasterSize { scale, limit: RASTER_LIMIT });
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 1 and RASTER_LIMIT"
        )]
        let sides = sides.map(|side| side as u32);
        Ok(sides)
    }
}

/// The PNG file of a page with this many pixels.
#[expect(clippy::expect_used, reason = "sides were checked, and writing to memory does not fail")]
fn raster(tree: &Tree, [width, height]: [u32; 2], scale: f64) -> Vec<u8> {
    let mut pixels = Pixmap::new(width, height).expect("sides are within RASTER_LIMIT");
    #[expect(clippy::cast_possible_truncation, reason = "the renderer counts in f32")]
    let scale = scale as f32;
    resvg::render(tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    pixels.encode_png().expect("a raster with pixels has a PNG")
}
