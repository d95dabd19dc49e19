"""Random panels through the program: every one must keep the hard rules (hard_rules.py).

    python3 tests/cli/random_panels.py --first 1 --count 1000 --program .../beadmesh --make-panel .../make_example_panel

Panel N is the same on every machine: sheet, base, beads, holes, element size and minimum edge follow from N. A panel
that fails is named with the commands that make it, and its number is a test to be added. Exit status: 0 all sound,
1 some are not.
"""
import argparse
import concurrent.futures
import os
import pathlib
import random
import subprocess
import sys
import tempfile

import hard_rules


class Recipe:
    """All choices for panel `number`."""

    def __init__(self, number):
        chance = random.Random(number)
        self.number = number
        self.length = chance.uniform(120, 300)
        self.breadth = max(80, self.length * chance.uniform(0.5, 1))
        self.base = chance.choice(["flat", "cylinder", "double", "saddle"])
        self.beads = round(self.length * self.breadth / 10000 * chance.uniform(0.3, 2.5))
        self.size = chance.choice([3, 4, 5, 5, 6, 8, 10])
        self.min_edge = round(self.size * chance.choice([0.3, 0.4, 0.5, 0.5]), 2)

    def make(self, program, step):
        return [program, "random", step, "--seed", str(self.number), "--beads", str(self.beads), "--base", self.base,
                "--length", f"{self.length:.1f}", "--breadth", f"{self.breadth:.1f}"]

    def mesh(self, program, step, deck):
        return [program, "mesh", step, "-o", deck, "--size", str(self.size), "--min-edge", str(self.min_edge), "--jobs", "1"]


def run_one(number, program, make_panel, folder, limit=300):
    """Complaints about one panel: empty where it is sound."""
    recipe = Recipe(number)
    step, deck = (str(pathlib.Path(folder) / f"random-{number}{ending}") for ending in (".step", ".bdf"))
    made = subprocess.run(recipe.make(make_panel, step), capture_output=True, text=True, check=False)
    if made.returncode:
        return ["no panel: " + made.stderr]
    try:
        meshed = subprocess.run(recipe.mesh(program, step, deck), capture_output=True, text=True, check=False, timeout=limit)
    except subprocess.TimeoutExpired:
        return [f"more than {limit} s"]
    if meshed.returncode not in (0, 1) or not os.path.exists(deck):
        return [f"exit status {meshed.returncode}: {meshed.stderr.strip()}"]
    broken = hard_rules.broken_rules(deck, recipe.min_edge)
    broken += [line for line in meshed.stderr.splitlines() if line.startswith("error")]
    if not broken:
        os.remove(step)
        os.remove(deck)
    return broken


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--program", default=os.environ.get("BEADMESH", "build/release/apps/beadmesh/beadmesh"))
    parser.add_argument("--make-panel",
                        default=os.environ.get("MAKE_EXAMPLE_PANEL", "build/release/examples/make_example_panel"))
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--keep", help="folder for the panels that fail")
    options = parser.parse_args()
    failed = 0
    with tempfile.TemporaryDirectory() as scratch, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        folder = options.keep or scratch
        os.makedirs(folder, exist_ok=True)
        numbers = range(options.first, options.first + options.count)
        outcomes = pool.map(lambda n: run_one(n, options.program, options.make_panel, folder), numbers)
        for number, broken in zip(numbers, outcomes):
            if not broken:
                continue
            failed += 1
            recipe = Recipe(number)
            print(f"panel {number}: {'; '.join(broken)}")
            print("  " + " ".join(recipe.make("make_example_panel", "p.step")))
            print("  " + " ".join(recipe.mesh("beadmesh", "p.step", "p.bdf")), flush=True)
    print(f"{options.count - failed} of {options.count} panels keep the hard rules")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
