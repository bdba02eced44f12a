//! Units of length, as drawings name them.

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    name: &'static str,
    /// Its number in the variable `$INSUNITS` of DXF.
    number: u8,
    /// Of most units a whole number.
    micrometers: f64,
}

/// The foot of land surveys in the United States (micrometers).
const SURVEY_FOOT: f64 = 1e6 * 1_200.0 / 3_937.0;

/// The units that are known, by their numbers.
const UNITS: [Unit; 20] = [
    Unit::INCH,
    Unit::new("ft", 2, 304_800.0),
    Unit::new("mi", 3, 5_280.0 * 304_800.0),
    Unit::MILLIMETER,
    Unit::CENTIMETER,
    Unit::new("m", 6, 1e6),
    Unit::new("km", 7, 1e9),
    Unit::new("uin", 8, 0.0254),
    Unit::new("mil", 9, 25.4),
    Unit::new("yd", 10, 914_400.0),
    Unit::new("angstrom", 11, 1e-4),
    Unit::new("nm", 12, 1e-3),
    Unit::new("um", 13, 1.0),
    Unit::new("dm", 14, 1e5),
    Unit::new("dam", 15, 1e7),
    Unit::new("hm", 16, 1e8),
    Unit::new("us-ft", 21, SURVEY_FOOT),
    Unit::new("us-in", 22, SURVEY_FOOT / 12.0),
    Unit::new("us-yd", 23, SURVEY_FOOT * 3.0),
    Unit::new("us-mi", 24, SURVEY_FOOT * 5_280.0),
];

impl Unit {
    pub(crate) const INCH: Self = Self::new("in", 1, 25_400.0);
    pub(crate) const MILLIMETER: Self = Self::new("mm", 4, 1e3);
    pub(crate) const CENTIMETER: Self = Self::new("cm", 5, 1e4);

    const fn new(name: &'static str, number: u8, micrometers: f64) -> Self {
        Self { name, number, micrometers }
    }

    /// The unit with this symbol, as [`name`](Self::name) has it; none if it is not known.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::all().find(|unit| unit.name == name)
    }

    /// All units that are known.
    pub fn all() -> impl Iterator<Item = Self> {
        UNITS.into_iter()
    }

    /// Its symbol: `in`, `ft`, `mi`, `mm`, `cm`, `m`, `km`, `uin`, `mil`, `yd`, `angstrom`, `nm`,
    /// `um`, `dm`, `dam` or `hm`, of land surveys in the United States `us-ft`, `us-in`, `us-yd`
    /// or `us-mi`. A sheet of SVG is in `mm`, `cm` or `in`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.name
    }

    /// How long it is (micrometers).
    #[must_use]
    pub const fn micrometers(self) -> f64 {
        self.micrometers
    }

    pub(crate) const fn number(self) -> u8 {
        self.number
    }
}
