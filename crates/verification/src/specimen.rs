//! Soil specimens for element tests: a material point, and a cell of the solver with prescribed nodal motion.

use crate::error::VerifyError;
use glam::DVec3;
use physics::elastic::Elastic;
use physics::law::Law;
use physics::tensor::{Symmetric, deviator, mean};
use physics::yield_law::{Point as LawPoint, YieldLaw};
use solver::grid::Grid;
use solver::initial::{Filling, at_rest};
use solver::material::Material;
use solver::model::{Method, Model};
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;

/// Confining pressure of the tests [Pa].
pub(crate) const CONFINEMENT: f64 = 1e5;

/// Something that responds to a small strain with a stress.
pub(crate) trait Specimen: Sized {
    /// The stress [Pa] that a strain increment would lead to; the specimen itself does not change.
    fn response(&self, increment: Symmetric) -> Result<Symmetric, VerifyError>;
    /// Applies a strain increment.
    fn strain(&mut self, increment: Symmetric) -> Result<(), VerifyError>;
    /// The current stress [Pa].
    fn stress(&self) -> Symmetric;
}

/// A material point.
pub(crate) struct Point {
    pub(crate) elastic: Elastic,
    pub(crate) law: Law,
    pub(crate) stress: Symmetric,
}

impl Specimen for Point {
    fn response(&self, increment: Symmetric) -> Result<Symmetric, VerifyError> {
        let shear = deviator(increment).map(|d| 2.0 * self.elastic.shear * d);
        let volumetric = 3.0 * self.elastic.bulk * mean(increment);
        let trial: Symmetric =
            std::array::from_fn(|n| self.stress[n] + shear[n] + if n < 3 { volumetric } else { 0.0 });
        Ok(if self.law.may_yield(trial, &LawPoint::default()) {
            self.law.return_map(trial, &LawPoint::default()).stress
        } else {
            trial
        })
    }

    fn strain(&mut self, increment: Symmetric) -> Result<(), VerifyError> {
        self.stress = self.response(increment)?;
        Ok(())
    }

    fn stress(&self) -> Symmetric {
        self.stress
    }
}

/// One cell of the solver, full of soil, with prescribed motion of its eight nodes.
pub(crate) struct Cell {
    model: Model,
    state: State,
}

impl Cell {
    /// A cell of 1 m with an initial stress.
    pub(crate) fn new(elastic: Elastic, law: Law, stress: Symmetric) -> Self {
        let faces = || vec![0.0, 1.0];
        let material = Material { yield_law: Some(law), ..Material::linear_elastic(elastic, 1600.0) };
        let model = Model {
            // No remap during a whole test.
            method: Method { remap_displacement: 1.0, ..Method::default() },
            ..Model::bare(Grid::new([faces(), faces(), faces()]), material)
        };
        let everywhere = Filling::between(DVec3::splat(-1e9), DVec3::splat(1e9));
        let mut state = at_rest(&model, &everywhere);
        let cell = model.grid.index(0, 0, 0);
        for (field, value) in state.soil.stress.iter_mut().zip(stress) {
            field[cell] = value;
        }
        Self { model, state }
    }

    /// The state after one step in which the motion of the nodes strains the cell by `increment`.
    fn strained(&self, increment: Symmetric) -> Result<State, VerifyError> {
        let mut state = self.state.clone();
        let dt = self.model.time_step();
        let [xx, yy, zz, xy, yz, xz] = increment;
        // Symmetric displacement gradient: strain without rotation.
        let rows = [DVec3::new(xx, xy, xz), DVec3::new(xy, yy, yz), DVec3::new(xz, yz, zz)];
        for n in 0..8 {
            let at = |bit: usize| n >> bit & 1;
            let x = DVec3::new(at(0) as f64, at(1) as f64, at(2) as f64);
            let node = self.model.grid.index(at(0), at(1), at(2));
            for (velocity, row) in state.nodes.velocity.iter_mut().zip(rows) {
                velocity[node] = row.dot(x) / dt;
            }
        }
        // A separate workspace, so that this step does not affect another.
        let mut workspace = Workspace::new(&self.model, &mut state, 1);
        step(&self.model, &mut state, &mut workspace)?;
        for u in &mut state.nodes.displacement {
            u.fill(0.0);
        }
        Ok(state)
    }

    fn stress_in(&self, state: &State) -> Symmetric {
        let cell = self.model.grid.index(0, 0, 0);
        state.soil.stress.each_ref().map(|s| s[cell])
    }
}

impl Specimen for Cell {
    fn response(&self, increment: Symmetric) -> Result<Symmetric, VerifyError> {
        Ok(self.stress_in(&self.strained(increment)?))
    }

    fn strain(&mut self, increment: Symmetric) -> Result<(), VerifyError> {
        self.state = self.strained(increment)?;
        Ok(())
    }

    fn stress(&self) -> Symmetric {
        self.stress_in(&self.state)
    }
}
