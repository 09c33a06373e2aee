#!/usr/bin/env python3
"""The wall of B5 with phi = psi = 35 degrees in Newton's SolverImplicitMPM, on the processor.

    wall_newton.py CELLS [dt=0.02] [ppc=2] [ny=1] [NAME=VALUE ...]

CELLS over the height of the bank; dt in seconds; ppc particles along each edge of a cell; ny cells across the
slab between smooth sides; NAME is any field of SolverImplicitMPM.Config. Prints K_p (heave included) and the
seconds of the loop as one line of JSON. From PyPI: newton and warp-lang.

Newton yields at sqrt(J2) = friction * p. In plane strain with psi = phi the cone that matches Mohr-Coulomb
has friction = 3 tan(phi) / sqrt(9 + 12 tan(phi)^2) = 0.5445 (Drucker and Prager 1952), not tan(phi).
"""
import ast
import json
import math
import sys
import time

import newton
import numpy as np
import warp as wp
from newton.solvers import SolverImplicitMPM

PHI, HEIGHT, LENGTH, GAMMA, GRAVITY = math.radians(35), 1.0, 4.0, 16e3, 9.81
PUSH, SPEED, SETTLE, RAMP = 0.1, 0.05, 0.3, 0.2
THICK = 0.5     # of the boxes that are floor, sides, far end and wall


def literal(text):
    try:
        return ast.literal_eval(text)
    except (ValueError, SyntaxError):
        return text


def main():
    try:
        given = {name: literal(value) for name, value in (word.split("=", 1) for word in sys.argv[2:])}
        h = HEIGHT / int(sys.argv[1])
        dt, ppc, ny = float(given.pop("dt", 0.02)), int(given.pop("ppc", 2)), int(given.pop("ny", 1))
    except (IndexError, ValueError, TypeError, ZeroDivisionError):
        sys.exit("usage: wall_newton.py CELLS [dt=0.02] [ppc=2] [ny=1] [NAME=VALUE ...]")
    wp.config.quiet = True
    wp.set_device("cpu")
    width, d, density = ny * h, h / ppc, GAMMA / GRAVITY

    builder = newton.ModelBuilder()
    SolverImplicitMPM.register_custom_attributes(builder)
    along = [(np.arange(round(size / d)) + 0.5) * d for size in (LENGTH, width, HEIGHT)]
    points = np.stack(np.meshgrid(*along, indexing="ij"), -1).reshape(-1, 3)
    count, mass = len(points), density * d**3
    places = [wp.vec3(*map(float, point)) for point in points]
    builder.add_particles(places, [wp.vec3(0.0)] * count, [mass] * count, [d / 2] * count)
    smooth = newton.ModelBuilder.ShapeConfig(mu=0.0)

    def box(centre, half, body=-1):
        place = wp.transform(wp.vec3(*centre), wp.quat_identity())
        builder.add_shape_box(body=body, cfg=smooth, xform=place, hx=half[0], hy=half[1], hz=half[2])

    box((LENGTH / 2, width / 2, -THICK), (LENGTH, width + 2, THICK))
    for y in (-THICK, width + THICK):
        box((LENGTH / 2, y, HEIGHT), (LENGTH, THICK, 2 * HEIGHT))
    box((LENGTH + THICK, width / 2, HEIGHT), (THICK, width + 2, 2 * HEIGHT))
    place = wp.transform(wp.vec3(-THICK, width / 2, HEIGHT), wp.quat_identity())
    wall = builder.add_body(xform=place, mass=1.0, is_kinematic=True)
    box((0, 0, 0), (THICK, width + 2, 2 * HEIGHT), wall)
    model = builder.finalize()
    model.set_gravity((0.0, 0.0, -GRAVITY))
    friction = 3 * math.tan(PHI) / math.sqrt(9 + 12 * math.tan(PHI) ** 2)
    sand = {"young_modulus": 5e6, "poisson_ratio": 0.3, "friction": friction, "dilatancy": 1.0}
    for name, value in sand.items():
        getattr(model.mpm, name).fill_(value)
    config = SolverImplicitMPM.Config()
    config.voxel_size, config.air_drag = h, 0.0
    for name, value in given.items():
        if not hasattr(config, name):
            sys.exit(f"wall_newton.py: SolverImplicitMPM.Config has no {name}")
        setattr(config, name, value)
    solver = SolverImplicitMPM(model, config=config)
    before, after = model.state(), model.state()
    wall_id = int(np.nonzero(solver.collider_body_index.numpy() == wall)[0][0])

    def put_wall(state, moved, speed):
        place, motion = state.body_q.numpy(), state.body_qd.numpy()
        place[wall][0], motion[wall] = moved - THICK, 0
        motion[wall][0] = speed
        state.body_q.assign(place)
        state.body_qd.assign(motion)

    steps, slope = round((SETTLE + RAMP / 2 + PUSH / SPEED) / dt), math.tan(math.pi / 4 - PHI / 2)
    moved, factors = 0.0, []
    for n in range(steps):
        if n == 1:      # the first step compiles kernels
            started = time.process_time()
        speed = SPEED * min(1.0, max(0.0, (n * dt - SETTLE) / RAMP))
        put_wall(before, moved, speed)
        put_wall(after, moved, speed)
        solver.step(before, after, None, None, dt)
        moved += speed * dt
        put_wall(after, moved, speed)
        solver.project_outside(after, after, dt)
        impulse, _, collider = (array.numpy() for array in solver.collect_collider_impulses(after))
        before, after = after, before
        if n % max(1, steps // 200) == 0 and moved > 0:
            # Nodes of the wall; there may be fewer colliders listed than impulses.
            on = collider[: len(impulse)] == wall_id
            thrust = -float(impulse[: len(on)][on, 0].sum()) / dt / width
            x = before.particle_q.numpy()
            above = (x[:, 2] > (x[:, 0] - moved) * slope) & (x[:, 0] > moved - h)
            weight = mass * GRAVITY / width * np.count_nonzero(above)
            factors.append((moved / HEIGHT, abs(thrust) / (weight * slope)))
    loop = time.process_time() - started
    late = np.array([factor for at, factor in factors if at >= 0.05])
    setting = [f"Δt = {1000 * dt:g} ms", f"{ppc}³ particles a cell", f"{ny} cells across"]
    setting = ", ".join(setting + [f"{name} = {value}" for name, value in given.items()])
    version = f"newton {newton.__version__}, warp {wp.__version__}"
    result = {"version": version, "setting": setting, "loop_s": loop}
    result.update(factor=float(late.mean()), scatter=float(late.std()), pushed=moved / HEIGHT)
    # Mean of the first and of the last tenths of a second in which it is averaged: whether it still rises.
    result.update(first=float(late[:10].mean()), last=float(late[-10:].mean()))
    print(json.dumps(result))


if __name__ == "__main__":
    main()
