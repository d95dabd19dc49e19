"""How the tests run the program: environment, example panels, expectations on a failure."""
import functools
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["BEADMESH"]
MAKE_EXAMPLE_PANEL = os.environ["MAKE_EXAMPLE_PANEL"]
EXAMPLES = pathlib.Path(os.environ["EXAMPLE_FOLDER"])
TIMEOUT = 120  # seconds: a hang is a failure, not a wait


def run(*arguments):
    """The finished run of the program."""
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=TIMEOUT)


@functools.cache
def example(name):
    """Path of an example panel or broken input, made once for all tests."""
    path = EXAMPLES / f"{name}.step"
    if not path.exists():
        EXAMPLES.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=EXAMPLES) as folder:
            part = pathlib.Path(folder) / path.name
            subprocess.run([MAKE_EXAMPLE_PANEL, name, part], check=True, timeout=TIMEOUT)
            part.replace(path)
    return path


@functools.cache
def truth(name):
    """The features of an example panel."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "truth.json"
        subprocess.run([MAKE_EXAMPLE_PANEL, name, pathlib.Path(folder) / "panel.step", path], check=True, timeout=TIMEOUT)
        return json.loads(path.read_text())["features"]


def polygon(loop):
    """Points along a loop of lines and arcs."""
    points = []
    for edge in loop:
        if edge["t"] == "L":
            points.append(edge["p"])
            continue
        (x, y), r, a, turn = edge["c"], edge["r"], edge["a0"], edge["ang"]
        points += [(x + r * math.cos(a + turn * i / 32), y + r * math.sin(a + turn * i / 32)) for i in range(32)]
    return points


def contains(feature, point):
    """Even-odd test of a plan point against the loops of a feature."""
    x, y, inside = point[0], point[1], False
    for loop in map(polygon, feature["footprint"]):
        for (ax, ay), (bx, by) in zip(loop, loop[1:] + loop[:1]):
            if (ay > y) != (by > y) and x < ax + (bx - ax) * (y - ay) / (by - ay):
                inside = not inside
    return inside


class Case(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, content=b""):
        """A new file in the folder."""
        path = self.folder / name
        path.write_bytes(content)
        return path

    def assert_refused(self, *arguments, names=None):
        """Exit status 2, one line on stderr that holds `names`, nothing on stdout, no file made or changed. Returns the line."""
        before = self.contents()
        result = run(*arguments)
        self.assertEqual(2, result.returncode, result.stderr)
        lines = [line for line in result.stderr.splitlines() if line.strip()]
        self.assertEqual(1, len(lines), result.stderr)
        if names is not None:
            self.assertIn(str(names), lines[0])
        self.assertEqual("", result.stdout)
        self.assertEqual(before, self.contents())
        return lines[0]

    def contents(self):
        return {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
