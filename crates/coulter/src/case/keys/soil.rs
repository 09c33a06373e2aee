//! Keys of the soil, of the box round it and of the grid.

use super::allowed_range::{
    ACUTE, ASPECT, AT_LEAST_ONE, BELOW_HALF, ECCENTRICITY, GROWTH, NOT_NEGATIVE, POSITIVE, RELATIVE_DENSITY,
    SLOPE,
};
use super::default_value::DefaultValue::{Derived, Flag, Number, Quantity, Ratios, Required, Walls, Word};
use super::key::{Key, Kind, key};
use super::usual_range::{
    AT_REST, COHESION, CRITICAL_ANGLE, DENSITY as USUAL_DENSITY, DRY_DENSITY, FRICTION_ANGLE,
    GROWTH_OF_STRENGTH, POISSON, STIFFNESS, UNDRAINED_STRENGTH, WEIGHT,
};
use super::words::{FOLLOWED, LAWS, POTENTIALS};
use crate::case::quantity::{
    ANGLE, DENSITY, DENSITY_GRADIENT, FREQUENCY, LENGTH, SPEED, STRENGTH_GRADIENT, STRESS, UNIT_WEIGHT,
};

pub(super) const SOIL: &[Key] = &[
    key("law", Kind::Choice(&LAWS), Required, "Yield law: frictional with constant angles, sand whose strength follows its density, undrained, metal plasticity, or none (elastic)."),
    key("friction_angle", Kind::Quantity(ANGLE), Derived("required for mohr-coulomb"), "Friction angle φ.").within(ACUTE).usually(FRICTION_ANGLE),
    key("dilation_angle", Kind::Quantity(ANGLE), Quantity("0 deg"), "Dilation angle ψ, at most φ (mohr-coulomb).").within(ACUTE),
    key("cohesion", Kind::Quantity(STRESS), Quantity("0 Pa"), "Cohesion c; may be exactly 0 (mohr-coulomb).").within(NOT_NEGATIVE).usually(COHESION),
    key("tension_cutoff", Kind::Quantity(STRESS), Quantity("0 Pa"), "Tension cut-off: the largest tensile stress, at most c cot φ (mohr-coulomb).").within(NOT_NEGATIVE),
    key("flow_potential", Kind::Choice(&POTENTIALS), Word("mohr-coulomb"), "Plastic flow potential: the Mohr–Coulomb pyramid with ψ in place of φ, or the smooth potential that Abaqus uses (mohr-coulomb)."),
    key("meridional_eccentricity", Kind::Number, Number(0.1), "How fast the smooth potential approaches its asymptote; has no effect without cohesion (menetrey-willam).").within(NOT_NEGATIVE),
    key("deviatoric_eccentricity", Kind::Number, Derived("(3 − sin φ)/(3 + sin φ)"), "Shape of the smooth potential in the deviatoric plane; 1 is a circle (menetrey-willam).").within(ECCENTRICITY),
    key("critical_density", Kind::Quantity(DENSITY), Derived("0.8 of the density"), "Density below which the soil no longer dilates (mohr-coulomb, with dilation_angle).").within(POSITIVE),
    key("critical_friction_angle", Kind::Quantity(ANGLE), Derived("required for sand"), "Friction angle of the critical state in triaxial compression φ_cv; about the angle of repose (sand).").within(ACUTE).usually(CRITICAL_ANGLE),
    key("minimum_density", Kind::Quantity(DENSITY), Derived("required for sand"), "Dry density in the loosest state, at e_max (sand).").within(POSITIVE).usually(DRY_DENSITY),
    key("maximum_density", Kind::Quantity(DENSITY), Derived("required for sand"), "Dry density in the densest state, at e_min (sand).").within(POSITIVE).usually(DRY_DENSITY),
    key("relative_density", Kind::RelativeDensity, Derived("from the density"), "Relative density I_D at the start, instead of `density` or `unit_weight`; below 0 for sand looser than e_max (sand).").within(RELATIVE_DENSITY),
    key("relative_density_gradient", Kind::Quantity(DENSITY_GRADIENT), Quantity("0 1/m"), "Growth of the relative density with depth, from that at the top of the soil, or of its layer; at its base it is at most 1 (sand).").within(NOT_NEGATIVE),
    key("bolton_q", Kind::Number, Number(10.0), "Bolton's Q: 10 for quartz and feldspar, 8 for limestone (sand).").within(POSITIVE),
    key("bolton_r", Kind::Number, Number(0.7), "Bolton's R: relative density of the critical state at low pressure over 1/(Q − 5) (sand).").within(NOT_NEGATIVE),
    key("reference_strain", Kind::Number, Number(0.0009), "Plastic shear strain at which half of the strength is mobilised, at I_D = 0.5 and up to 20 kPa (sand).").within(POSITIVE),
    key("compression_modulus", Kind::Quantity(STRESS), Quantity("20 MPa"), "Bulk modulus of plastic compression at I_D = 0.5 and 100 kPa (sand).").within(POSITIVE),
    key("preconsolidation_pressure", Kind::Quantity(STRESS), Quantity("0 Pa"), "Largest mean pressure that the soil has borne before: of rolled, vibrated or once deeper ground; up to it compression is elastic (sand).").within(NOT_NEGATIVE),
    key("stiffness_limit", Kind::Quantity(STRESS), Quantity("50 kPa"), "Mean pressure beyond which the elastic moduli no longer grow; it sets the time step (sand).").within(POSITIVE),
    key("characteristic_length", Kind::Quantity(LENGTH), Derived("none"), "Length over which the density that governs strength and dilatancy is averaged, so that bands of softening sand do not depend on the cells; at least two cells, some 15 grain sizes (sand).").within(POSITIVE),
    key("shear_strength", Kind::Quantity(STRESS), Derived("required for tresca"), "Undrained shear strength s_u at the top of the soil, or of its layer; 0 only if it grows with depth (tresca).").within(NOT_NEGATIVE).usually(UNDRAINED_STRENGTH),
    key("strength_gradient", Kind::Quantity(STRENGTH_GRADIENT), Quantity("0 kPa/m"), "Growth of the undrained shear strength with depth k: s_u + k z (tresca).").within(NOT_NEGATIVE).usually(GROWTH_OF_STRENGTH),
    key("sensitivity", Kind::Number, Number(1.0), "Sensitivity S_t: strength of the intact clay over that of the remoulded one; 1 for clay that keeps its strength (tresca).").within(AT_LEAST_ONE),
    key("remoulding_strain", Kind::Number, Number(20.0), "Plastic shear strain at which 95 % of the loss has happened ξ₉₅ (tresca with sensitivity).").within(POSITIVE),
    key("rate_strengthening", Kind::Number, Number(0.0), "Gain of strength per tenfold rate of shear μ; 0.05 to 0.2 is usual (tresca).").within(NOT_NEGATIVE),
    key("reference_rate", Kind::Quantity(FREQUENCY), Quantity("1e-5 Hz"), "Rate of shear, per second, at which the strength was measured (tresca with rate_strengthening).").within(POSITIVE),
    key("yield_stress", Kind::Quantity(STRESS), Derived("required for von-mises"), "Initial yield stress σ_y in uniaxial tension (von-mises).").within(POSITIVE),
    key("hardening_modulus", Kind::Quantity(STRESS), Quantity("0 Pa"), "Hardening modulus H: slope of the yield stress over the equivalent plastic strain (von-mises).").within(NOT_NEGATIVE),
    key("unit_weight", Kind::Quantity(UNIT_WEIGHT), Derived("density × gravity"), "Unit weight γ, with `[water]` the submerged one γ′; 0 for weightless soil.").within(NOT_NEGATIVE).usually(WEIGHT),
    key("density", Kind::Quantity(DENSITY), Derived("unit_weight / gravity"), "Density ρ, which gives the soil its inertia; with `[water]` the dry density.").within(POSITIVE).usually(USUAL_DENSITY),
    key("young_modulus", Kind::Quantity(STRESS), Required, "Young's modulus E; of sand that at a mean pressure of 100 kPa, for unloading and reloading.").within(POSITIVE).usually(STIFFNESS),
    key("poisson_ratio", Kind::Number, Number(0.3), "Poisson's ratio ν.").within(BELOW_HALF).usually(POISSON),
    key("k0", Kind::Number, Derived("1 − sin φ (Jaky 1944), φ_cv of sand; else ν/(1 − ν); on a slope as much more as the soil needs to rest, 1 without friction"), "Coefficient of earth pressure at rest K₀: horizontal over vertical stress at the start.").within(NOT_NEGATIVE).usually(AT_REST),
];

/// Keys of a layer: its depth, and those of a soil.
pub(super) const LAYER: &[Key] = &{
    let top =
        key("top", Kind::Quantity(LENGTH), Required, "Depth of the top of the layer below the surface.")
            .within(POSITIVE);
    let (mut keys, mut n) = ([top; SOIL.len() + 1], 0);
    while n < SOIL.len() {
        keys[n + 1] = SOIL[n];
        n += 1;
    }
    keys
};

pub(super) const GROUND: &[Key] = &[
    key("surface", Kind::Quantity(LENGTH), Quantity("0 m"), "Height of the level soil surface; of uneven ground that over which it rises and falls. Sinkages and depths count from it."),
    key("slope", Kind::Quantity(ANGLE), Quantity("0 deg"), "Angle of the slope along x, uphill positive: x and y lie in the surface, z is normal to it, and gravity is tilted.").within(SLOPE),
    key("cross_slope", Kind::Quantity(ANGLE), Quantity("0 deg"), "The same along y.").within(SLOPE),
    key(
        "x",
        Kind::Range(LENGTH),
        Derived("the whole domain"),
        "Where there is soil along x, e.g. a bank in front of a wall.",
    ),
    key("y", Kind::Range(LENGTH), Derived("the whole domain"), "Where there is soil along y."),
    key(
        "radius",
        Kind::Quantity(LENGTH),
        Derived("none"),
        "Soil only within this distance of the axis x = y = 0: a round column or bar.",
    )
    .within(POSITIVE),
    key(
        "velocity",
        Kind::Vector(SPEED),
        Derived("at rest"),
        "Initial velocity of the soil along x, y, z; along x, z in plane strain.",
    ),
    key(
        "overburden",
        Kind::Quantity(STRESS),
        Quantity("0 Pa"),
        "Vertical pressure of the lid on the soil, which must reach up to the lid: soil at depth.",
    )
    .within(NOT_NEGATIVE),
];

pub(super) const DOMAIN: &[Key] = &[
    key(
        "x",
        Kind::Range(LENGTH),
        Derived(
            "the bodies' path and 1.5 body lengths at each end, more ahead where the failing soil needs it",
        ),
        "The box along the tow; from 0 if symmetric_x.",
    ),
    key(
        "y",
        Kind::Range(LENGTH),
        Derived("the bodies and 1.5 body lengths at each side, more where the failing soil needs it"),
        "The box across the tow; from 0 if symmetric.",
    ),
    key(
        "z",
        Kind::Range(LENGTH),
        Derived(
            "1.25 body lengths of soil (1.9 where nothing is towed), 0.4 of headroom, more where the heap of soil needs it",
        ),
        "The box in height: floor and lid.",
    ),
    key("symmetric", Kind::Flag, Flag(false), "Model only y ≥ 0; y = 0 is a plane of symmetry."),
    key("symmetric_x", Kind::Flag, Flag(false), "Model only x ≥ 0; x = 0 is a plane of symmetry."),
    key(
        "plane_strain",
        Kind::Flag,
        Flag(false),
        "Model a slab that is one cell thick in y; weights, masses, loads and forces are per metre of width.",
    ),
    key(
        "x_walls",
        Kind::WallPair,
        Walls(["smooth", "smooth"]),
        "Walls at the low and the high end of x; `fixed` by default where ground.slope is given, `pressure` for none: the ground beyond bears \
         its stress at rest.",
    ),
    key(
        "y_walls",
        Kind::WallPair,
        Walls(["smooth", "smooth"]),
        "Walls at the low and the high end of y; `fixed` by default where ground.cross_slope is given, `pressure` as along x.",
    ),
    key(
        "z_walls",
        Kind::WallPair,
        Walls(["fixed", "smooth"]),
        "Floor and lid; a `pressure` lid keeps ground.overburden however the soil rises.",
    ),
];

/// Keys of what the grid follows.
pub(super) const FOLLOW: &[Key] = &[
    key("body", Kind::Text, Required, "Name of the body."),
    key("axes", Kind::Choice(&FOLLOWED), Word("x"), "Axes along which the grid follows it."),
];

pub(super) const GRID: &[Key] = &[
    key("cell", Kind::Quantity(LENGTH), Required, "Cell size h in the fine zone: the smallest width of its cells.").within(POSITIVE),
    key(
        "aspect",
        Kind::Ratios,
        Ratios([1.0, 1.0, 1.0]),
        "Widths of the cells in the fine zone along x, y and z, over `cell`; one of them is 1. `[3, 3, 1]` are flat cells, for a body that sinks much less than it is long.",
    )
    .within(ASPECT),
    key(
        "growth",
        Kind::Number,
        Number(1.12),
        "Largest ratio of the widths of neighbouring cells outside the fine zone.",
    )
    .within(GROWTH),
    key(
        "fit",
        Kind::Flag,
        Flag(true),
        "Make cells up to 1.25 times wider or narrower along an axis so that the flat faces of bodies that do not move along it coincide with cell faces.",
    ),
    key("fine_x", Kind::Range(LENGTH), Derived("the bodies' path ± 0.5 body lengths"), "Fine zone along x."),
    key("fine_y", Kind::Range(LENGTH), Derived("the bodies' path ± 0.25 body lengths"), "Fine zone along y."),
    key(
        "fine_z",
        Kind::Range(LENGTH),
        Derived(
            "0.5 body lengths below the bodies' path; 0.25 above the soil, up to 0.5 where a heap is expected",
        ),
        "Fine zone in z.",
    ),
    key(
        "follow",
        Kind::Follow,
        Derived("none: the grid stands still"),
        "A body that the grid follows: it keeps its position in the grid, undisturbed ground enters in front of it and leaves behind. The box then is the one at the start.",
    ),
];
