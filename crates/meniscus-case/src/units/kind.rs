//! The kinds of quantity that a case file holds.

/// Exponents of metre, kilogram, second, radian, kelvin and mole.
pub(crate) type Dimension = [i32; 6];

/// With zeros for what is left out at the end.
pub(super) const fn dimension<const N: usize>(exponents: [i32; N]) -> Dimension {
    let mut whole = [0; 6];
    let mut k = 0;
    while k < N {
        whole[k] = exponents[k];
        k += 1;
    }
    whole
}

/// A kind of quantity that a case file holds.
#[derive(Debug, PartialEq)]
pub(crate) struct Kind {
    /// "length"
    pub name: &'static str,
    pub dimension: Dimension,
    /// The SI unit, in which a bare number is read.
    pub si: &'static str,
    /// How one is written.
    pub example: &'static str,
}

macro_rules! kinds {
    ($($constant:ident $name:literal $dimension:tt $si:literal $example:literal)*) => {
        $(pub(crate) const $constant: Kind =
            Kind { name: $name, dimension: dimension($dimension), si: $si, example: $example };)*
        /// All kinds, to name what was found.
        pub(super) const KINDS: &[Kind] = &[$($constant),*];
    };
}

kinds! {
    LENGTH              "length"              [1, 0, 0, 0]   "m"       "0.05 mm"
    TIME                "time"                [0, 0, 1, 0]   "s"       "25 ms"
    MASS                "mass"                [0, 1, 0, 0]   "kg"      "1 g"
    ANGLE               "angle"               [0, 0, 0, 1]   "rad"     "45 deg"
    NUMBER              "number"              [0, 0, 0, 0]   "1"       "0.5"
    RATE                "rate"                [0, 0, -1, 0]  "1/s"     "4000 /s"
    SPEED               "speed"               [1, 0, -1, 0]  "m/s"     "5 m/s"
    ANGULAR_VELOCITY    "angular velocity"    [0, 0, -1, 1]  "rad/s"   "10 rad/s"
    ACCELERATION        "acceleration"        [1, 0, -2, 0]  "m/s^2"   "9.81 m/s^2"
    DENSITY             "density"             [-3, 1, 0, 0]  "kg/m^3"  "1000 kg/m^3"
    PRESSURE            "pressure"            [-1, 1, -2, 0] "Pa"      "100 Pa"
    SURFACE_TENSION     "surface tension"     [0, 1, -2, 0]  "N/m"     "72.7 mN/m"
    VISCOSITY           "dynamic viscosity"   [-1, 1, -1, 0] "Pa s"    "1 mPa s"
    KINEMATIC_VISCOSITY "kinematic viscosity" [2, 0, -1, 0]  "m^2/s"   "1 mm^2/s"
    FORCE               "force"               [1, 1, -2, 0]  "N"       "1 mN"
    ENERGY              "energy"              [2, 1, -2, 0]  "J"       "1 uJ"
    AREA                "area"                [2, 0, 0, 0]   "m^2"     "1 mm^2"
    VOLUME              "volume"              [3, 0, 0, 0]   "m^3"     "1 mm^3"
    TEMPERATURE         "temperature"         [0, 0, 0, 0, 1] "K"      "300 K"
    CONDUCTIVITY        "heat conductivity"   [1, 1, -3, 0, -1] "W/m/K" "0.6 W/m/K"
    SPECIFIC_HEAT       "specific heat"       [2, 0, -2, 0, -1] "J/kg/K" "188.9 J/kg/K"
    MOLAR_MASS          "molar mass"          [0, 1, 0, 0, 0, -1] "kg/mol" "44 g/mol"
    SPECIFIC_VOLUME     "specific volume"     [3, -1, 0, 0]  "m^3/kg"  "0.001 m^3/kg"
    COHESION            "cohesion"            [5, -1, -2, 0] "Pa m^6/kg^2" "188 Pa m^6/kg^2"
}

/// "a length", "an angle", or the base units of something without a name.
pub(crate) fn name_of(dimension: Dimension) -> String {
    if let Some(kind) = KINDS.iter().find(|kind| kind.dimension == dimension) {
        return with_article(kind.name);
    }
    let units: Vec<String> = ["m", "kg", "s", "rad", "K", "mol"]
        .iter()
        .zip(dimension)
        .filter(|(_, exponent)| *exponent != 0)
        .map(|(unit, exponent)| {
            if exponent == 1 {
                unit.to_string()
            } else {
                format!("{unit}^{exponent}")
            }
        })
        .collect();
    format!("in {}", units.join(" "))
}

/// "a length", "an angle".
pub(crate) fn with_article(name: &str) -> String {
    let article = if name.starts_with(['a', 'e', 'i', 'o', 'u']) {
        "an"
    } else {
        "a"
    };
    format!("{article} {name}")
}
