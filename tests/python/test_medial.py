"""Medial objects of polygons with known answers, of polygons by chance, and of faces."""
import math

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import beadmesh

quiet = settings(deadline=None, max_examples=60, derandomize=True,
                 suppress_health_check=[HealthCheck.function_scoped_fixture])
length = st.floats(1.0, 1e3)


def rectangle(a, b, turn=0.0, at=(0.0, 0.0)):
    c, s = math.cos(turn), math.sin(turn)
    return np.array([(0, 0), (a, 0), (a, b), (0, b)]) @ [[c, s], [-s, c]] + at


def distance_to(loops, p):
    """From a point to the nearest segment of closed loops."""
    best = math.inf
    for loop in loops:
        a, b = loop, np.roll(loop, -1, axis=0)
        u = b - a
        t = np.clip(((p - a) * u).sum(1) / (u * u).sum(1), 0, 1)
        best = min(best, np.linalg.norm(a + u * t[:, None] - p, axis=1).min())
    return best


@quiet
@given(a=length, ratio=st.floats(1.1, 20), turn=st.floats(0, 6.3))
def test_axis_of_a_rectangle(a, ratio, turn):
    b = a / ratio
    medial = beadmesh.medial([rectangle(a, b, turn, (3 * a, -a))])
    assert sorted(medial.vertex_types) == ["C"] * 4 + ["J"] * 2
    assert sorted(edge.type for edge in medial.edges) == ["C-J"] * 4 + ["J-J"]
    assert medial.length == pytest.approx(a - b + 4 * b / math.sqrt(2), rel=1e-6)
    junctions = [r for r, kind in zip(medial.vertex_radii, medial.vertex_types) if kind == "J"]
    assert junctions == pytest.approx([b / 2] * 2, rel=1e-6)
    middle = next(edge for edge in medial.edges if edge.type == "J-J")
    assert middle.thickness == pytest.approx((b, b, b), rel=1e-6)
    assert middle.subtended_angles == pytest.approx(180, abs=1e-4)


@st.composite
def star(draw):
    """A star-shaped polygon, seldom convex."""
    count = draw(st.integers(3, 14))
    radii = draw(st.lists(st.floats(2.0, 10.0), min_size=count, max_size=count))
    angles = 2 * math.pi * np.arange(count) / count
    return np.column_stack([np.cos(angles), np.sin(angles)]) * np.array(radii)[:, None]


@quiet
@given(loop=star())
def test_every_circle_touches_the_boundary(loop):
    medial = beadmesh.medial([loop], corners=[[True] * len(loop)])
    for edge in medial.edges:
        n = len(edge.points)
        assert edge.points.shape == (n, 2) and edge.radii.shape == (n,)
        assert edge.feet.shape == (n, 2, 2) and edge.subtended_angles.shape == (n,)
        assert edge.space is None
        for k in range(n):
            assert distance_to([loop], edge.points[k]) == pytest.approx(edge.radii[k], abs=1e-6)
            for side in (0, 1):
                assert np.linalg.norm(edge.feet[k, side] - edge.points[k]) == pytest.approx(edge.radii[k], abs=1e-6)
    assert len(medial.edges) == len(medial.vertex_types) - 1  # a tree: no hole


@quiet
@given(loop=star(), shift=st.integers(0, 13), turned=st.booleans())
def test_where_the_loop_starts_and_turns_does_not_matter(loop, shift, turned):
    other = np.roll(loop, shift, axis=0)[::-1 if turned else 1]
    same = [beadmesh.medial([points], corners=[[True] * len(points)]) for points in (loop, other)]
    assert same[0].length == pytest.approx(same[1].length, rel=1e-6)
    assert sorted(same[0].vertex_types) == sorted(same[1].vertex_types)


@quiet
@given(st.lists(st.lists(st.tuples(st.floats(), st.floats()), max_size=6), max_size=3))
def test_any_points_give_an_object_or_an_error(loops):
    try:
        medial = beadmesh.medial([np.array(loop, float).reshape(-1, 2) for loop in loops])
        assert medial.edges or medial.vertex_types
    except beadmesh.BeadmeshError as error:
        assert error.code and error.message


def test_a_hole_makes_a_cycle():
    outer, hole = rectangle(60, 40), rectangle(20, 10, at=(20, 15))
    medial = beadmesh.medial([hole, outer])  # in any order
    assert [len(loop) for loop in medial.loops] == [4, 4]
    assert np.array_equal(medial.loops[0], outer)
    assert len(medial.edges) == len(medial.vertex_types)  # one more than a tree
    for v, edges in enumerate(medial.vertex_edges):
        for e in edges:
            assert v in (medial.edges[e].start, medial.edges[e].end)


def test_errors_name_loop_and_point():
    with pytest.raises(beadmesh.BeadmeshError, match="crosses") as caught:
        beadmesh.medial([[(0, 0), (1, 1), (1, 0), (0, 1)]])
    assert caught.value.code == "delaunay.region.crossing"
    with pytest.raises(beadmesh.BeadmeshError, match=r"\(4, 3\)") as caught:
        beadmesh.medial([np.zeros((4, 3))])
    assert caught.value.code == "python.shape"
    with pytest.raises(beadmesh.BeadmeshError) as caught:
        beadmesh.medial([rectangle(2, 1)], corners=[[True]])
    assert caught.value.code == "delaunay.region.attributes"


def test_of_a_file(tmp_path):
    path = tmp_path / "arc.wkt"
    path.write_text("CURVEPOLYGON(COMPOUNDCURVE((0 0, 40 0), CIRCULARSTRING(40 0, 45 5, 40 10), (40 10, 0 10), "
                    "CIRCULARSTRING(0 10, -5 5, 0 0)))")
    medial = beadmesh.medial_of_file(path)
    assert medial.vertex_types == ["S", "S"]
    assert medial.length == pytest.approx(40, abs=1e-4)


def test_of_faces(panel):
    objects, diagnostics = beadmesh.medials(panel, [2, 5])
    assert [one.face for one in objects] == [2, 5] and diagnostics == []
    assert [edge.type for edge in objects[0].edges] == ["S-S"]
    assert {edge.type for edge in objects[1].edges} == {"N"}
    for one in objects:
        for edge in one.edges:
            assert edge.space.shape == (len(edge.points), 3)
    with pytest.raises(beadmesh.BeadmeshError, match="no face 99"):
        beadmesh.medials(panel, [99])
