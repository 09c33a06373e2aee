//! The key figures of element tests, as a laboratory reports them.

use super::path::{Course, PathPoint, Test, TestKind};
use case::resolved::Soil;

/// The unit in which a figure is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureUnit {
    /// A stress or a modulus [Pa].
    Stress,
    /// An angle [rad], shown in degrees.
    Angle,
    /// A strain, shown in per cent.
    Strain,
    /// A number.
    Number,
    /// A density [kg/m³].
    Density,
}

/// A key figure of a test.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyFigure {
    /// Name of the figure in documents, with its SI unit.
    pub key: &'static str,
    /// Symbol of the figure in tables; empty for one that they leave out.
    pub label: &'static str,
    /// Unit in which the figure is shown.
    pub unit: FigureUnit,
    /// Value of the figure in SI units; not-a-number where the test did not get that far.
    pub value: f64,
}

/// A secant modulus between two pressures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SecantModulus {
    /// The pressures [Pa].
    pub pressures: [f64; 2],
    /// Change of the pressure over that of the strain [Pa]; not-a-number where the test did not get that far.
    pub modulus: f64,
}

/// The key figures of a test.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KeyFigures {
    /// Secant moduli by pressure, in compression.
    pub moduli: Vec<SecantModulus>,
    /// The other key figures.
    pub list: Vec<KeyFigure>,
}

/// How far below the largest stress counts as the peak: far more than the stresses scatter, which are
/// controlled to 1e-7.
const NEAR_PEAK: f64 = 1e-5;

impl PathPoint {
    /// Axial strain over the initial height.
    #[must_use]
    pub fn axial_strain(&self) -> f64 {
        -(-self.strain).exp_m1()
    }

    /// Volumetric strain over the initial volume.
    #[must_use]
    pub fn volume_change(&self) -> f64 {
        -(-self.volumetric_strain).exp_m1()
    }

    /// Mobilised friction angle without cohesion [rad]: of the largest and the smallest stress in triaxial
    /// tests.
    #[must_use]
    pub fn mobilised_angle(&self) -> f64 {
        ((self.vertical - self.lateral) / (self.vertical + self.lateral)).asin()
    }
}

/// The key figures of a test of a soil.
#[must_use]
pub fn figures(soil: &Soil, test: &Test, course: &Course) -> KeyFigures {
    let list = match test.kind {
        TestKind::Triaxial => triaxial(soil, &course.points),
        TestKind::Shear => shear(soil, &course.points),
        TestKind::Oedometer | TestKind::Isotropic => return compression(soil, test, &course.points),
    };
    KeyFigures { moduli: Vec::new(), list }
}

fn figure(key: &'static str, label: &'static str, unit: FigureUnit, value: f64) -> KeyFigure {
    KeyFigure { key, label, unit, value }
}

/// Number of the point at which a stress first reaches its largest value.
#[must_use]
pub(super) fn peak(points: &[PathPoint], stress: impl Fn(&PathPoint) -> f64) -> usize {
    let largest = points.iter().map(&stress).fold(0.0, f64::max);
    points.iter().position(|p| stress(p) >= (1.0 - NEAR_PEAK) * largest).unwrap_or(0)
}

/// −dε_v over the strain after a point, at the last one before it.
fn dilatancy(points: &[PathPoint], at: usize) -> f64 {
    let first = at.min(points.len().saturating_sub(2));
    let rate = |[a, b]: [&PathPoint; 2]| -(b.volumetric_strain - a.volumetric_strain) / (b.strain - a.strain);
    points.get(first).zip(points.get(first + 1)).map_or(f64::NAN, |(a, b)| rate([a, b]))
}

/// Strain at which a stress first reaches a value, interpolated; not-a-number if it does not.
fn strain_at(points: &[PathPoint], stress: impl Fn(&PathPoint) -> f64, value: f64) -> f64 {
    let pair = points.windows(2).find(|pair| stress(&pair[0]) < value && stress(&pair[1]) >= value);
    pair.map_or(f64::NAN, |pair| {
        let [a, b] = [stress(&pair[0]), stress(&pair[1])];
        pair[0].strain + (value - a) / (b - a) * (pair[1].strain - pair[0].strain)
    })
}

/// Modulus at the start, and secant modulus at half of the largest stress [Pa].
fn moduli(points: &[PathPoint], stress: impl Fn(&PathPoint) -> f64, largest: f64) -> [f64; 2] {
    let initial = points.get(1).map_or(f64::NAN, |first| stress(first) / first.strain);
    [initial, 0.5 * largest / strain_at(points, stress, 0.5 * largest)]
}

/// Density at the end, and of sand the relative one.
fn densities(soil: &Soil, density: f64) -> Vec<KeyFigure> {
    let relative = soil.at_density(density).relative_density();
    let label = if relative.is_some() { "" } else { "ρ end" };
    let mut list = vec![figure("density_end_kg_m3", label, FigureUnit::Density, density)];
    list.extend(relative.map(|r| figure("relative_density_end", "I_D end", FigureUnit::Number, r)));
    list
}

fn triaxial(soil: &Soil, points: &[PathPoint]) -> Vec<KeyFigure> {
    use FigureUnit::{Angle, Number, Strain, Stress};
    let q = |point: &PathPoint| point.vertical - point.lateral;
    let at = peak(points, q);
    let (Some(top), Some(last)) = (points.get(at), points.last()) else { return Vec::new() };
    let [initial, half] = moduli(points, q, q(top));
    let dilatancy_peak = dilatancy(points, at);
    let mut list = vec![
        figure("initial_modulus_Pa", "E_i", Stress, initial),
        figure("secant_modulus_50_Pa", "E_50", Stress, half),
        figure("deviatoric_stress_peak_Pa", "", Stress, q(top)),
    ];
    let is_frictional = soil.law.friction_angle().is_some();
    if is_frictional {
        list.push(figure("friction_angle_peak_rad", "φ peak", Angle, top.mobilised_angle()));
    } else {
        list.push(figure("shear_strength_Pa", "q/2 peak", Stress, 0.5 * q(top)));
    }
    list.extend([
        figure("strain_peak", "ε₁ peak", Strain, top.axial_strain()),
        figure("dilatancy_peak", "", Number, dilatancy_peak),
        figure("dilation_angle_peak_rad", "ψ peak", Angle, (dilatancy_peak / (2.0 + dilatancy_peak)).asin()),
    ]);
    if is_frictional {
        list.push(figure("friction_angle_end_rad", "φ end", Angle, last.mobilised_angle()));
    }
    let rate = dilatancy(points, points.len());
    list.push(figure("dilatancy_end", "", Number, rate));
    list.push(figure("dilation_angle_end_rad", "ψ end", Angle, (rate / (2.0 + rate)).asin()));
    list.push(figure("volumetric_strain_end", "ε_v end", Strain, last.volume_change()));
    list.extend(densities(soil, last.density));
    list
}

fn shear(soil: &Soil, points: &[PathPoint]) -> Vec<KeyFigure> {
    use FigureUnit::{Angle, Number, Strain, Stress};
    let tau = |point: &PathPoint| point.shear;
    let at = peak(points, tau);
    let (Some(top), Some(last)) = (points.get(at), points.last()) else { return Vec::new() };
    let [initial, half] = moduli(points, tau, tau(top));
    let ratio = |point: &PathPoint| point.shear / point.vertical;
    let mut list = vec![
        figure("initial_modulus_Pa", "G_i", Stress, initial),
        figure("secant_modulus_50_Pa", "G_50", Stress, half),
        figure("shear_stress_peak_Pa", "τ peak", Stress, tau(top)),
    ];
    if soil.law.friction_angle().is_some() {
        list.extend([
            figure("stress_ratio_peak", "τ/σ_v peak", Number, ratio(top)),
            figure("friction_angle_peak_rad", "atan τ/σ_v", Angle, ratio(top).atan()),
        ]);
    }
    list.extend([
        figure("strain_peak", "γ peak", Strain, top.strain),
        figure("dilation_angle_peak_rad", "ψ peak", Angle, dilatancy(points, at).atan()),
    ]);
    if soil.law.friction_angle().is_some() {
        list.extend([
            figure("stress_ratio_end", "τ/σ_v end", Number, ratio(last)),
            figure("friction_angle_end_rad", "", Angle, ratio(last).atan()),
        ]);
    }
    list.push(figure("dilation_angle_end_rad", "ψ end", Angle, dilatancy(points, points.len()).atan()));
    list.push(figure("volumetric_strain_end", "ε_v end", Strain, last.volume_change()));
    list.extend(densities(soil, last.density));
    list
}

/// Strain of a compression test against the pressure of its kind: over the initial height or volume.
fn compressed(kind: TestKind, point: &PathPoint) -> [f64; 2] {
    match kind {
        TestKind::Isotropic => [point.pressure, point.volume_change()],
        _ => [point.vertical, point.axial_strain()],
    }
}

/// Strain at a pressure on a branch of a compression test, interpolated over the logarithm of the pressure.
fn strain_under(branch: &[[f64; 2]], pressure: f64) -> Option<f64> {
    // The first state is at the pressure but for a rounding error.
    let reaches = |p: f64| (p / pressure - 1.0).abs() < 1e-9;
    if let Some(point) = branch.iter().find(|point| reaches(point[0])) {
        return Some(point[1]);
    }
    let pair = branch.windows(2).find(|pair| (pair[0][0] - pressure) * (pair[1][0] - pressure) < 0.0)?;
    let [[p0, e0], [p1, e1]] = [pair[0], pair[1]];
    Some(e0 + (pressure / p0).ln() / (p1 / p0).ln() * (e1 - e0))
}

/// Pressures between which secant moduli are given: the start, whole decades, the end.
fn levels([start, end]: [f64; 2]) -> Vec<f64> {
    let mut levels = vec![start];
    let first = start.log10().floor() as i32 + 1;
    let decades = (first..).map(|n| 10f64.powi(n)).take_while(|p| *p < end / (1.0 + 1e-9));
    levels.extend(decades.filter(|p| *p > start * (1.0 + 1e-9)));
    levels.push(end);
    levels
}

fn compression(soil: &Soil, test: &Test, points: &[PathPoint]) -> KeyFigures {
    use FigureUnit::{Number, Strain, Stress};
    let branch = |unloads: bool| -> Vec<[f64; 2]> {
        let own = points.iter().filter(|point| point.is_unloading == unloads);
        own.map(|point| compressed(test.kind, point)).collect()
    };
    let (loading, unloading) = (branch(false), branch(true));
    let Some(top) = points.iter().rfind(|point| !point.is_unloading) else { return KeyFigures::default() };
    let [largest, strain] = compressed(test.kind, top);
    let secant = |pair: &[f64]| {
        let strain = |pressure| strain_under(&loading, pressure).unwrap_or(f64::NAN);
        let modulus = (pair[1] - pair[0]) / (strain(pair[1]) - strain(pair[0]));
        SecantModulus { pressures: [pair[0], pair[1]], modulus }
    };
    let moduli = levels([test.pressure, test.largest_pressure]).windows(2).map(secant).collect();
    // Down to a tenth: further down sand yields in extension.
    let low = (0.1 * largest).max(test.pressure);
    let unloaded = strain_under(&unloading, low).map_or(f64::NAN, |e| (largest - low) / (strain - e));
    let left = unloading.last().map_or(f64::NAN, |point| point[1]);
    let mut list = vec![figure("unloading_modulus_Pa", "unloading", Stress, unloaded)];
    list.push(figure("strain_largest", "ε largest", Strain, strain));
    list.push(figure("strain_left", "ε left", Strain, left));
    if test.kind == TestKind::Oedometer {
        list.push(figure("k0_largest", "K₀", Number, top.lateral / top.vertical));
        let back = points.last().filter(|p| p.is_unloading).map_or(f64::NAN, |p| p.lateral / p.vertical);
        list.push(figure("k0_unloaded", "K₀ unloaded", Number, back));
    }
    list.extend(densities(soil, top.density));
    KeyFigures { moduli, list }
}
