//! Units of length, as drawings name them.

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    name: &'static str,
    /// Of most units a whole number.
    micrometers: f64,
}

impl Unit {
    pub(crate) const fn new(name: &'static str, micrometers: f64) -> Self {
        Self { name, micrometers }
    }

    /// Its symbol: of DXF `in`, `ft`, `mi`, `mm`, `cm`, `m`, `km`, `uin`, `mil`, `yd`, `angstrom`,
    /// `nm`, `um`, `dm`, `dam` or `hm`, of land surveys in the United States `us-ft`, `us-in`,
    /// `us-yd` or `us-mi`; of SVG `mm`, `cm` or `in`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.name
    }

    /// How long it is (micrometers).
    #[must_use]
    pub const fn micrometers(self) -> f64 {
        self.micrometers
    }
}
