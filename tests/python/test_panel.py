"""Panels and their beads are those of the program."""
import json
import pickle
import subprocess

import numpy as np
import pytest

import beadmesh


@pytest.fixture(scope="module")
def table(panel):
    return beadmesh.beads(panel)


def test_the_table_is_that_of_the_program(program, panel_file, table):
    done = subprocess.run([program, "beads", panel_file, "--json", "-"], capture_output=True, text=True, timeout=300)
    expected = json.loads(done.stdout)
    assert len(table.beads) == len(expected["beads"]) == 4
    for ours, theirs in zip(table.beads, expected["beads"]):
        for key in ("id", "kind", "shape", "faces", "loops", "junctions", "ends", "medial_edges"):
            assert getattr(ours, key) == theirs[key]
        for key in ("length", "width", "height", "aspect_ratio"):
            assert getattr(ours, key) == pytest.approx(theirs[key], abs=1e-5)
        assert ours.point == pytest.approx(theirs["point"], abs=1e-5)
        for line, expected_line in zip(ours.ridge, theirs["ridge"], strict=True):
            assert line.shape == (len(line), 3)
            assert np.abs(line - expected_line).max() < 1e-5
    assert [tuple(face) for face in table.faces_not_beads] == [
        (face["face"], face["reason"]) for face in expected["faces_not_beads"]]


def test_options_decide(panel):
    wide = beadmesh.beads(panel, beadmesh.BeadOptions(min_aspect_ratio=4.0))
    assert [bead.shape for bead in wide.beads] == ["I", "I", "ring"]
    assert any("aspect ratio" in face.reason for face in wide.faces_not_beads)


def test_facets_are_arrays(panel):
    facets = panel.facets()
    assert [face.face for face in facets] == list(range(1, panel.face_count + 1))
    for face in facets:
        assert face.points.dtype == np.float64 and face.points.shape[1] == 3
        assert face.triangles.dtype == np.int32 and face.triangles.shape[1] == 3
        assert face.triangles.min() == 0 and face.triangles.max() == len(face.points) - 1
    sides = facets[0].points[facets[0].triangles]
    area = np.linalg.norm(np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]), axis=1).sum() / 2
    assert 20_000 < area < 50_000  # a sheet of about 260 x 160 mm with holes where the beads are


@pytest.mark.parametrize("name, content, code", [
    ("missing.step", None, "read.not_found"),
    ("empty.step", b"", "read.empty"),
    ("panel.xyz", b"x", "read.ending"),
    ("half.step", b"ISO-10303-21;\nHEADER;\n", "read."),
])
def test_failures_carry_the_diagnostic(tmp_path, name, content, code):
    path = tmp_path / name
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(beadmesh.BeadmeshError) as caught:
        beadmesh.read(path)
    error = caught.value
    assert error.code.startswith(code)
    assert error.diagnostic.severity == "error"
    assert error.message and error.message in str(error) and error.code in str(error)
    assert name in error.entity
    again = pickle.loads(pickle.dumps(error))
    assert (again.code, again.message, again.face) == (error.code, error.message, error.face)
