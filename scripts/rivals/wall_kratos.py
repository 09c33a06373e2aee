#!/usr/bin/env python3
"""The wall of B5 with phi = psi = 35 degrees in Kratos' implicit MPM, in two dimensions.

    wall_kratos.py CELLS [steps=100] [ppe=4] [dt=0.01] [NAME=VALUE ...]

CELLS over the height of the bank; steps in which it is pushed by 0.1 H; ppe particles a cell; NAME is any of
the solver's settings. Prints K_p (heave included) and the seconds of the loop as one line of JSON. From PyPI:
KratosMultiphysics and KratosMPMApplication.

Seen from the wall, which spares Kratos a contact that moves through its grid: the wall is the grid line x = 0
with rollers, and the far end pushes the bank onto it. Hencky Mohr-Coulomb needs some cohesion for its apex:
100 Pa, whose exact part of the thrust is taken off.
"""
import json
import math
import sys
import tempfile
import time
from importlib.metadata import version
from pathlib import Path

import KratosMultiphysics as KM
import KratosMultiphysics.MPMApplication as MPM
from KratosMultiphysics.MPMApplication.mpm_analysis import MpmAnalysis

PHI, HEIGHT, LENGTH, GAMMA, GRAVITY, COHESION = math.radians(35), 1.0, 4.0, 16e3, 9.81, 100.0
PUSH, REST = 0.1, 20        # REST: steps under gravity before
SLOPE = math.tan(math.pi / 4 - PHI / 2)


def block(kind, lines):
    return "\n".join([f"Begin {kind}", *lines, f"End {kind.split()[0]}", ""])


def mesh(file, h, nx, nz, element, part, sets):
    """Writes a mesh of squares in Kratos' format, with named sets of nodes."""
    node = lambda i, k: k * (nx + 1) + i + 1
    nodes = [f"{node(i, k)} {i * h:.9g} {k * h:.9g} 0" for k in range(nz + 1) for i in range(nx + 1)]
    corners = lambda i, k: f"{node(i, k)} {node(i + 1, k)} {node(i + 1, k + 1)} {node(i, k + 1)}"
    elements = [f"{k * nx + i + 1} 0 {corners(i, k)}" for k in range(nz) for i in range(nx)]
    every = lambda things: [str(n + 1) for n in range(len(things))]
    whole = block("SubModelPartNodes", every(nodes)) + block("SubModelPartElements", every(elements))
    words = block("ModelPartData", []) + block("Properties 0", []) + block("Nodes", nodes)
    words += block(f"Elements {element}", elements) + block(f"SubModelPart {part}", [whole])
    for name, members in sets(node).items():
        words += block(f"SubModelPart {name}", [block("SubModelPartNodes", map(str, members))])
    Path(file + ".mdpa").write_text(words)


def parameters(folder, cells, steps, ppe, dt, more):
    """Writes meshes and material, and returns the analysis' parameters."""
    h = HEIGHT / cells
    nx, nz, high = round(LENGTH / h), cells, round(1.5 * cells)
    mesh(f"{folder}/body", h, nx, nz, "MPMUpdatedLagrangian2D4N", "Parts_soil", lambda node: {})
    mesh(f"{folder}/grid", h, nx, high, "Element2D4N", "Parts_grid", lambda node: {
        "wall": [node(0, k) for k in range(high + 1)],
        "floor": [node(i, 0) for i in range(nx + 1)],
        "far": [node(i, k) for i in range(nx - 2, nx + 1) for k in range(high + 1)],
    })
    sand = {
        "DENSITY": GAMMA / GRAVITY, "MATERIAL_POINTS_PER_ELEMENT": ppe, "THICKNESS": 1.0,
        "YOUNG_MODULUS": 5e6, "POISSON_RATIO": 0.3, "COHESION": COHESION,
        "INTERNAL_FRICTION_ANGLE": PHI, "INTERNAL_DILATANCY_ANGLE": PHI,
    }
    law = {"constitutive_law": {"name": "HenckyMCPlasticPlaneStrain2DLaw"}, "Variables": sand, "Tables": {}}
    material = {"model_part_name": "Initial_MPM_Material.Parts_soil", "properties_id": 1, "Material": law}
    Path(folder, "material.json").write_text(json.dumps({"properties": [material]}))
    roller = lambda name, x, y: {
        "python_module": "assign_vector_variable_process", "kratos_module": "KratosMultiphysics",
        "Parameters": {
            "model_part_name": f"Background_Grid.{name}", "variable_name": "DISPLACEMENT",
            "constrained": [x, y, False], "value": [0.0, 0.0, 0.0], "interval": [0.0, "End"],
        },
    }
    gravity = {
        "python_module": "assign_gravity_to_material_point_process",
        "process_name": "AssignGravityToMaterialPointProcess",
        "kratos_module": "KratosMultiphysics.MPMApplication",
        "Parameters": {
            "model_part_name": "MPM_Material", "variable_name": "MP_VOLUME_ACCELERATION", "modulus": GRAVITY,
            "direction": [0.0, -1.0, 0.0],
        },
    }
    file = lambda name: {"input_type": "mdpa", "input_filename": f"{folder}/{name}"}
    solver = {
        "solver_type": "Quasi-static", "time_integration_method": "implicit", "analysis_type": "non_linear",
        "model_part_name": "MPM_Material", "domain_size": 2, "echo_level": 0,
        "model_import_settings": file("body"), "grid_model_import_settings": file("grid"),
        "material_import_settings": {"materials_filename": f"{folder}/material.json"},
        "problem_domain_sub_model_part_list": ["Parts_soil", "Parts_grid"],
        "processes_sub_model_part_list": ["wall", "floor", "far"], "compute_reactions": True,
        "compressible": True, "pressure_dofs": False, "max_iteration": 20,
        "linear_solver_settings": {"solver_type": "skyline_lu_factorization"},
        "convergence_criterion": "residual_criterion", "time_stepping": {"time_step": dt},
        "residual_relative_tolerance": 1e-3, "residual_absolute_tolerance": 1e-2,
        "displacement_relative_tolerance": 1e-4, "displacement_absolute_tolerance": 1e-9,
    }
    problem = {"problem_name": "wall", "parallel_type": "OpenMP", "echo_level": 0, "start_time": 0.0}
    processes = {
        "constraints_process_list": [roller("wall", True, False), roller("floor", False, True)],
        "loads_process_list": [], "list_other_processes": [], "gravity": [gravity],
    }
    whole = {"problem_data": {**problem, "end_time": dt * (REST + steps + 0.5)}, "processes": processes}
    return KM.Parameters(json.dumps({**whole, "solver_settings": {**solver, **more}}))


class Push(MpmAnalysis):
    """Moves the far end, and reads thrust and weight of the wedge fifty times on the way."""

    def __init__(self, model, settings, steps):
        super().__init__(model, settings)
        self.step, self.steps, self.factors, self.started = 0, steps, [], None

    def InitializeSolutionStep(self):
        moved = -PUSH / self.steps if self.step >= REST else 0.0
        for node in self.model["Background_Grid.far"].Nodes:
            node.Fix(KM.DISPLACEMENT_X)
            for buffer in (0, 1):       # the scheme predicts a fixed displacement from the step before
                node.SetSolutionStepValue(KM.DISPLACEMENT_X, buffer, moved)
        super().InitializeSolutionStep()

    def FinalizeSolutionStep(self):
        nodes = self.model["Background_Grid.wall"].Nodes
        thrust = abs(sum(node.GetSolutionStepValue(KM.REACTION_X) for node in nodes))
        super().FinalizeSolutionStep()
        self.step += 1
        if self.started is None:
            self.started = time.process_time()
        pushed = self.step - REST
        if pushed > 0 and pushed % max(1, self.steps // 50) == 0:
            part = self.model["MPM_Material"]
            read = lambda element, what: element.CalculateOnIntegrationPoints(what, part.ProcessInfo)[0]
            places = [(read(element, MPM.MP_COORD), read(element, MPM.MP_MASS)) for element in part.Elements]
            weight = GRAVITY * sum(mass for x, mass in places if x[1] > x[0] * SLOPE)
            sand = thrust - 2 * COHESION * HEIGHT / SLOPE
            self.factors.append((pushed * PUSH / self.steps, sand / (weight * SLOPE)))


def main():
    try:
        given = {name: json.loads(value) for name, value in (word.split("=", 1) for word in sys.argv[2:])}
        cells, steps, ppe = int(sys.argv[1]), int(given.pop("steps", 100)), int(given.pop("ppe", 4))
        dt = float(given.pop("dt", 0.01))
    except (IndexError, ValueError, TypeError):
        sys.exit("usage: wall_kratos.py CELLS [steps=100] [ppe=4] [dt=0.01] [NAME=VALUE ...]")
    KM.Logger.GetDefaultOutput().SetSeverity(KM.Logger.Severity.WARNING)
    note = ""
    with tempfile.TemporaryDirectory() as folder:
        push = Push(KM.Model(), parameters(folder, cells, steps, ppe, dt, given), steps)
        try:
            push.Run()
        except Exception as error:      # it has no convergence there; what came before counts
            note = f", stopped: {str(error).splitlines()[0][:80]}"
    loop = time.process_time() - push.started
    if not push.factors:
        sys.exit(f"wall_kratos.py: no result{note}")
    reached = push.factors[-1][0]
    late = [factor for at, factor in push.factors if at >= reached / 2]
    mean = sum(late) / len(late)
    scatter = math.sqrt(sum((factor - mean) ** 2 for factor in late) / len(late))
    setting = f"{steps} steps, {ppe} particles a cell" + "".join(f", {k} = {v}" for k, v in given.items())
    result = {"version": f"KratosMPMApplication {version('KratosMPMApplication')}", "setting": setting + note}
    print(json.dumps({**result, "factor": mean, "scatter": scatter, "pushed": reached, "loop_s": loop}))


if __name__ == "__main__":
    main()
