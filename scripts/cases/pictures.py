#!/usr/bin/env python3
"""Draws the pictures of docs/reference/cases.md from the results of the shipped cases.

    pictures.py RESULTS [CASE]... [-o DIR]

RESULTS holds one results folder per case, named like it: `coulter run cases/blade.toml -o RESULTS/blade`. Without CASE every
case is drawn whose folder is there. Pictures go to docs/images/cases, or to DIR.

Cases of VIEWS are rendered at the end of the run, from surface.pvd and body.pvd: brown soil has risen, green soil has fallen. For
those of SECTIONS a picture that the run wrote is taken. All are cut to their content, narrowed and reduced in colours until they
are small.

Python 3 with pyvista, numpy and pillow (tried with pyvista 0.49 and pillow 13); pyvista renders off screen.
"""

import argparse
from pathlib import Path

import numpy as np
import pyvista
from PIL import Image, ImageChops

IMAGES = Path(__file__).resolve().parents[2] / "docs" / "images" / "cases"
WINDOW = (1000, 620)  # pixels
WIDTH = 720  # pixels of a finished picture, at most
COLOURS = (256, 192, 128, 96, 64)  # the first that is small enough, or the last
MARGIN = 6  # pixels left white around the content

# Camera: direction from the bodies (x, y, z), zoom, and height [m] above the soil's surface that it looks at.
VIEWS = {
    "towed_disc": ((-1.0, -1.1, 0.7), 1.6, 0.0),
    "towed_disc_mohr_coulomb": ((-1.0, -1.1, 0.7), 1.6, 0.0),
    "press_and_tow": ((-1.0, -1.1, 0.7), 1.6, 0.0),
    "disc_under_water": ((-1.0, -1.1, 0.7), 1.6, 0.0),
    "light_disc": ((-1.0, -1.1, 0.7), 1.6, 0.03),
    "disc_on_a_cable": ((-1.0, -1.1, 0.7), 1.6, 0.0),
    "rockhopper": ((-1.0, -0.9, 0.75), 1.7, 0.0),
    "swept_wing": ((-1.0, -0.6, 0.9), 1.9, 0.0),
    "driven_wheel": ((-1.0, -1.0, 0.6), 1.6, 0.05),
    "grousered_wheel": ((-1.0, -1.0, 0.6), 1.65, 0.06),
    "wheel_on_slope": ((-1.0, -1.0, 0.6), 1.6, 0.06),
    "furrowed_field": ((-1.0, -1.1, 0.7), 1.6, 0.0),
    "cmu_wheel": ((-1.0, -1.1, 0.7), 1.5, 0.02),
    "harrow_disc": ((-1.0, -1.3, 0.8), 1.6, 0.09),
    "double_disc_opener": ((-1.2, -0.9, 0.8), 1.6, 0.0),
    "blade": ((-1.0, -1.3, 0.8), 1.5, 0.0),
    "stl_tool": ((0.8, -1.3, 1.0), 1.9, 0.0),
}
# The picture of a results folder that is shown, and its width [pixels] at most: tall ones are narrower.
SECTIONS = {
    "cone": ("soil_plastic_strain", 250),
    "cmu_plate": ("soil_plastic_strain", 440),
    "pipe": ("soil_plastic_strain", WIDTH),
    "strip_footing": ("soil_speed", WIDTH),
    "passive_wall": ("soil_plastic_strain", WIDTH),
    "column_collapse": ("soil_plastic_strain", WIDTH),
}


def last(collection):
    """What a .pvd file holds at its last time."""
    reader = pyvista.get_reader(collection)
    reader.set_active_time_value(reader.time_values[-1])
    return reader.read()


def meshes(blocks):
    """The meshes of nested blocks, without empty ones."""
    for block in blocks:
        if isinstance(block, pyvista.MultiBlock):
            yield from meshes(block)
        elif block is not None and block.n_points:
            yield block


def add_soil(plotter, surface):
    """The surface of the soil, coloured by its rise; white is where it was."""
    rise = np.asarray(surface["rise"]) * 1000.0
    surface["rise [mm]"] = rise
    limit = np.abs(rise).max()
    bar = {
        "title": "rise of the surface [mm]",
        "vertical": False,
        "position_x": 0.58,
        "position_y": 0.03,
        "width": 0.36,
        "height": 0.07,
        "title_font_size": 20,
        "label_font_size": 18,
        "n_labels": 3,
        "fmt": "%.0f",
        "color": "black",
    }
    plotter.add_mesh(
        surface,
        scalars="rise [mm]",
        cmap="BrBG_r",
        clim=(-limit, limit),
        ambient=0.25,
        diffuse=0.8,
        scalar_bar_args=bar,
    )


def add_body(plotter, body):
    """A body, with its sharp edges."""
    skin = body.extract_surface()
    plotter.add_mesh(skin, color="#9fb0c8", specular=0.2, ambient=0.3)
    edges = skin.extract_feature_edges(25)  # degrees
    if edges.n_points:
        plotter.add_mesh(edges, color="#222222", line_width=2)


def aim(camera, bodies, direction, zoom, height):
    """Looks at the middle of the bodies, from a distance that goes with their size."""
    bounds = np.array([body.bounds for body in bodies])
    low, high = bounds[:, [0, 2]].min(axis=0), bounds[:, [1, 3]].max(axis=0)
    middle = np.array([*(low + high) / 2, height])
    direction = np.array(direction) / np.linalg.norm(direction)
    camera.focal_point = middle
    camera.position = middle + direction * (high - low).max() * 5.2 / zoom
    camera.up = (0, 0, 1)
    camera.view_angle = 30


def rendered(results, view):
    """Bodies and soil at the end of a run."""
    plotter = pyvista.Plotter(off_screen=True, window_size=WINDOW)
    add_soil(plotter, last(results / "surface.pvd")[0])
    bodies = list(meshes(last(results / "body.pvd")))
    for body in bodies:
        add_body(plotter, body)
    aim(plotter.camera, bodies, *view)
    plotter.background_color = "white"
    plotter.enable_anti_aliasing("ssaa")
    image = Image.fromarray(plotter.screenshot(return_img=True))
    plotter.close()
    return image


def trimmed(image):
    """Without what is white around the content."""
    white = Image.new("RGB", image.size, "white")
    box = ImageChops.difference(image, white).getbbox()
    if box is None:
        return image
    left, top, right, bottom = box
    right, bottom = min(right + MARGIN, image.width), min(bottom + MARGIN, image.height)
    return image.crop((max(left - MARGIN, 0), max(top - MARGIN, 0), right, bottom))


def save(image, path, width, kilobytes):
    """Writes a small picture: narrow, of few colours."""
    image = trimmed(image.convert("RGB"))
    if image.width > width:
        image = image.resize((width, round(image.height * width / image.width)), Image.Resampling.LANCZOS)
    for colours in COLOURS:
        reduced = image.quantize(colours, Image.Quantize.MEDIANCUT, kmeans=2, dither=Image.Dither.NONE)
        reduced.save(path, optimize=True)
        if path.stat().st_size <= kilobytes * 1024:
            break
    print(f"{path.name}: {image.width} x {image.height}, {colours} colours, {path.stat().st_size} bytes")


def draw(name, results, folder):
    """The picture of one case."""
    path = folder / f"{name}.png"
    if name in VIEWS:
        save(rendered(results, VIEWS[name]), path, WIDTH, 34)
    else:
        picture, width = SECTIONS[name]
        with Image.open(results / "pictures" / f"{picture}.png") as section:
            save(section, path, width, 30)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path, metavar="RESULTS")
    parser.add_argument("cases", nargs="*", metavar="CASE")
    parser.add_argument("-o", "--output", type=Path, default=IMAGES, metavar="DIR")
    options = parser.parse_args()
    known = [*VIEWS, *SECTIONS]
    unknown = [name for name in options.cases if name not in known]
    if unknown:
        parser.error(f"no view is known of {', '.join(unknown)}")
    cases = options.cases or [name for name in known if (options.results / name).is_dir()]
    if not cases:
        parser.error(f"{options.results} holds no folder that is named like a case")
    options.output.mkdir(parents=True, exist_ok=True)
    for name in cases:
        draw(name, options.results / name, options.output)


if __name__ == "__main__":
    main()
