"""Example panels for the tests of the Python package."""
import os
import pathlib
import subprocess

import pytest

import beadmesh


@pytest.fixture(scope="session")
def program():
    return os.environ["BEADMESH"]


@pytest.fixture(scope="session")
def panel_file(tmp_path_factory):
    """The example panel with a bead of every kind."""
    path = pathlib.Path(tmp_path_factory.mktemp("panels")) / "basic.step"
    subprocess.run([os.environ["MAKE_EXAMPLE_PANEL"], "basic", path], check=True, timeout=300)
    return path


@pytest.fixture(scope="session")
def panel(panel_file):
    return beadmesh.read(panel_file)


@pytest.fixture(scope="session")
def mesh(panel):
    return beadmesh.mesh(panel)
