#!/usr/bin/env python3
"""Runs random valid cases and asks whether their grades can be believed.

Every case is drawn within the documented ranges of the case file, on a coarse grid: half of them anything goes, half of
them resolved as a careful user would. Bodies are discs, blocks, cylinders, spheres, cones, wedges and meshes (boxes and prisms
in STL files beside the case, text or binary), towed, pressed, loaded or dropped, in one go or in stages, some by a joint
to a frame or to a second body; the ground is of every law, some of it in layers, on a slope or furrowed.

None may panic, hang or end otherwise than docs/reference/reliability.md says. For every run that is graded good this script looks
for itself, in the CSV files, at motion, energy balance and leak. The first graded good are run again on cells of two
thirds the size: the drag of a towed body, the sinkage of a loaded or dropped one, the vertical force of any other, must be within
25 % in nine of ten. With --changes all good and doubtful ones are, and a table says by how much their answers move, over the least
number of cells across the body, its contact chord and its sinkage.

At the end a table says for each shape, and for each kind of ground and motion, how many were good, doubtful and broken,
and which checks broke them: of the sample alone, without the careful ones that are drawn to make up the good ones.

    random_cases.py path/to/coulter [--count 500] [--finer 60] [--seed 1] [--jobs 2] [--short] [--changes] [--keep DIR]

With --keep every outcome is written down as soon as it is known; given again, the same command continues from there, as
long as the program is the same to the byte.

Exits with 1 if a promise is broken. Python 3, standard library only.
"""

import argparse
import csv
import hashlib
import json
import math
import random
import shutil
import struct
import subprocess
import sys
import tempfile
import threading
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

TIME_LIMIT = 240  # seconds for one run; the longest takes a quarter of it on an idle core
WORK_LIMIT = 1e8  # cell-steps above which a case is drawn again
GRAVITY = 9.81

# How often each is drawn.
LAWS = {"mohr-coulomb": 52, "sand": 28, "tresca": 15, "von-mises": 3, "elastic": 2}
SHAPES = {"disc": 16, "block": 14, "cylinder": 14, "sphere": 10, "cone": 14, "wedge": 14, "mesh": 18}
KINDS = {"held": 36, "free": 22, "pressed": 18, "loaded": 9, "dropped": 5, "staged": 16}
KINDS_OF_CONE = {"pressed": 60, "loaded": 25, "dropped": 5, "staged": 16}

UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048}


def si(value, unit):
    return f'"{value:.6g} {unit}"'


def one_of(draw, weights):
    return draw.choices(list(weights), list(weights.values()))[0]


def point(x, z):
    return f"[{si(x, 'm')}, \"0 m\", {si(z, 'm')}]"


def prism(outline, low, high, upright):
    """The triangles of a prism over a convex outline in x and z, along y from low to high; an upright one is over an
    outline in x and y, along z. Both outlines go round so that the triangles face outwards."""
    n = len(outline)
    base, top = ([(u, v, w) if upright else (u, w, v) for u, v in outline] for w in (low, high))
    triangles = []
    for i in range(n):
        j = (i + 1) % n
        triangles += [(base[i], base[j], top[j]), (base[i], top[j], top[i])]
    for i in range(1, n - 1):
        triangles += [(base[0], base[i + 1], base[i]), (top[0], top[i], top[i + 1])]
    return triangles if upright else [(a, c, b) for a, b, c in triangles]


def normal(a, b, c):
    (x, y, z), (u, v, w) = ([q - p for p, q in zip(a, other)] for other in (b, c))
    across = (y * w - z * v, z * u - x * w, x * v - y * u)
    length = math.hypot(*across)
    return [component / length for component in across]


def stl(triangles, binary, header):
    """An STL file, as bytes."""
    if binary:
        faces = (struct.pack("<12fH", *normal(*t), *(c for corner in t for c in corner), 0) for t in triangles)
        return f"{header:80.80}".encode() + struct.pack("<I", len(triangles)) + b"".join(faces)
    lines = [f"solid {header}"]
    for t in triangles:
        lines += ["facet normal {:.6g} {:.6g} {:.6g}".format(*normal(*t)), " outer loop"]
        lines += ["  vertex {:.8g} {:.8g} {:.8g}".format(*corner) for corner in t]
        lines += [" endloop", "endfacet"]
    return "\n".join([*lines, "endsolid", ""]).encode()


class Case:
    """A case as a tree of TOML values, with the few numbers that the checks need."""

    def __init__(self, draw, careful=False):
        self.draw = draw
        self.careful = careful or draw.random() < 0.6
        self.scale = 10 ** draw.uniform(-1.3, 0.0)
        self.soils, self.files, self.features = [], {}, []
        self.sections = {"soil": self.soil()}
        self.law, self.gamma = self.soils[0]["law"], self.soils[0]["gamma"]
        self.features.append(f"law {self.law}")
        self.body()
        self.layers()
        self.slope()
        self.furrows()
        self.motion()
        self.joint()
        if not self.careful and draw.random() < 0.3:
            self.numerics()
        self.sections["output"] = {"field_interval": '"1 h"'}

    def soil(self):
        """The keys of a soil; what else must be known of it is kept in `soils`."""
        draw, soil = self.draw, {}
        law = one_of(draw, LAWS)
        known = {"law": law, "phi": 0.0, "strength": 0.0}
        soil["law"] = f'"{law}"'
        known["gamma"] = self.sand(soil) if law == "sand" else draw.uniform(8e3, 20e3)
        stiffness = 10 ** (draw.uniform(2.0, 2.8) if self.careful else draw.uniform(1.5, 3.2))
        stiffness *= known["gamma"] * self.scale
        if law == "sand":
            known["phi"] = draw.uniform(28, 38) if self.careful else draw.uniform(20, 42)
            soil["critical_friction_angle"] = si(known["phi"], "deg")
            # Its stiffness grows with the root of the pressure up to this one; Young's modulus is that at 100 kPa.
            limit = known["gamma"] * self.scale * draw.uniform(2, 10)
            soil["stiffness_limit"] = si(limit, "Pa")
            stiffness *= 3 * math.sqrt(1e5 / limit)
        else:
            soil["unit_weight"] = si(known["gamma"], "N/m^3")
        if law == "mohr-coulomb":
            known["phi"] = draw.uniform(15, 42) if self.careful else draw.uniform(0.5, 60)
            soil["friction_angle"] = si(known["phi"], "deg")
            if draw.random() < (0.15 if self.careful else 0.5):
                soil["dilation_angle"] = si(known["phi"] * draw.random(), "deg")
            if draw.random() < 0.25:
                soil["cohesion"] = si(10 ** draw.uniform(1, 4), "Pa")
        elif law == "tresca":
            known["strength"] = 10 ** draw.uniform(3, 4)
            soil["shear_strength"] = si(known["strength"], "Pa")
        elif law == "von-mises":
            stress = 10 ** draw.uniform(3, 4.5)
            known["strength"] = stress / math.sqrt(3)
            soil["yield_stress"] = si(stress, "Pa")
        soil["young_modulus"] = si(stiffness, "Pa")
        soil["poisson_ratio"] = f"{draw.uniform(0.05, 0.45) if draw.random() < 0.5 else 0.3:.3g}"
        self.soils.append(known)
        return soil

    def sand(self, soil):
        """The densities of a sand, and its unit weight."""
        draw = self.draw
        least = draw.uniform(1200, 1600)
        most = least * draw.uniform(1.15, 1.3)
        words = {'"very loose"': 0.1, '"loose"': 0.25, '"medium dense"': 0.5, '"dense"': 0.75, '"very dense"': 0.9}
        if draw.random() < 0.3:
            told, density = draw.choice(list(words.items()))
        else:
            density = draw.uniform(0.1, 0.95) if self.careful else draw.uniform(-0.3, 1.15)
            told = f"{density:.3g}"
        soil["minimum_density"], soil["maximum_density"] = si(least, "kg/m^3"), si(most, "kg/m^3")
        soil["relative_density"] = told
        return GRAVITY * least * most / (most - density * (most - least))

    def body(self):
        draw, body, scale = self.draw, {}, self.scale
        self.shape = shape = one_of(draw, SHAPES)
        self.plane_strain = shape not in ("sphere", "cone", "mesh") and draw.random() < (0.6 if self.careful else 0.3)
        self.symmetric = not self.plane_strain and draw.random() < 0.8
        self.symmetric_x = shape == "cone" and self.symmetric and draw.random() < 0.85
        self.diameter, self.turns = None, False
        # Height, length along the tow, and what the cells are counted across.
        self.height = self.length = scale
        body["shape"] = f'"{shape}"'
        narrow = {"block": self.block, "wedge": self.wedge, "mesh": self.mesh, "cone": self.cone}.get(shape, self.round)(body)
        cells = draw.uniform(7, 12) if self.careful else draw.uniform(2.1, 7)
        if self.plane_strain and self.careful:
            cells *= 1.5
        self.cell = narrow / cells
        body["friction"] = draw.choice([f"{draw.uniform(0, 0.8):.3g}", f"{draw.uniform(0.1, 0.6):.3g}", '"rough"'])
        self.sections["body.thing"] = body
        self.sections["grid"] = {"cell": si(self.cell, "m")}
        self.sections["domain"] = {}
        for key in ("plane_strain", "symmetric", "symmetric_x"):
            if getattr(self, key):
                self.sections["domain"][key] = "true"
        if not (self.plane_strain or self.symmetric):
            body["yaw"], body["tilt"] = si(draw.uniform(-60, 60), "deg"), si(draw.uniform(-30, 30), "deg")

    def block(self, body):
        draw, scale = self.draw, self.scale
        size = [scale * draw.uniform(0.4, 1.5), scale * draw.uniform(0.35, 1.5), scale]
        edges = [size[0], size[2]] if self.plane_strain else size
        body["size"] = "[" + ", ".join(si(e, "m") for e in edges) + "]"
        self.length = size[0]
        self.pitch(body)
        return min(edges)

    def wedge(self, body):
        draw, scale = self.draw, self.scale
        self.length, width = scale * draw.uniform(0.7, 2.5), scale * draw.uniform(0.35, 1.5)
        body["length"], body["height"] = si(self.length, "m"), si(scale, "m")
        if self.plane_strain:
            return min(self.length, scale)
        body["width"] = si(width, "m")
        return min(self.length, width, scale)

    def cone(self, body):
        draw, scale = self.draw, self.scale
        angle = draw.choice([30, 60, 60, 90, draw.uniform(35, 150)])
        tip = 0.5 * scale / math.tan(math.radians(angle / 2))
        self.height = tip + scale * (draw.uniform(0.3, 1.2) if self.careful else draw.uniform(0.1, 2.5))
        body["diameter"], body["cone_angle"], body["length"] = si(scale, "m"), si(angle, "deg"), si(self.height, "m")
        if draw.random() < 0.75:
            return scale
        shaft = scale * draw.uniform(0.6, 1)
        body["shaft_diameter"] = si(shaft, "m")
        return shaft

    def round(self, body):
        """A disc, a cylinder or a sphere."""
        draw, scale = self.draw, self.scale
        slender = draw.uniform(0.35, 1.5)
        body["diameter"] = si(scale, "m")
        self.diameter, self.turns = scale, True
        if self.plane_strain:
            if self.shape == "cylinder":
                body["axis"] = '"y"'
            return scale
        if self.shape == "disc":
            body["thickness"] = si(scale * slender, "m")
        elif self.shape == "cylinder":
            axis = draw.choice("xyz")
            body["axis"], body["length"] = f'"{axis}"', si(scale * slender, "m")
            self.turns = axis == "y"
            self.height = scale * slender if axis == "z" else scale
            self.length = scale * slender if axis == "x" else scale
        return scale if self.shape == "sphere" else min(scale, scale * slender)

    def mesh(self, body):
        """A box, a keel or a regular prism in an STL file, whose name follows from its content."""
        draw, scale = self.draw, self.scale
        upright = draw.random() < 0.3
        form = draw.choice(["box", "keel", "regular"])
        if form == "regular":
            n, turned = draw.choice([3, 4, 5, 6, 8]), draw.choice([0, 1])
            # An upright prism has a corner or a face in front, one that lies has it at the bottom.
            angles = [2 * math.pi * (k + 0.5 * turned) / n - (0 if upright else math.pi / 2) for k in range(n)]
            outline = [(0.5 * scale * math.cos(a), 0.5 * scale * math.sin(a)) for a in angles]
            narrow = scale * math.cos(math.pi / n)
        else:
            length = scale * draw.uniform(0.5, 1.5)
            front, low = 0.5 * length, 0.5 * scale
            back = front * (1 if form == "box" else draw.uniform(0.4, 1))
            outline = [(-back, -low), (front, -low), (front, low), (-front, low)]
            if upright:
                # Its own mirror image in y = 0.
                outline = [(-front, -low * back / front), (front, -low), (front, low), (-front, low * back / front)]
            narrow = min(front + back, scale * back / front)
        width = scale * draw.uniform(0.4, 1.5)
        triangles = prism(outline, -0.5 * width, 0.5 * width, upright)
        low, high = zip(*((min(values), max(values)) for values in zip(*(corner for t in triangles for corner in t))))
        self.length, self.height = high[0] - low[0], high[2] - low[2]
        unit, binary = draw.choice(list(UNITS)), draw.random() < 0.5
        told = draw.random() < 0.3
        scaled = [tuple(tuple(round(c / UNITS[unit], 9) for c in corner) for corner in t) for t in triangles]
        content = stl(scaled, binary, f"thing UNITS={unit}" if told else "thing")
        name = f"thing-{hashlib.sha256(content).hexdigest()[:12]}.stl"
        self.files[name] = content
        body["file"] = f'"{name}"'
        if not told or draw.random() < 0.5:
            body["unit"] = f'"{unit}"'
        self.pitch(body)
        return min(narrow, width)

    def pitch(self, body):
        if self.draw.random() < 0.2:
            body["pitch"] = si(self.draw.uniform(-60, 60), "deg")

    def layers(self):
        """One or two further soils under the first."""
        draw, top = self.draw, 0
        if draw.random() < 0.2:
            for name in draw.choice([["lower"], ["middle", "lower"]]):
                top += self.scale * draw.uniform(0.2, 0.7)
                self.sections[f"layer.{name}"] = {"top": si(top, "m"), **self.soil()}
            self.features.append("layers")

    def repose(self, depth):
        """The steepest slope on which all soils down to this depth rest [deg], at most 40."""
        pressure = depth * max(soil["gamma"] for soil in self.soils)
        angles = [40.0]
        for soil in self.soils:
            if soil["phi"]:
                angles.append(soil["phi"])
            elif soil["strength"]:
                angles.append(math.degrees(math.asin(min(0.64, soil["strength"] / pressure))))
        return min(angles)

    def slope(self):
        draw = self.draw
        if self.symmetric_x or draw.random() > 0.15:
            return
        steepest = self.repose(4 * self.scale) * (0.6 if self.careful else 0.9)
        angle = draw.choice([-1, 1]) * draw.uniform(0.1, 1) * steepest
        key = "slope" if self.plane_strain or self.symmetric or draw.random() < 0.5 else "cross_slope"
        self.sections["ground"] = {key: si(angle, "deg")}
        self.features.append("slope")

    def furrows(self):
        """Furrows, with their height over the mean level in `crest`."""
        draw, self.crest = self.draw, 0
        if draw.random() > 0.15:
            return
        spacing = max(self.scale * draw.uniform(0.8, 3), self.cell * (8 if self.careful else 2.2))
        # So that half of it is written exactly.
        spacing = 2 * float(f"{0.5 * spacing:.5g}")
        angle = self.repose(self.scale) * draw.uniform(0.1, 0.8 if self.careful else 1.3)
        section = draw.choice(["sinusoidal", "triangular"])
        slope = math.tan(math.radians(angle)) / (math.pi if section == "sinusoidal" else 2)
        depth = min(spacing * slope, 0.4 * self.scale)
        offset = draw.choice([0, 0.5]) if self.symmetric_x else draw.random()
        if self.plane_strain:
            direction = 90
        elif self.symmetric:
            direction = draw.choice([0, 90])
            offset = offset if direction == 90 else draw.choice([0, 0.5])
        else:
            direction = draw.uniform(0, 90)
        self.sections["furrows"] = {
            "spacing": si(spacing, "m"),
            "depth": si(depth, "m"),
            "direction": si(direction, "deg"),
            "offset": si(spacing * offset, "m"),
            "section": f'"{section}"',
        }
        self.crest = 0.5 * depth
        self.features.append("furrows")

    def motion(self):
        draw, body = self.draw, self.sections["body.thing"]
        # Speeds as multiples of that at which inertia matters.
        speed = math.sqrt(GRAVITY * self.scale) * (draw.uniform(0.05, 0.15) if self.careful else 10 ** draw.uniform(-1.3, 0.3))
        ramp = draw.uniform(0.1, 0.3) * self.scale / speed
        self.kind = one_of(draw, KINDS_OF_CONE if self.shape == "cone" else KINDS)
        self.features.append(self.kind)
        self.towed = self.kind in ("held", "free")
        self.travel, run = 0, {}
        sinkage = 0 if self.careful or draw.random() < 0.5 else self.crest
        sinkage -= self.crest
        if self.kind == "held":
            depth = draw.uniform(0.4, 0.9) if self.careful else draw.uniform(0.0, 1.1)
            sinkage = depth * self.height
        elif self.kind == "dropped":
            sinkage -= draw.uniform(0.05, 1.0) * self.scale
        if sinkage:
            body["sinkage"] = si(sinkage, "m")
        if self.kind in ("free", "loaded", "dropped"):
            self.weigh(body)
            body["heave"] = f"{{ load = \"0 N\", ramp = {si(ramp, 's')} }}"
        if self.towed:
            start = draw.uniform(1, 3) * ramp if self.kind == "free" else 0
            body["forward"] = f"{{ speed = {si(speed, 'm/s')}, start = {si(start, 's')}, ramp = {si(ramp, 's')} }}"
            self.travel = self.scale * (draw.uniform(0.8, 1.5) if self.careful else draw.uniform(0.2, 1.5))
            run["tow_distance"] = si(self.travel, "m")
            if self.diameter and draw.random() < 0.5 and "mass" not in body:
                body["spin"] = draw.choice(['"free"', '"locked"'])
                if body["spin"] == '"free"' and self.kind == "held":
                    body["mass"] = si(2000 * self.scale**3, "kg")
        elif self.kind == "pressed":
            body["heave"] = f"{{ speed = {si(-speed, 'm/s')}, ramp = {si(ramp, 's')} }}"
            run["duration"] = si(self.goal() / speed + 0.5 * ramp, "s")
        elif self.kind == "staged":
            self.stages(speed, ramp)
        else:
            run["duration"] = si(draw.uniform(1.0, 3.0) * math.sqrt(self.scale / GRAVITY) + 2 * ramp, "s")
        if run:
            self.sections["run"] = run

    def goal(self):
        """How deep a body is pressed."""
        if self.shape == "cone":
            return self.scale * (self.draw.uniform(0.8, 1.6) if self.careful else self.draw.uniform(0.1, 2.5))
        return self.height * (self.draw.uniform(0.3, 0.8) if self.careful else self.draw.uniform(0.05, 1.0))

    def weigh(self, body):
        """A weight that exerts a pressure of so many times that of the soil at a depth of the body's size."""
        pressure = self.gamma * self.scale * 10 ** (self.draw.uniform(0.0, 0.8) if self.careful else self.draw.uniform(-2, 1.5))
        if self.plane_strain:
            body["mass"] = si(pressure * self.scale / GRAVITY, "kg")
        else:
            body["weight"] = si(pressure * self.scale**2, "N")

    def stages(self, speed, ramp):
        """Pressed or released, then held for a moment or not, then towed, or pressed on at another speed; some are lifted."""
        draw, body = self.draw, self.sections["body.thing"]
        ramped = f"ramp = {si(ramp, 's')} }}"
        down = f"{{ speed = {si(-speed, 'm/s')}, {ramped}"
        goal = self.goal()

        def until(quantity, value):
            return f'{{ body = "thing", {quantity} = {si(value, "m")} }}'

        if self.shape != "cone" and draw.random() < 0.35:
            self.weigh(body)
            self.sections["stage.settle"] = {
                "thing.heave": f'{{ load = "0 N", {ramped}',
                "duration": si(draw.uniform(2, 4) * ramp, "s"),
            }
        else:
            # It is looked at once in a line of the history; twice the time that the way takes is enough.
            duration = 2 * (goal + 2 * self.crest) / speed + 2 * ramp
            self.sections["stage.press"] = {"thing.heave": down, "until": until("sinkage", goal), "duration": si(duration, "s")}
            if draw.random() < 0.4:
                self.sections["stage.hold"] = {"thing.heave": '"fixed"', "duration": si(draw.uniform(0.5, 2) * ramp, "s")}
        pressed = "stage.press" in self.sections
        if self.shape == "cone" or (pressed and draw.random() < 0.25):
            slower = draw.uniform(0.3, 1) * speed
            way = draw.uniform(0.3, 0.8) * goal
            self.sections["stage.on"] = {
                "thing.heave": f"{{ speed = {si(-slower, 'm/s')}, {ramped}",
                "duration": si(way / slower + ramp, "s"),
            }
            return
        self.towed = True
        self.travel = self.scale * (draw.uniform(0.8, 1.5) if self.careful else draw.uniform(0.2, 1.5))
        tow = {"thing.forward": f"{{ speed = {si(speed, 'm/s')}, {ramped}"}
        if pressed:
            tow["thing.heave"] = '"fixed"'
        if draw.random() < 0.5:
            tow["until"] = until("displacement", self.travel)
            tow["duration"] = si(2 * self.travel / speed + 2 * ramp, "s")
        else:
            tow["duration"] = si(self.travel / speed + 0.5 * ramp, "s")
        self.sections["stage.tow"] = tow
        if draw.random() < 0.3:
            self.sections["stage.lift"] = {
                "thing.forward": '"fixed"',
                "thing.heave": f"{{ speed = {si(speed, 'm/s')}, {ramped}",
                "duration": si(draw.uniform(0.3, 1) * self.height / speed + ramp, "s"),
            }

    def joint(self):
        """Some of those that are towed are towed by a joint: to a frame, which then has the prescribed motion, or to a
        second body of the same kind in front."""
        draw, body = self.draw, self.sections["body.thing"]
        if self.kind not in ("held", "free") or draw.random() > 0.22:
            return
        kinds = ["spring", "cable"]
        if self.turns:
            kinds.append("hinge")
        if self.kind == "free":
            kinds += ["slider", "ball", "arm"]
        kind = draw.choice(kinds)
        self.features.append(f"joint {'hinge' if kind == 'arm' else kind}")
        if "weight" not in body and "mass" not in body:
            self.weigh(body)
        sinkage = float(body["sinkage"].strip('"').split()[0]) if "sinkage" in body else 0
        middle = 0.5 * self.height - sinkage
        carrier = {"shape": '"frame"', "elevation": si(middle, "m")}
        joint = {"kind": f'"{kind}"', "bodies": '["carrier", "thing"]'}
        if kind in ("spring", "cable"):
            self.pull(joint, body, carrier, middle)
        else:
            carrier["forward"] = body.pop("forward")
            body.pop("spin", None)
            if kind == "slider":
                joint["axis"] = f"[{draw.choice([0, draw.uniform(-0.3, 0.3)]):.3g}, 0, 1]"
            elif kind in ("ball", "arm"):
                # It trails behind a point in front of it and above, about which it swings.
                joint["kind"] = '"ball"' if kind == "ball" else '"hinge"'
                if kind == "arm":
                    joint["axis"] = "[0, 1, 0]"
                if self.plane_strain:
                    # A slab with its middle at y = 0, where the joint must be.
                    half = 0.5 * self.cell
                    self.sections["domain"]["y"] = f"[{si(-half, 'm')}, {si(half, 'm')}]"
                joint["at"] = point(0.5 * self.length + self.scale * draw.uniform(0.5, 1.5), middle + self.scale * draw.uniform(0, 0.5))
            elif draw.random() < 0.3:
                joint["friction_torque"] = si(self.gamma * self.scale ** (3 if self.plane_strain else 4) * draw.uniform(0, 0.3), "N*m")
        self.sections["body.carrier"] = carrier
        self.sections["joint.link"] = joint

    def pull(self, joint, body, carrier, middle):
        """A spring or a cable, which stretches by a part of the body's size under the usual drag."""
        draw = self.draw
        dimensions = 2 if self.plane_strain else 3
        drag = self.gamma * self.scale**dimensions * 3
        stiffness = drag / (self.scale * (draw.uniform(0.02, 0.1) if self.careful else 10 ** draw.uniform(-2, 0)))
        given = body.get("mass") or body["weight"]
        mass = float(given.strip('"').split()[0]) / (1 if "mass" in body else GRAVITY)
        joint["stiffness"] = si(stiffness, "N/m")
        joint["damping"] = si(2 * math.sqrt(stiffness * mass) * (draw.uniform(0.5, 1) if self.careful else draw.uniform(0, 1)), "N*s/m")
        distance = self.length + self.scale * draw.uniform(1, 2)
        if draw.random() < 0.35 and "pitch" not in body and "yaw" not in body:
            # A second body in the place of the frame.
            carrier.clear()
            carrier.update({key: value for key, value in body.items() if key != "spin"})
            self.features.append("two bodies")
        else:
            carrier["forward"] = body["forward"]
        carrier["x"] = si(distance, "m")
        body["forward"] = '"free"'
        if draw.random() < 0.3:
            joint["length"] = si(distance * draw.uniform(0.95, 1.05), "m")

    def numerics(self):
        draw = self.draw
        self.sections["numerics"] = draw.choice(
            [
                {"courant": f"{draw.uniform(0.1, 1.0):.3g}"},
                {"contact": '"penalty"'},
                {"hourglass": f"{10 ** draw.uniform(-3, -1):.3g}"},
                {"precision": '"single"'},
                {"remap_displacement": f"{draw.uniform(0.02, 0.5):.3g}"},
            ]
        )

    def text(self, cell=None):
        lines = ["format = 2", ""]
        for name, keys in self.sections.items():
            lines.append(f"[{name}]")
            lines += [f"{key} = {value}" for key, value in keys.items()]
            lines.append("")
        text = "\n".join(lines)
        return text if cell is None else text.replace(f'cell = {si(self.cell, "m")}', f'cell = {si(cell, "m")}')

    def write(self, path):
        """The case file, and beside it the files to which it refers."""
        path.write_text(self.text())
        for name, content in self.files.items():
            (path.parent / name).write_bytes(content)


def check(program, case, path):
    """The costs as `coulter check` tells them; None if the case is refused (with its words)."""
    case.write(path)
    told = subprocess.run([program, "check", path, "--json"], capture_output=True, text=True, timeout=60)
    if told.returncode == 0:
        return json.loads(told.stdout)["cost"], ""
    return None, f"{told.returncode}: {told.stderr}"


def run(program, text, folder):
    """Exit code (None for a hang), summary (None if there is none) and what was told on standard error."""
    path = folder.with_suffix(".toml")
    path.write_text(text)
    command = [program, "run", path, "-o", folder, "--threads", "1", "--json"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=TIME_LIMIT)
    except subprocess.TimeoutExpired:
        return None, None, "no end in sight"
    summary = folder / "summary.json"
    return done.returncode, json.loads(summary.read_text()) if summary.exists() else None, done.stderr


def column(folder, name, file=None):
    if file is None:
        file = "forces.csv" if (folder / "forces.csv").exists() else "forces_thing.csv"
    with open(folder / file) as lines:
        return [float(line[name] or "nan") for line in csv.DictReader(lines)]


def out_of_bounds(case, folder):
    """What is wrong with motion, energy balance or leak of a run, by its CSV files alone."""
    faults = []
    sinkage, leak, embedded = (column(folder, n) for n in ("sinkage z [m]", "leak [m^3]", "embedded [m^3]"))
    numbers = sinkage + [v for n in ("drag F_H [N]", "vertical F_V [N]", "spin [rad/s]", "speed v [m/s]") for v in column(folder, n)]
    if not all(math.isfinite(v) for v in numbers):
        faults.append("not a number")
    if embedded[-1] > case.cell**3 and leak[-1] > 5.001e-3 * embedded[-1]:
        faults.append(f"leak {leak[-1] / embedded[-1]:.2e}")
    closure = column(folder, "closure [-]", "energy.csv")[-1]
    if abs(closure) > 0.01:
        faults.append(f"energy balance {closure:.3f}")
    tail = sinkage[2 * len(sinkage) // 3 :]
    if case.kind in ("free", "loaded") and sum(tail) / len(tail) < -0.06 * case.height - case.crest:
        faults.append(f"lifted to {-tail[-1]:.3g} m")
    if max(sinkage) > 5 * case.height:
        faults.append(f"sunk to {max(sinkage):.3g} m")
    return faults


def answer(case, summary):
    """Drag of a towed body [N], sinkage of one that its weight or a load presses [m], vertical force of any other [N]."""
    steady = summary["bodies"]["thing"]["steady"]
    return steady["drag_N" if case.towed else "sinkage_m" if case.kind in ("loaded", "dropped") else "vertical_N"]


def print_changes(records):
    """By how much answers move on cells of two thirds the size, over the least number of cells that a grade counts."""
    counted = ("cells over width", "cells over contact chord", "cells over sinkage")
    print("change on cells of two thirds the size; least cells over width, chord, sinkage: number, median, three of four, nine of ten")
    for low, high in ((0, 2), (2, 4), (4, 6), (6, math.inf)):
        changes = []
        for r in records:
            cells = [r["checks"][name] for name in counted if r["checks"].get(name) is not None]
            if cells and low <= min(cells) < high and r["answer"] and "law elastic" not in r["features"]:
                changes.append(abs(r["finer"] / r["answer"] - 1))
        changes.sort()
        if changes:
            parts = (f"{100 * changes[int(part * len(changes))]:.0f} %" for part in (0.5, 0.75, 0.9))
            print(f"  {low} to {high}: {len(changes)}, {', '.join(parts)}")


class Outcomes:
    """What came of the runs of one program; kept in a file, one line of JSON for each, if there is a folder for it."""

    def __init__(self, program, keep):
        self.program, self.known, self.file, self.lock = program, {}, None, threading.Lock()
        if keep:
            Path(keep).mkdir(parents=True, exist_ok=True)
            digest = hashlib.sha256(Path(program).read_bytes()).hexdigest()
            path = Path(keep) / f"outcomes-{digest[:12]}.jsonl"
            if path.exists():
                # The last line may have been cut short.
                lines = (line for line in path.read_text().splitlines() if line.endswith("}"))
                self.known = {entry["case"]: entry for entry in map(json.loads, lines)}
            self.file = open(path, "a")

    def of(self, case, text, folder):
        """Exit code, summary, standard error, and what is wrong with a run that is graded good."""
        key = hashlib.sha256(text.encode()).hexdigest()
        if key not in self.known:
            code, summary, told = run(self.program, text, folder)
            is_good = summary is not None and code in (0, 1) and summary["trust"]["verdict"] == "good"
            entry = {
                "case": key,
                "code": code,
                "summary": summary and {name: summary[name] for name in ("trust", "bodies")},
                "told": told[-400:],
                "wrong": out_of_bounds(case, folder) if is_good else [],
            }
            shutil.rmtree(folder, ignore_errors=True)
            with self.lock:
                self.known[key] = entry
                if self.file:
                    print(json.dumps(entry), file=self.file, flush=True)
        entry = self.known[key]
        return entry["code"], entry["summary"], entry["told"], entry["wrong"]


def print_table(records):
    """How many of each shape, ground and motion were good, doubtful and broken, and the checks that broke them."""
    groups = {}
    for record in records:
        for name in [record["shape"], *record["features"]]:
            groups.setdefault(name, []).append(record)
    shapes = [name for name in SHAPES if name in groups]
    print(f"{'':16} {'number':>6} {'good':>5} {'doubtful':>8} {'broken':>6}  broken by")
    for name in shapes + sorted(set(groups) - set(shapes)):
        group = groups[name]
        good, doubtful, broken = (sum(r["verdict"] == v for r in group) for v in ("good", "doubtful", "broken"))
        by = Counter(check for r in group for check in r["broken"])
        print(f"{name:16} {len(group):6} {good:5} {doubtful:8} {broken:6}  {', '.join(f'{c} {n}' for c, n in by.most_common())}")
    share = {v: 100 * sum(r["verdict"] == v for r in records) / len(records) for v in ("broken", "good")}
    print(f"broken {share['broken']:.1f} % (to be accepted at most 5 %), good {share['good']:.1f} % (at least 30 %)")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=500)
    parser.add_argument("--finer", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--short", action="store_true", help="50 cases, none of them finer")
    parser.add_argument("--changes", action="store_true", help="all good and doubtful ones on finer cells, and a table")
    parser.add_argument("--keep", help="folder for a line of JSON per case")
    options = parser.parse_args()
    if options.short:
        options.count, options.finer = 50, 0
    faults, refused, records = [], [], []
    outcomes = Outcomes(options.program, options.keep)
    with tempfile.TemporaryDirectory() as scratch:
        scratch = Path(scratch)

        def one(n, careful=False):
            case_draw = random.Random(f"{options.seed}-{n}")
            while True:
                case = Case(case_draw, careful)
                cost, why = check(options.program, case, scratch / f"{n}.check.toml")
                if cost is None:
                    refused.append(why)
                elif cost["filled_cells"] * cost["steps"] <= WORK_LIMIT:
                    break
            folder = scratch / f"case-{n}"
            code, summary, told, wrong = outcomes.of(case, case.text(), folder)
            record = {"n": n, "shape": case.shape, "features": case.features, "kind": case.kind}
            record.update({"careful": case.careful, "code": code, "verdict": None, "broken": []})
            if code not in (0, 1):
                faults.append(f"case {n}: ends with {code}: {told[-400:]}\n{case.text()}")
            elif summary is None:
                faults.append(f"case {n}: no summary: {told[-400:]}")
            else:
                trust = summary["trust"]
                record["verdict"] = trust["verdict"]
                record["checks"] = {c["name"]: c["value"] for c in trust["checks"]}
                record["doubts"] = [c["name"] for c in trust["checks"] if c["verdict"] != "good"]
                record["broken"] = [c["name"] for c in trust["checks"] if c["verdict"] == "broken"]
                record["answer"] = answer(case, summary)
                if (code == 1) != (trust["verdict"] == "broken"):
                    faults.append(f"case {n}: graded {trust['verdict']}, exit code {code}")
                faults.extend(f"case {n}: graded good with {w}" for w in wrong)
            records.append(record)
            return case, record

        def finer(pair):
            case, record = pair
            text = case.text(case.cell / 1.5)
            code, summary, told, _ = outcomes.of(case, text, scratch / f"finer-{record['n']}")
            if summary is None or code not in (0, 1):
                faults.append(f"case {record['n']}, finer: ends with {code}: {told[-400:]}")
                return
            record["finer"] = answer(case, summary)
            record["finer_verdict"] = summary["trust"]["verdict"]

        with ThreadPoolExecutor(options.jobs) as team:
            done = list(team.map(one, range(options.count)))
            good = [pair for pair in done if pair[1]["verdict"] == "good"]
            # Where too few are good, careful ones are drawn until there are enough, within reason.
            while len(good) < options.finer and len(done) < 4 * options.count:
                more = list(team.map(lambda n: one(n, True), range(len(done), len(done) + 10)))
                done += more
                good += [pair for pair in more if pair[1]["verdict"] == "good"]
            compared = good[: options.finer]
            if options.changes:
                compared += [pair for pair in done if pair[1]["verdict"] in ("good", "doubtful") and pair not in compared]
            list(team.map(finer, compared))
        if options.keep:
            lines = [json.dumps(record) + "\n" for record in sorted(records, key=lambda r: r["n"])]
            (Path(options.keep) / f"seed-{options.seed}.jsonl").write_text("".join(lines))
            for case, record in done:
                case.write(Path(options.keep) / f"case-{options.seed}-{record['n']}.toml")

    count = {v: sum(r["verdict"] == v for r in records) for v in ("good", "doubtful", "broken")}
    print(f"{len(records)} cases (seed {options.seed}): {count}; {len(refused)} drawings refused by check")
    print_table([r for r in records if r["n"] < options.count])
    for why in refused:
        if "panick" in why or not why.startswith("2"):
            faults.append(f"check: {why}")
    again = [r for r in records if r.get("finer") is not None]
    if options.changes:
        print_changes(again)
    compared = [r for r in again if r["verdict"] == "good"]
    near = [r for r in compared if abs(r["finer"] - r["answer"]) <= 0.25 * max(abs(r["finer"]), abs(r["answer"]))]
    if options.finer:
        fraction = len(near) / len(compared) if compared else 0
        print(f"{len(near)} of {len(compared)} graded good are within 25 % on cells of two thirds the size ({100 * fraction:.0f} %)")
        for r in compared:
            if r not in near:
                print(f"  case {r['n']} ({r['kind']}): {r['answer']:.4g}, finer {r['finer']:.4g}")
        if len(compared) < options.finer or fraction < 0.9:
            faults.append("too few graded good are near their finer selves")
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
