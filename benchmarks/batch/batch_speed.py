#!/usr/bin/env python3
"""How well `beadmesh batch` keeps the cores busy: many small panels with one worker and with several.

    benchmarks/batch/batch_speed.py BEADMESH MAKE_EXAMPLE_PANEL [--panels 200] [--jobs 2] [--folder DIR]

Prints two figures. `speed-up` is the time of one worker over that of several; it needs a machine with nothing else to do.
`workers at work` is the mean number of workers alive: the sum of their times over the time of the batch. It does not depend on
what else the machine does, and shows what the batch itself wastes.
"""
import argparse
import csv
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time


def make_panels(program, folder, count):
    """Random panels of one seed each."""
    folder.mkdir()
    kinds = min(count, 20)  # twenty different ones; the rest are copies under other names
    for i in range(kinds):
        subprocess.run([program, "random", folder / f"panel_{i:03}.step", "--seed", str(i + 1), "--beads", "2"], check=True,
                       stdout=subprocess.DEVNULL)
    for i in range(kinds, count):
        shutil.copy(folder / f"panel_{i % kinds:03}.step", folder / f"panel_{i:03}.step")


def batch(program, panels, out, jobs):
    """Seconds of the batch, and of all its workers together."""
    shutil.rmtree(out, ignore_errors=True)
    start = time.monotonic()
    done = subprocess.run([program, "batch", panels, "--out", out, "--jobs", str(jobs), "--report", "none"],
                          capture_output=True, text=True)
    seconds = time.monotonic() - start
    if done.returncode > 1:
        sys.exit(done.stderr)
    with open(out / "times.csv", newline="") as stream:
        return seconds, sum(float(row["seconds"]) for row in csv.DictReader(stream))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("beadmesh")
    parser.add_argument("make_example_panel")
    parser.add_argument("--panels", type=int, default=200)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--folder", type=pathlib.Path)
    o = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = o.folder or pathlib.Path(scratch)
        panels = folder / "panels"
        if not panels.exists():
            make_panels(o.make_example_panel, panels, o.panels)
        one, _ = batch(o.beadmesh, panels, folder / "one", 1)
        many, work = batch(o.beadmesh, panels, folder / "many", o.jobs)
    print(f"{o.panels} panels: 1 worker {one:.1f} s, {o.jobs} workers {many:.1f} s")
    print(f"speed-up {one / many:.2f}; workers at work {work / many:.2f} of {o.jobs}")


if __name__ == "__main__":
    main()
