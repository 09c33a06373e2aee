//! A point of soil that is strained, and of which a stress may be held.

use physics::elastic::Elastic;
use physics::law::Law;
use physics::tensor::{Symmetric, deviator, mean};
use physics::yield_law::{Memory, Point, YieldLaw};
use solver::material::Material;

/// A stress that is held while the specimen is strained, and the strain that is free for that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Number of the stress among xx, yy, zz, xy, yz, xz.
    pub component: usize,
    /// Value of the stress that is held [Pa], not 0.
    pub stress: f64,
    /// Direction of the free strain.
    pub direction: Symmetric,
}

/// A specimen of soil without weight, uniformly strained.
#[derive(Clone, Copy, Debug)]
pub struct Specimen {
    material: Material,
    point: Point,
    /// Stress-free volumetric opening.
    gap: f64,
    /// Strain since the start, tension positive: xx, yy, zz, xy, yz, xz.
    pub strain: Symmetric,
}

impl Specimen {
    /// A specimen under a stress [Pa], at a density [kg/m³]; its memory is that of the stress.
    #[must_use]
    pub fn new(material: Material, stress: Symmetric, density: f64) -> Self {
        let memory = Memory {
            stress_ratio: 0.0,
            preconsolidation: (-mean(stress)).max(material.preconsolidation),
            intact_strength: material.strength.map_or(0.0, |profile| profile.at_top),
            ..Memory::default()
        };
        let point = Point { stress, density, memory, duration: f64::INFINITY, ..Point::default() };
        Self { material, point, gap: 0.0, strain: [0.0; 6] }
    }

    /// Stress [Pa].
    #[must_use]
    pub fn stress(&self) -> Symmetric {
        self.point.stress
    }

    /// Elastic modulus of constrained compression [Pa] under the present pressure.
    #[must_use]
    pub fn constrained_modulus(&self) -> f64 {
        self.moduli(self.point.stress).constrained()
    }

    /// Density [kg/m³].
    #[must_use]
    pub fn density(&self) -> f64 {
        self.point.density
    }

    /// The specimen after a small strain increment: the step of the solver, at a point.
    #[must_use]
    pub fn strained(mut self, increment: Symmetric) -> Self {
        let old = self.point.stress;
        let elastic = self.moduli(old);
        let volume = 3.0 * mean(increment);
        self.point.density *= (-volume).exp();
        for (sum, own) in self.strain.iter_mut().zip(increment) {
            *sum += own;
        }
        // A gap closes before pressure builds up.
        let open = self.gap + volume;
        if self.gap > 0.0 && open > 0.0 {
            (self.gap, self.point.stress) = (open, [0.0; 6]);
            return self;
        }
        let strained_volume = if self.gap > 0.0 { open } else { volume };
        self.gap = 0.0;
        let shear = deviator(increment);
        let trial = std::array::from_fn(|n| {
            old[n] + 2.0 * elastic.shear * shear[n] + if n < 3 { elastic.bulk * strained_volume } else { 0.0 }
        });
        self.point.is_critical =
            self.material.critical_density.is_some_and(|least| self.point.density < least);
        self.point.stress = trial;
        if let Some(law) = self.material.yield_law {
            let before = Point { stress: old, ..self.point };
            if law.may_yield(trial, &before) {
                let back = law.return_map(trial, &before);
                self.point.stress = back.stress;
                self.point.plastic_strain += back.plastic_strain;
                self.gap += back.gap_strain;
                if matches!(law, Law::Sand(_)) {
                    self.point.memory = back.memory;
                }
            }
        }
        self
    }

    fn moduli(&self, stress: Symmetric) -> Elastic {
        let elastic = self.material.elastic;
        self.material.stiffening().map_or(elastic, |stiffening| stiffening.moduli(elastic, -mean(stress)))
    }

    /// The specimen after a small strain increment of which a portion is free, so that a stress is held;
    /// `None` where no such strain was found: the specimen fails.
    #[must_use]
    pub fn strained_under(&self, increment: Symmetric, held: &Held) -> Option<Self> {
        let moved = |strain: f64| {
            let step = std::array::from_fn(|n| increment[n] + strain * held.direction[n]);
            let specimen = self.strained(step);
            (specimen.stress()[held.component] - held.stress, specimen)
        };
        let tolerance = TOLERANCE * held.stress.abs();
        let first = moved(0.0);
        if first.0.abs() <= tolerance {
            return Some(first.1);
        }
        let (mut low, mut high) = bracket(first.0, self.constrained_modulus(), |strain| moved(strain).0)?;
        // Regula falsi, in which an end that stays counts half (Dowell and Jarratt 1971).
        for _ in 0..MOST_ITERATIONS {
            let between = (low[0] * high[1] - high[0] * low[1]) / (high[1] - low[1]);
            let (residual, specimen) = moved(between);
            if residual.abs() <= tolerance {
                return Some(specimen);
            }
            if (residual > 0.0) == (high[1] > 0.0) {
                high = [between, residual];
                low[1] *= 0.5;
            } else {
                low = high;
                high = [between, residual];
            }
        }
        None
    }
}

/// Two strains between which a residual [Pa] changes its sign, each with its residual. The search begins at
/// no strain, where the residual is `first`, with a step that a modulus [Pa] asks for. `None` if there are
/// none.
fn bracket(first: f64, modulus: f64, residual: impl Fn(f64) -> f64) -> Option<([f64; 2], [f64; 2])> {
    let mut last = [0.0, first];
    let mut step = -first / modulus;
    for _ in 0..MOST_EXTENSIONS {
        let strain = last[0] + step;
        let next = [strain, residual(strain)];
        if (next[1] > 0.0) != (first > 0.0) {
            return Some((last, next));
        }
        last = next;
        step *= EXTENSION;
    }
    None
}

/// Largest difference between a held stress and its value, over this.
const TOLERANCE: f64 = 1e-7;
const MOST_ITERATIONS: usize = 200;
/// Growth of the steps of the search.
const EXTENSION: f64 = 1.5;
const MOST_EXTENSIONS: usize = 40;
