"""Folders of results that came from others."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from coulter import RequestError
from coulter._inside import inside


def test_nothing_is_followed_out_of_a_folder(tmp_path: Path) -> None:
    folder, outside = tmp_path / "results", tmp_path / "outside"
    (folder / "fields").mkdir(parents=True)
    outside.mkdir()
    (outside / "victim").write_text("secret")
    (folder / "own").write_text("ours")
    (folder / "link").symlink_to(outside / "victim")
    (folder / "linked").symlink_to(outside)
    os.mkfifo(folder / "pipe")
    (tmp_path / "named").symlink_to(folder)
    for name in ["link", "linked/victim", "pipe", "../outside/victim", str(outside / "victim"), "fields/../../outside/victim"]:
        with pytest.raises(RequestError, match="a link|a pipe|leads out"):
            inside(folder, name)
    assert inside(tmp_path / "named", "own").read_text() == "ours"
    assert not inside(folder, "missing/file").exists()
