//! What is usual for the keys.

use input::key::{UsualRange, usual};

pub(crate) const STIFFNESS: UsualRange = usual("50 kPa", "1 GPa", "from mud to soft rock");
pub(crate) const POISSON: UsualRange = usual(
    "0.05",
    "0.496",
    "0.1 to 0.4 drained, up to 0.49 undrained; nearer to 0.5 the time steps become short",
);
pub(crate) const WEIGHT: UsualRange =
    usual("3 kN/m^3", "26 kN/m^3", "from mud under water to gravel; under another gravity in proportion");
pub(crate) const DENSITY: UsualRange =
    usual("700 kg/m^3", "2700 kg/m^3", "from peat to gravel; beside a submerged unit weight give it");
pub(crate) const FRICTION_ANGLE: UsualRange = usual("15 deg", "50 deg", "from plastic clay to dense gravel");
pub(crate) const CRITICAL_ANGLE: UsualRange =
    usual("20 deg", "42 deg", "from glass beads to angular gravel; sands have 30 to 37 deg, Bolton 1986");
pub(crate) const COHESION: UsualRange = usual("0 kPa", "300 kPa", "up to cemented soil");
pub(crate) const UNDRAINED_STRENGTH: UsualRange = usual("50 Pa", "1 MPa", "from slurry to hard clay");
pub(crate) const GROWTH_OF_STRENGTH: UsualRange = usual("0 kPa/m", "50 kPa/m", "1 to 3 kPa/m at sea");
pub(crate) const DRY_DENSITY: UsualRange =
    usual("700 kg/m^3", "2600 kg/m^3", "from sand of shells to heavy minerals");
pub(crate) const AT_REST: UsualRange = usual("0.2", "4", "from dense sand to clay that has borne much more");
pub(crate) const SURFACE_FRICTION: UsualRange =
    usual("0", "1", "steel and rubber have 0.2 to 0.8; what lets nothing slip is \"rough\"");
pub(crate) const SPEED: UsualRange = usual("-10 m/s", "10 m/s", "gear and vehicles stay below");
pub(crate) const PERMEABILITY: UsualRange = usual("1e-12 m/s", "0.1 m/s", "from dense clay to gravel");
pub(crate) const WATER_DENSITY: UsualRange = usual("900 kg/m^3", "1300 kg/m^3", "from hot water to brine");
pub(crate) const GRAIN_DENSITY: UsualRange =
    usual("1200 kg/m^3", "5500 kg/m^3", "from plastic to heavy minerals; quartz has 2650");
pub(crate) const GRAVITY: UsualRange =
    usual("1.6 m/s^2", "2500 m/s^2", "from the Moon to a centrifuge; 0 for none");
