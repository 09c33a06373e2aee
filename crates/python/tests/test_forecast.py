"""Forecasts: the same numbers as the shell's, over arrays."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from conftest import CASES, DISC, shell

import coulter


def of_shell(*options: str) -> dict[str, dict[str, float]]:
    """The models of the shell's forecast by name."""
    done = shell("forecast", str(DISC), "--json", *options)
    assert done.returncode == 0, done.stderr
    document = json.loads(done.stdout)
    models = {model["name"]: model for model in document["models"]}
    return {**models, "recommended": models[document["recommended"]]}


def test_numbers_are_those_of_the_shell() -> None:
    angles = np.array([31.7, 35.0, 38.123456789])
    weights = np.array([20.0, 100.0 / 3.0])
    vary = {"soil.friction_angle": (angles, "deg"), "body.disc.weight": (weights, "N")}
    best = coulter.forecast(DISC, vary=vary, grid=True)
    every = coulter.forecast(DISC, vary=vary, grid=True, model="all", threads=3)
    assert best.shape == (3, 2) and every.shape == (len(every.rows), 3, 2)
    for i, angle in enumerate(angles.tolist()):
        for j, weight in enumerate(weights.tolist()):
            theirs = of_shell(
                "--set", f"soil.friction_angle={angle!r} deg", "--set", f"body.disc.weight={weight!r} N"
            )
            ours = {name: every.drag[n, i, j] for n, name in enumerate(every.rows)}
            applicable = {name: m for name, m in theirs.items() if m["applicable"] and name != "recommended"}
            assert {name: m["drag_N"] for name, m in applicable.items()} == {
                name: drag for name, drag in ours.items() if not np.isnan(drag)
            }
            recommended = theirs["recommended"]
            assert best.model[i, j] == recommended["name"] and best.reason[i, j] == ""
            for name, key in [
                ("drag", "drag_N"),
                ("vertical", "vertical_N"),
                ("sinkage", "sinkage_m"),
                ("slip", "slip"),
                ("contact_angle", "contact_angle_rad"),
                ("F_H_bar", "F_H_bar"),
                ("Z", "Z"),
            ]:
                assert best[name][i, j] == recommended[key], name


def test_arrays_broadcast_and_one_point_has_no_axes() -> None:
    one = coulter.forecast(DISC, set={"soil.friction_angle": (36, "deg")})
    assert one.shape == () and float(one.drag) == of_shell("--set", "soil.friction_angle=36 deg")["recommended"]["drag_N"]
    two = coulter.forecast(
        DISC,
        vary={"soil.friction_angle": ([[34.0], [36.0]], "deg"), "body.disc.friction": [0.2, 0.3, 0.4]},
        model="BC",
    )
    assert two.shape == (2, 3) and set(two.model.ravel()) == {"BC"}
    assert two.drag[1, 1] == coulter.forecast(DISC, set={"soil.friction_angle": "36 deg"}, model="BC").drag
    with pytest.raises(ValueError, match="one axis"):
        coulter.forecast(DISC, vary={"body.disc.friction": [[0.2, 0.3]]}, grid=True)


def test_where_there_is_no_answer_the_reason_stands() -> None:
    some = coulter.forecast(DISC, vary={"body.disc.friction": [0.3, -1.0, np.nan]})
    assert np.isnan(some.drag).tolist() == [False, True, True]
    assert some.reason[0] == "" and "friction" in some.reason[1] and some.reason[2] != ""
    every = coulter.forecast(DISC, model="all")
    unanswered = np.isnan(every.drag)
    assert unanswered.any() and all(every.reason[unanswered]) and not any(every.reason[~unanswered])
    with pytest.raises(coulter.RequestError, match="there are .*BC"):
        coulter.forecast(DISC, model="nobody's")
    with pytest.raises(coulter.CaseError, match="friction_angel"):
        coulter.forecast(DISC, vary={"soil.friction_angel": ([30.0, 31.0], "deg")})
    for threads in (-1, 10**6):
        with pytest.raises(coulter.RequestError, match=f"threads = {threads}"):
            coulter.forecast(DISC, threads=threads)
    with pytest.raises(coulter.RequestError, match="no forecast for this case"):
        coulter.forecast(CASES / "column_collapse.toml")


def test_a_forecast_becomes_a_table_and_a_dataset() -> None:
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    found = coulter.forecast(
        DISC,
        vary={"soil.friction_angle": ([34.0, 36.0], "deg"), "body.disc.weight": ([20.0, 40.0, 60.0], "N")},
        grid=True,
        model="all",
    )
    frame = found.to_pandas()
    assert len(frame) == found.drag.size
    assert frame.attrs["units"]["drag"] == "N" and frame.attrs["units"]["soil.friction_angle"] == "deg"
    dataset = found.to_xarray()
    assert dataset["drag"].dims == ("row", "soil.friction_angle", "body.disc.weight")
    assert dataset["drag"].attrs["units"] == "N" and dataset["body.disc.weight"].attrs["units"] == "N"
    picked = dataset["drag"].sel({"row": "BC", "soil.friction_angle": 36.0, "body.disc.weight": 40.0})
    assert float(picked) == coulter.forecast(DISC, set={"soil.friction_angle": "36 deg"}, model="BC").drag
    paired = coulter.forecast(DISC, vary={"soil.friction_angle": ([34.0, 36.0], "deg"), "body.disc.friction": [0.2, 0.3]})
    assert paired.to_xarray()["drag"].dims == ("axis_0",)
    assert paired.to_xarray()["soil.friction_angle"].dims == ("axis_0",)


def test_nothing_is_written(in_folder: Path) -> None:
    coulter.forecast(DISC)
    assert not any(in_folder.iterdir())
