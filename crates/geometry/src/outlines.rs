//! The profiles of discs with any rim, dished discs, cones, wheels with grousers, blades and wedges.
//!
//! Where a function returns `None`, the lengths exclude each other.

use super::Profile;
use glam::DVec2;
use serde::Serialize;
use std::f64::consts::TAU;

/// The faces from which a rim or an edge is bevelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Bevel {
    /// Bevelled from both faces alike.
    Both,
    /// Bevelled from the face at the low end only: of a disc the right one (−y), of a blade the back (−x).
    Low,
    /// Bevelled from the face at the high end only: of a disc the left one (+y), of a blade the front (+x).
    High,
}

/// The rim of a disc.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DiscRim {
    /// A cylinder with two sharp edges.
    Square,
    /// Both edges rounded.
    Rounded {
        /// Radius of the rounding [m], at most half the thickness.
        radius: f64,
    },
    /// Sharpened to an edge.
    Bevelled {
        /// Angle between the bevel and the face that it cuts [rad].
        angle: f64,
        /// Thickness of the edge, along the axle [m]; 0 for a knife edge.
        edge: f64,
        /// Faces from which the rim is bevelled.
        bevel: Bevel,
    },
}

/// How a disc is dished: pressed so that its faces are caps of spheres about one centre.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Dish {
    /// Depth of the hollow below the plane of its edge [m].
    pub depth: f64,
    /// Whether the left face (+y) is hollow, or the right one.
    pub hollow_is_left: bool,
}

/// The profile of a disc in the plane of the distance from the axle and y, centred between its outermost
/// planes along y (as they are before its rim is bevelled).
///
/// The rim ends on a cylinder of this diameter. A dished disc has no rounded rim.
#[must_use]
pub fn disc(diameter: f64, thickness: f64, rim: DiscRim, dish: Option<Dish>) -> Option<Profile> {
    let (radius, half) = (0.5 * diameter, 0.5 * thickness);
    match (rim, dish) {
        (DiscRim::Rounded { radius: fillet }, None) => {
            if fillet > half || fillet > radius {
                return None;
            }
            let (inner, middle) = (radius - fillet, half - fillet);
            let profile = Profile::begin(0.0, -half)
                .line_to(inner, -half)
                .arc_to([radius, -middle], [inner, -middle], true)
                .line_to(radius, middle)
                .arc_to([inner, half], [inner, middle], true);
            Some(profile.line_to(0.0, half))
        }
        (DiscRim::Rounded { .. }, Some(_)) => None,
        (_, None) => Faces::flat(half).with_rim(radius, rim),
        (_, Some(Dish { depth, hollow_is_left })) => {
            let faces = Faces::dished(radius, thickness, depth)?;
            // Drawn with the hollow at the high end.
            let rim = if hollow_is_left { rim } else { turned_over(rim) };
            let profile = faces.with_rim(radius, rim)?;
            Some(if hollow_is_left { profile } else { profile.mirrored() })
        }
    }
}

/// A rim with the faces exchanged.
fn turned_over(rim: DiscRim) -> DiscRim {
    match rim {
        DiscRim::Bevelled { angle, edge, bevel } => {
            let bevel = match bevel {
                Bevel::Both => Bevel::Both,
                Bevel::Low => Bevel::High,
                Bevel::High => Bevel::Low,
            };
            DiscRim::Bevelled { angle, edge, bevel }
        }
        rim => rim,
    }
}

/// The two faces of a disc: level, or arcs about a centre on the axle.
struct Faces {
    /// Heights at which the faces meet the axle [m].
    at_axle: [f64; 2],
    /// Height of the common centre of the arcs [m]; `None` for level faces.
    centre: Option<f64>,
}

impl Faces {
    fn flat(half: f64) -> Self {
        Self { at_axle: [-half, half], centre: None }
    }

    /// The faces of a dished disc, the high one hollow.
    fn dished(radius: f64, thickness: f64, depth: f64) -> Option<Self> {
        // A hollow deeper than a hemisphere would have its widest place inside.
        if depth >= radius {
            return None;
        }
        let sphere = (radius * radius + depth * depth) / (2.0 * depth);
        let bottom = 0.5 * (thickness - depth);
        Some(Self { at_axle: [bottom - thickness, bottom], centre: Some(bottom + sphere) })
    }

    /// Radius of the arc of a face [m].
    fn sphere(&self, face: usize, centre: f64) -> f64 {
        centre - self.at_axle[face]
    }

    /// Height of a face at a radius [m], and its slope [rad].
    fn at(&self, face: usize, radius: f64) -> (f64, f64) {
        self.centre.map_or((self.at_axle[face], 0.0), |centre| {
            let slope = (radius / self.sphere(face, centre)).asin();
            (centre - self.sphere(face, centre) * slope.cos(), slope)
        })
    }

    /// Where a bevel that begins at a point of the rim and makes an angle [rad] with a face ends on that
    /// face.
    fn bevel_end(&self, face: usize, from: DVec2, angle: f64) -> Option<DVec2> {
        let (height, slope) = self.at(face, from.x);
        // Towards the axle, and to the face.
        let turn = if face == 0 { slope + angle } else { slope - angle };
        let along = -DVec2::from_angle(turn);
        let distance = match self.centre {
            None => (height - from.y) / along.y,
            Some(centre) => {
                let arm = from - DVec2::new(0.0, centre);
                let middle = -arm.dot(along);
                let power = arm.length_squared() - self.sphere(face, centre).powi(2);
                let chord = (middle * middle - power).sqrt();
                if face == 0 { middle + chord } else { middle - chord }
            }
        };
        let end = from + distance * along;
        // Also if it is no number.
        (end.x > 0.0 && end.x < from.x).then_some(end)
    }

    /// The profile with a square or a bevelled rim.
    fn with_rim(&self, radius: f64, rim: DiscRim) -> Option<Profile> {
        let [low, high] = [0, 1].map(|face| DVec2::new(radius, self.at(face, radius).0));
        let chain = match rim {
            DiscRim::Bevelled { angle, edge, bevel } => {
                if edge >= high.y - low.y {
                    return None;
                }
                let middle = 0.5 * (low.y + high.y);
                let tips = match bevel {
                    Bevel::Both => [middle - 0.5 * edge, middle + 0.5 * edge],
                    Bevel::Low => [high.y - edge, high.y],
                    Bevel::High => [low.y, low.y + edge],
                };
                let [one, other] = tips.map(|v| DVec2::new(radius, v));
                let first = if bevel == Bevel::High { low } else { self.bevel_end(0, one, angle)? };
                let last = if bevel == Bevel::Low { high } else { self.bevel_end(1, other, angle)? };
                [first, one, other, last]
            }
            _ => [low, low, high, high],
        };
        let begin = Profile::begin(0.0, self.at_axle[0]);
        let face = |profile: Profile, [u, v]: [f64; 2], outwards: bool| match self.centre {
            None => profile.line_to(u, v),
            Some(centre) => profile.arc_to([u, v], [0.0, centre], outwards),
        };
        let mut profile = face(begin, chain[0].to_array(), true);
        for x in chain {
            profile = profile.line_to(x.x, x.y);
        }
        Some(face(profile, [0.0, self.at_axle[1]], false))
    }
}

/// The profile of a cone on a shaft, in the plane of the distance from the axis and z, its tip down, centred
/// between tip and top.
///
/// `apex` is the angle at the tip [rad], `length` that of cone and shaft together [m].
#[must_use]
pub fn cone(diameter: f64, apex: f64, shaft: f64, length: f64) -> Option<Profile> {
    let height = 0.5 * diameter / (0.5 * apex).tan();
    if shaft > diameter || height >= length {
        return None;
    }
    let (tip, top) = (-0.5 * length, 0.5 * length);
    let profile = Profile::begin(0.0, tip).line_to(0.5 * diameter, tip + height);
    Some(profile.line_to(0.5 * shaft, tip + height).line_to(0.5 * shaft, top).line_to(0.0, top))
}

/// The grousers of a wheel: bars of rectangular cross-section across its whole width.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Grousers {
    /// Number of grousers, evenly spaced; one of them points straight down.
    pub number: u32,
    /// How far grousers stand out from the rim [m].
    pub height: f64,
    /// Thickness of a grouser along the rim [m].
    pub thickness: f64,
}

/// The profile of a wheel in the plane of x and z, centred on its axle; `diameter` is that of the rim between
/// the grousers [m].
#[must_use]
pub fn wheel(diameter: f64, grousers: Grousers) -> Option<Profile> {
    /// More would be a wheel with teeth, and a long profile.
    const MOST: u32 = 360;
    if !(1..=MOST).contains(&grousers.number) {
        return None;
    }
    let (radius, half) = (0.5 * diameter, 0.5 * grousers.thickness);
    let pitch = TAU / f64::from(grousers.number);
    // Half the angle that a grouser takes of the rim; not a number where it is wider than the wheel.
    let foot = (half / radius).asin();
    if foot.is_nan() || 2.0 * foot >= pitch * (1.0 - 1e-9) {
        return None;
    }
    let at = |n: u32, x: DVec2| DVec2::from_angle(pitch * f64::from(n) - 0.25 * TAU).rotate(x);
    let base = radius * foot.cos();
    let corners =
        [[base, -half], [radius + grousers.height, -half], [radius + grousers.height, half], [base, half]];
    let corner = |n: u32, k: usize| at(n % grousers.number, DVec2::from(corners[k]));
    let begin = corner(0, 0);
    let mut profile = Profile::begin(begin.x, begin.y);
    for n in 0..grousers.number {
        for k in 1..4 {
            let x = corner(n, k);
            profile = profile.line_to(x.x, x.y);
        }
        profile = profile.arc_to(corner(n + 1, 0).to_array(), [0.0; 2], true);
    }
    Some(profile)
}

/// The profile of an upright blade in the plane of x and z, centred on the box round it, with its lower end
/// bevelled at an angle [rad] to its faces down to an edge of this thickness [m], or square.
#[must_use]
pub fn blade([thickness, height]: [f64; 2], sharpened: Option<(f64, f64, Bevel)>) -> Option<Profile> {
    let (half, bottom) = (0.5 * thickness, -0.5 * height);
    let (mut back, mut front) = ([[-half, bottom]; 2], [[half, bottom]; 2]);
    if let Some((angle, edge, bevel)) = sharpened {
        let spare = thickness - edge;
        let (behind, ahead) = match bevel {
            Bevel::Both => (0.5 * spare, 0.5 * spare),
            Bevel::Low => (spare, 0.0),
            Bevel::High => (0.0, spare),
        };
        let rise = behind.max(ahead) / angle.tan();
        if spare <= 0.0 || rise >= height {
            return None;
        }
        if behind > 0.0 {
            back = [[-half, bottom + rise], [behind - half, bottom]];
        }
        if ahead > 0.0 {
            front = [[half - ahead, bottom], [half, bottom + rise]];
        }
        if edge == 0.0 {
            // One point, not two that rounding sets apart.
            front[0] = back[1];
        }
    }
    let top = 0.5 * height;
    let corners = [back[1], front[0], front[1], [half, top], [-half, top], back[0], back[1]];
    let begin = Profile::begin(back[1][0], back[1][1]);
    Some(corners.iter().fold(begin, |profile, [x, z]| profile.line_to(*x, *z)))
}

/// The profile of a wedge in the plane of x and z, a right-angled triangle centred on the box round it: its
/// edge at the bottom in front (+x), its base level, its back upright.
#[must_use]
pub fn wedge(length: f64, height: f64) -> Profile {
    let (x, z) = (0.5 * length, 0.5 * height);
    Profile::begin(-x, -z).line_to(x, -z).line_to(-x, z).line_to(-x, -z)
}
