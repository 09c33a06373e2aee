//! D11: the light disc on three meshes that resolve its sinkage.

use crate::error::VerifyError;
use crate::runner::Runner;
use coulter::case::meshes::{RATIO, representative_width};
use coulter::history::reference::Reference;
use coulter::mesh_study::{BodyOnMesh, MeshResult, MeshRun, MeshStudy, evaluate};
use coulter::simulation::Simulation;
use coulter::trust::Trust;

const CASE: &str = include_str!("../validation/D11_three_meshes/case.toml");
const MESHES: [&str; 3] = ["coarse", "middle", "fine"];
/// The body in the case file.
const BODY: &str = "disc";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let variant = "three meshes";
    if !runner.wants("D11", variant)? {
        return Ok(());
    }
    let finest = runner.simulation(CASE, &[])?.case.grid.cell;
    let mut meshes = Vec::new();
    for (mesh, name) in MESHES.iter().enumerate() {
        let ratio = RATIO.powi(2 - mesh as i32);
        let simulation = runner.run("D11", name, CASE, &[format!("grid.cell={} m", ratio * finest)])?;
        meshes.push(Mesh::of(simulation));
    }
    let runs: Vec<MeshRun> = meshes.iter().map(Mesh::run).collect();
    let case = &meshes[2].simulation.case;
    let study = evaluate(&runs, &Reference::all(case), case.output.steady_fraction);
    for ((mesh, name), result) in meshes.iter().zip(MESHES).zip(&study.meshes) {
        mesh.put(runner, name, &result.bodies[BODY])?;
    }
    let wall_s = meshes.iter().map(|mesh| mesh.simulation.wall_s).sum();
    runner.put("D11", variant, wall_s, &indices(&study))
}

/// What the three meshes together say.
fn indices(study: &MeshStudy) -> [(&'static str, f64); 5] {
    let body = &study.bodies[BODY].figures;
    let index = |interval: Option<coulter::mesh_study::MeshInterval>| {
        interval.and_then(|interval| interval.index).unwrap_or(f64::NAN)
    };
    let extrapolated = body.get("sinkage").and_then(|interval| interval.convergence.extrapolated);
    [
        ("grid-convergence index of the drag", index(body.get("drag"))),
        ("grid-convergence index of the sinkage", index(body.get("sinkage"))),
        ("grid-convergence index of the vertical force", index(body.get("vertical"))),
        ("grid-convergence index of the turn ratio", index(body.get("turn_ratio"))),
        ("sinkage, extrapolated to h = 0 [mm]", 1e3 * extrapolated.unwrap_or(f64::NAN)),
    ]
}

/// A run on one mesh.
struct Mesh {
    simulation: Simulation,
    result: MeshResult,
    trust: Trust,
}

impl Mesh {
    fn of(simulation: Simulation) -> Self {
        let trust = simulation.trust(None);
        let result = MeshResult {
            cell_m: simulation.case.grid.cell,
            width_m: representative_width(&simulation.case),
            verdict: trust.verdict,
            ..MeshResult::default()
        };
        Self { simulation, result, trust }
    }

    fn run(&self) -> MeshRun<'_> {
        MeshRun { result: &self.result, trust: &self.trust, history: &self.simulation.history }
    }

    fn put(
        &self,
        runner: &mut Runner,
        name: &str,
        BodyOnMesh { means, drag_noise }: &BodyOnMesh,
    ) -> Result<(), VerifyError> {
        let figure = |value: Option<f64>| value.unwrap_or(f64::NAN);
        let sinkage = figure(means.get("sinkage"));
        let figures = [
            ("drag F_H [N]", figure(means.get("drag"))),
            ("sinkage [mm]", 1e3 * sinkage),
            ("turn ratio ω r / v", figure(means.get("turn_ratio"))),
            ("sinkage over the height of a cell", sinkage / self.result.cell_m),
            ("drag noise over the mean", figure(*drag_noise)),
        ];
        runner.put("D11", name, self.simulation.wall_s, &figures)
    }
}
