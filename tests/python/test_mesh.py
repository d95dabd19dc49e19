"""Meshes: as the program makes them, judged, written, to and from meshio."""
import signal
import subprocess
import threading
import time

import meshio
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import beadmesh

quiet = settings(deadline=None, max_examples=40, derandomize=True)
ENDINGS = ("bdf", "inp", "vtu", "msh")


def test_shapes_and_sets(mesh):
    n, m = len(mesh.nodes), len(mesh.elements)
    assert mesh.nodes.shape == (n, 3) and mesh.elements.shape == (m, 4)
    assert mesh.part.shape == mesh.face.shape == mesh.bead.shape == (m,)
    assert mesh.elements.max() == n - 1
    assert [part.name for part in mesh.parts] == ["sheet", "bead_I", "bead_generic", "bead_annular"]
    assert [one.bead for one in mesh.sets] == [1, 2, 3, 4] == [bead.id for bead in mesh.table.beads]
    for one, meshing in zip(mesh.sets, mesh.meshing, strict=True):
        assert np.array_equal(one.elements, np.flatnonzero(mesh.bead == one.bead))
        assert meshing.method == "blocks" and meshing.elements == len(one.elements)
        assert np.array_equal(np.unique(np.concatenate(one.crest_lines)), one.crest_nodes)
        assert (len(one.cap_elements) == 0) == (one.kind == "annular")


def test_the_deck_is_that_of_the_program(mesh, panel_file, program, tmp_path):
    subprocess.run([program, "mesh", panel_file, "-o", tmp_path / "program.bdf"], check=True, timeout=300)
    mesh.write(tmp_path / "module.bdf")
    bulk = [(tmp_path / f"{name}.bdf").read_text().split("BEGIN BULK")[1] for name in ("program", "module")]
    assert bulk[0] == bulk[1]


def test_the_result_does_not_depend_on_threads(panel, mesh):
    one = beadmesh.mesh(panel, jobs=1)
    assert np.array_equal(one.nodes, mesh.nodes) and np.array_equal(one.elements, mesh.elements)


def test_controls(panel):
    made = beadmesh.mesh(panel, size=6, thickness=0.8, kinds={"annular": {"elements_across": 4}},
                         single={1: {"method": "face"}})
    assert {part.thickness for part in made.parts} == {0.8}
    assert made.meshing[0].method == "face"
    assert made.meshing[3].elements_across == 4
    for values, code in (({"beads": {"width": 4}}, "control.key"), ({"beads": {"size": "x"}}, "control.type"),
                         ({"beads": {"method": "x"}}, "control.method"), ({"kinds": {"T": {}}}, "control.kind"),
                         ({"single": {99: {"size": 4}}}, "control.bead"), ({"size": -1}, "usage.size"),
                         ({"size": 5, "min_edge": 6}, "usage.min_edge")):
        with pytest.raises(beadmesh.BeadmeshError) as caught:
            beadmesh.mesh(panel, **values)
        assert caught.value.code == code


def test_other_threads_run_meanwhile(panel):
    """The lock of the interpreter is released: this thread goes on counting while the other meshes."""
    done, seen = threading.Event(), []

    def work():
        seen.append(beadmesh.mesh(panel, size=4))
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    ticks = 0
    while not done.wait(0.005):
        ticks += 1
    thread.join()
    assert len(seen) == 1
    assert ticks > 20


def test_quality_of_known_elements():
    nodes = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (3, 1, 0), (0, 0, 1)]
    quality = beadmesh.quality(nodes, [(0, 1, 2, 3), (1, 4, 2, -1), (0, 3, 2, 1)], min_edge=1.5)
    assert quality.scaled_jacobian[0] == 1 and quality.warpage[0] == 0
    assert quality.scaled_jacobian[1] == pytest.approx(2 / 3**0.5 * 0.5**0.5)
    assert quality.shortest_edge == pytest.approx([2, 2**0.5, 2]) and quality.longest_edge[1] == 2
    assert quality.smallest_angle == pytest.approx([90, 45, 90]) and quality.largest_angle[1] == pytest.approx(90)
    assert (quality.quads, quality.triangles, quality.edges_below_min) == (2, 1, 2)
    with pytest.raises(beadmesh.BeadmeshError, match="node 6 does not exist") as caught:
        beadmesh.quality(nodes, [(0, 1, 2, 6)])
    assert caught.value.entity == "element 0"
    with pytest.raises(beadmesh.BeadmeshError):
        beadmesh.quality(nodes, [(0, 1, 2)])


@st.composite
def any_mesh(draw):
    """A grid of quads, some of them split, in up to three parts."""
    columns, rows = draw(st.integers(1, 6)), draw(st.integers(1, 6))
    size, flat = draw(st.floats(0.1, 1e3)), draw(st.booleans())
    nodes = [(i * size, j * size, 0 if flat else i * j * size / 9) for j in range(rows + 1) for i in range(columns + 1)]
    elements, part = [], []
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            b, c, d = a + 1, a + columns + 2, a + columns + 1
            elements += [(a, b, c, -1), (a, c, d, -1)] if draw(st.booleans()) else [(a, b, c, d)]
            part += [draw(st.integers(0, 2))] * (len(elements) - len(part))
    parts = [beadmesh.Part(4, "roof", 0.8), beadmesh.Part(2, "floor", 1.25), beadmesh.Part(9, "wall", 2.0)]
    return beadmesh.Mesh(np.array(nodes), np.array(elements), part=part, parts=parts, title="by chance")


def rows_of(mesh):
    """Elements as sorted rows with the place of every corner, whatever the order."""
    return sorted(tuple(map(tuple, np.round(mesh.nodes[e[e >= 0]], 5) + 0.0)) for e in mesh.elements)


@quiet
@given(made=any_mesh(), offset=st.sampled_from([0, 1, 5000]))
@pytest.mark.parametrize("ending", ENDINGS)
def test_every_format_is_read_back(tmp_path_factory, ending, made, offset):
    path = tmp_path_factory.mktemp("deck") / f"mesh.{ending}"
    made.write(path, id_offset=offset)
    back = beadmesh.Mesh.from_meshio(meshio.read(path))
    assert len(back.quads) == len(made.quads) and len(back.triangles) == len(made.triangles)
    assert rows_of(back) == rows_of(made)


@quiet
@given(made=any_mesh())
def test_meshio_and_back(made):
    back = beadmesh.Mesh.from_meshio(made.to_meshio())
    order = np.argsort(made.elements[:, 3] < 0, kind="stable")  # quads first
    assert np.array_equal(back.nodes, made.nodes)
    assert np.array_equal(back.elements, made.elements[order])
    assert [back.parts[p].id for p in back.part] == [made.parts[p].id for p in made.part[order]]
    assert [back.parts[p].thickness for p in back.part] == [made.parts[p].thickness for p in made.part[order]]


def test_from_meshio_takes_plane_points_and_leaves_lines_out():
    foreign = meshio.Mesh([(0, 0), (1, 0), (1, 1)], [("line", [(0, 1)]), ("triangle", [(0, 1, 2)])])
    made = beadmesh.Mesh.from_meshio(foreign)
    assert made.nodes.shape == (3, 3) and made.elements.tolist() == [[0, 1, 2, -1]]
    assert len(beadmesh.Mesh.from_meshio(meshio.Mesh([(0, 0, 0)], [])).elements) == 0


def test_what_cannot_be_written(mesh, tmp_path):
    square = dict(nodes=[(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], elements=[(0, 1, 2, 3)])
    for made, path, code in ((beadmesh.Mesh(**square), tmp_path / "a.xyz", "write.ending"),
                             (beadmesh.Mesh(**square), tmp_path / "no" / "a.bdf", "write.folder"),
                             (beadmesh.Mesh(square["nodes"], np.zeros((0, 4))), tmp_path / "a.bdf", "write.mesh"),
                             (beadmesh.Mesh(**square, part=[3]), tmp_path / "a.bdf", "write.mesh"),
                             (beadmesh.Mesh(**square, part=[0, 0]), tmp_path / "a.bdf", "python.shape")):
        with pytest.raises(beadmesh.BeadmeshError) as caught:
            made.write(path)
        assert caught.value.code == code
    with pytest.raises(beadmesh.BeadmeshError, match="modes, none"):
        mesh.write(tmp_path / "a.bdf", analysis="crash")
    assert list(tmp_path.iterdir()) == []


def test_the_report(mesh, tmp_path):
    mesh.write_report(tmp_path / "panel.html")
    text = (tmp_path / "panel.html").read_text()
    assert "<title>basic.step</title>" in text and 'id="scene"' in text and '<tr data-bead="4">' in text
    mesh.write_report(str(tmp_path / "panel.svg"))
    assert "<svg" in (tmp_path / "panel.svg").read_text()
    foreign = beadmesh.Mesh(np.zeros((4, 3)), np.array([(0, 1, 2, 3)]))
    for made, path, code in ((mesh, "panel.pdf", "usage.report"), (mesh, "no/panel.html", "write.folder"),
                             (foreign, "other.html", "usage.report")):
        with pytest.raises(beadmesh.BeadmeshError) as caught:
            made.write_report(tmp_path / path)
        assert caught.value.code == code
    assert sorted(path.name for path in tmp_path.iterdir()) == ["panel.html", "panel.svg"]


def test_an_interrupt_ends_the_work_early(panel, mesh):
    """A mesh of many small elements takes minutes; the signal comes after a moment, and everything works on afterwards."""
    asked = []

    def interrupt(number, frame):
        asked.append(time.monotonic())
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        with pytest.raises(KeyboardInterrupt):
            beadmesh.mesh(panel, size=1.2)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert len(asked) == 1
    assert len(beadmesh.mesh(panel, size=12).elements) < len(mesh.elements)
