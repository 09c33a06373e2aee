"""Results read from a folder: tables, means, fields."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import coulter


def test_tables_have_columns_with_units(tow: Path) -> None:
    result = coulter.open_result(tow)
    forces = result.forces
    assert forces.unit("drag") == "N" and forces.unit("sinkage z") == "m" and forces.unit("moment_x") == "N m"
    assert forces["drag"] is forces["drag F_H"] and forces["time"].dtype == np.float64
    assert np.isnan(forces["turn ratio"][0]), "an empty field is not-a-number"
    assert {"forces", "energy", "boundaries", "rut", "rim", "filtered", "height_map"} <= set(result.tables)
    assert result.energy.unit("external") == "J"
    with pytest.raises(KeyError, match="drag F_H"):
        forces["thrust"]
    with pytest.raises(coulter.RequestError, match="energy"):
        result.table("heat")
    with pytest.raises(coulter.RequestError, match="disc"):
        result.table("forces", body="plough")


def test_means_have_units(tow: Path) -> None:
    result = coulter.open_result(tow)
    steady, summary = result.steady(), result.summary["bodies"]["disc"]["steady"]
    assert steady["drag"].value == summary["drag_N"] and steady["drag"].unit == "N"
    assert steady["sinkage"].unit == "m" and steady["axle_torque"].unit == "N m" and steady["slip"].unit == "-"
    assert result.grade in ("good", "doubtful") and result.checks[0]["name"]
    assert result.bodies == ["disc"] and repr(result).startswith("<Result")


def test_tables_become_data_frames_and_datasets(tow: Path) -> None:
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    forces = coulter.open_result(tow).forces
    frame = forces.to_pandas()
    assert list(frame.columns) == list(forces) and frame.attrs["units"]["drag F_H"] == "N"
    dataset = forces.to_xarray()
    assert dataset["drag"].dims == ("time",) and dataset["drag"].attrs == {"units": "N", "long_name": "drag F_H"}
    assert dataset["time"].attrs["units"] == "s"
    heights = coulter.open_result(tow).table("height_map").to_xarray()
    assert heights["z"].dims == ("line",)


def test_fields_are_arrays_with_units(tow: Path) -> None:
    result = coulter.open_result(tow)
    assert result.times[0] == 0.0 and len(result.times) > 2
    soil = result.soil(0)
    x, y, z = soil.centres
    assert soil.time == 0.0 and soil["evf"].shape == (len(z), len(y), len(x))
    assert soil["stress"].shape == (len(z), len(y), len(x), 6) and soil.unit("pressure") == "Pa"
    # At rest the pressure grows with depth, and the soil fills what lies below the surface.
    deep = soil["pressure"][:, 0, 0]
    assert deep[0] > deep[5] > 0.0 and soil["evf"][0].min() == 1.0 and soil["evf"][-1].max() == 0.0
    filled = float((soil["evf"] * soil.volumes).sum())
    box = (soil.faces[0][-1] - soil.faces[0][0]) * (soil.faces[1][-1] - soil.faces[1][0]) * -soil.faces[2][0]
    assert 0.98 * box < filled <= box
    surface = result.surface()
    assert surface["height"].shape == (len(surface.y), len(surface.x))
    np.testing.assert_allclose(surface.y, -surface.y[::-1])
    body = result.body()
    assert body.points.shape[1] == 3 and body.triangles.max() < len(body.points)
    with pytest.raises(coulter.RequestError, match="there is no number 70"):
        result.soil(70)
    with pytest.raises(KeyError, match="evf"):
        soil["colour"]


def test_fields_become_datasets(tow: Path) -> None:
    pytest.importorskip("xarray")
    result = coulter.open_result(tow)
    soil = result.soil().to_xarray()
    assert soil["evf"].dims == ("z", "y", "x") and soil["pressure"].attrs["units"] == "Pa"
    assert soil["velocity"].sel(component="x").dims == ("z", "y", "x") and soil["x"].attrs["units"] == "m"
    assert soil["stress"].sel(stress_component="xz").shape == soil["evf"].shape
    surface = result.surface().to_xarray()
    assert surface["rise"].dims == ("y", "x") and surface["rise"].attrs["units"] == "m"
    assert result.body().to_xarray()["position"].dims == ("point", "component")


def test_fields_become_meshes_of_pyvista(tow: Path) -> None:
    pytest.importorskip("pyvista")
    result = coulter.open_result(tow)
    soil = result.soil()
    mesh = soil.to_pyvista()
    np.testing.assert_array_equal(mesh.cell_data["evf"].reshape(soil["evf"].shape), soil["evf"])
    np.testing.assert_array_equal(mesh.cell_data["stress"].reshape(soil["stress"].shape), soil["stress"])
    body = result.body()
    assert body.to_pyvista().n_cells == len(body.triangles)
    np.testing.assert_array_equal(result.surface().to_pyvista()["height"], result.surface()["height"].ravel())


def test_a_missing_package_names_the_cure(tow: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import sys

    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ImportError, match=r'pip install "coulter\[pandas\]"'):
        coulter.open_result(tow).forces.to_pandas()


def test_what_is_no_result_is_refused(tmp_path: Path) -> None:
    with pytest.raises(coulter.RequestError, match="run.json"):
        coulter.open_result(tmp_path)
    for found, words in [('{"format": 99}', "newer version"), ('{"format": 0}', "run its case again"), ("{}", "run its case again")]:
        (tmp_path / "run.json").write_text(found, encoding="utf-8")
        with pytest.raises(coulter.RequestError, match=words):
            coulter.open_result(tmp_path)
    (tmp_path / "table.csv").write_text("a [m],b\n1,x\n2\n", encoding="utf-8")
    with pytest.raises(coulter.RequestError, match="line 3 has 1 fields"):
        coulter.Table.read(tmp_path / "table.csv")
    (tmp_path / "soil.vtr").write_bytes(b"<VTKFile>")
    with pytest.raises(coulter.RequestError, match="no field file"):
        coulter.SoilField(tmp_path / "soil.vtr").time
