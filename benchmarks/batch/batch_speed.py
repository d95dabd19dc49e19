#!/usr/bin/env python3
"""A batch of many panels: how well it keeps the cores busy, and that it loses nothing whatever happens.

    benchmarks/batch/batch_speed.py BEADMESH MAKE_EXAMPLE_PANEL [--panels 200] [--jobs 2] [--folder DIR] [--trouble-only]

First the panels are meshed with one worker and with several. `speed-up` is the time of one worker over that of several; it needs
a machine with nothing else to do. `workers at work` is the mean number of workers alive: the sum of their times over the time of
the batch; it does not depend on what else the machine does, and shows what the batch itself wastes. `processor seconds` are those
of the panels with one worker and with several: where they grow, the cores wait for memory or share what they compute with.

Then once more with ten broken files among them, while a worker is killed and the disk (a file system of its own in memory, which
takes the right to mount) fills up; then space is made, and the batch is called again. Every panel must be named in the first run
as done or with what went wrong, and in the end every deck must be that of the undisturbed run. Exit status 1 where it is not.
"""
import argparse
import csv
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

BROKEN = {"empty": b"", "words": b"no panel\n", "binary": bytes(range(256)) * 40}


def make_panels(program, folder, count):
    """Random panels of one seed each, small ones: two hundred large ones take a quarter of an hour."""
    folder.mkdir()
    kinds = min(count, 20)  # twenty different ones; the rest are copies under other names
    for i in range(kinds):
        subprocess.run([program, "random", folder / f"panel_{i:03}.step", "--seed", str(i + 1), "--beads", "1",
                        "--length", "160", "--breadth", "110"], check=True, stdout=subprocess.DEVNULL)
    for i in range(kinds, count):
        shutil.copy(folder / f"panel_{i % kinds:03}.step", folder / f"panel_{i:03}.step")


def command(program, panels, out, jobs):
    return [program, "batch", panels, "--out", out, "--jobs", str(jobs), "--report", "none", "--size", "8", "--min-edge", "4"]


def batch(program, panels, out, jobs):
    """Seconds of the batch, seconds and processor seconds of all its workers together."""
    shutil.rmtree(out, ignore_errors=True)
    start = time.monotonic()
    done = subprocess.run(command(program, panels, out, jobs), capture_output=True, text=True)
    seconds = time.monotonic() - start
    if done.returncode > 1:
        sys.exit(done.stderr)
    with open(out / "times.csv", newline="") as stream:
        rows = list(csv.DictReader(stream))
    return seconds, sum(float(row["seconds"]) for row in rows), sum(float(row["cpu_seconds"]) for row in rows)


def measure_speed(o, panels, folder):
    one, _, cpu_one = batch(o.beadmesh, panels, folder / "one", 1)
    many, work, cpu_many = batch(o.beadmesh, panels, folder / "many", o.jobs)
    print(f"{o.panels} panels: 1 worker {one:.1f} s, {o.jobs} workers {many:.1f} s")
    print(f"speed-up {one / many:.2f}; workers at work {work / many:.2f} of {o.jobs}; "
          f"processor seconds {cpu_one:.1f} with one, {cpu_many:.1f} with {o.jobs}", flush=True)


def add_broken(panels, folder):
    """A folder with the panels and ten files that are none; the names of these."""
    shutil.copytree(panels, folder)
    whole = sorted(panels.iterdir())[0].read_bytes()
    contents = list(BROKEN.values()) + [whole[:len(whole) * part // 8] for part in range(1, 8)]
    for i, content in enumerate(contents):
        (folder / f"broken_{i}.step").write_bytes(content)
    return {f"broken_{i}" for i in range(len(contents))}


def kill_a_worker(running):
    """The panel whose worker it was; None where there is none at the moment."""
    for child in pathlib.Path(f"/proc/{running.pid}/task/{running.pid}/children").read_text().split():
        try:
            words = pathlib.Path(f"/proc/{child}/cmdline").read_bytes().split(b"\0")
            if b"mesh" in words:
                os.kill(int(child), signal.SIGKILL)
                return pathlib.Path(words[2].decode()).stem
        except OSError:  # it has just ended
            continue
    return None


def fill(disk):
    """Takes all space that is left; the workers write meanwhile."""
    with open(disk / "filler", "wb", buffering=0) as stream:
        try:
            while stream.write(bytes(1 << 16)):
                pass
        except OSError:  # full
            pass


def disturbed(o, panels, disk):
    """What a batch printed while a worker was killed at a third of it and the disk was full from two thirds on."""
    running = subprocess.Popen(command(o.beadmesh, panels, disk / "out", o.jobs), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    killed, said, lines = None, [], 0
    for line in running.stderr:
        said.append(line)
        lines += line.startswith("[")
        if lines >= o.panels // 3 and killed is None:
            killed = kill_a_worker(running)
        if lines == 2 * o.panels // 3 and line.startswith("["):
            fill(disk)
    return running.stdout.read() + "".join(said), killed, running.wait()


def outcomes_of(printed):
    """By panel, from the lines of progress: `[3/210] panel_007: done in 0.4 s`."""
    return dict(re.findall(r"^\[\d+/\d+\] (\S+): (.*?)(?: in [\d.]+ s| before)?$", printed, re.M))


def decks(folder):
    return {path.stem: path.read_bytes() for path in folder.glob("panels/*/*.bdf")}


def check_trouble(o, panels, expected, disk, folder):
    broken = add_broken(panels, folder / "with_broken")
    printed, killed, status = disturbed(o, folder / "with_broken", disk)
    first, names = outcomes_of(printed), set(expected)
    lost = {name for name in names if first.get(name) != "done"}
    yield "every panel is named in the first run", first.keys() == names | broken
    yield "a worker was killed, and its panel done or not written for want of space", killed and first[killed] in ("done", "not written")
    yield "broken files are refused, or not even that could be written", all(first[name] in ("refused", "not written") for name in broken)
    yield "panels without space are named as not written", bool(lost) and all(first[name] == "not written" for name in lost)
    yield "the first run says that it fell short", status == 1
    yield "what is there is whole", all(deck == expected[name] for name, deck in decks(disk / "out").items())
    (disk / "filler").unlink()
    again = subprocess.run(command(o.beadmesh, folder / "with_broken", disk / "out", o.jobs), capture_output=True, text=True)
    summary = {row["name"]: row for row in json.loads((disk / "out" / "batch.json").read_text())["panels"]}
    yield "the second run does only what was lost", f"{len(names) - len(lost)} were done before" in again.stdout
    yield "in the end every deck is that of the undisturbed run", decks(disk / "out") == expected
    yield "the summary names the broken ones with a reason", {n for n, row in summary.items() if row["outcome"] != "done"} == broken and all(
        summary[name]["message"].startswith("error ") for name in broken)
    print(f"{len(names)} panels and {len(broken)} broken files: {len(lost)} not written on the full disk, worker of {killed} killed")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("beadmesh")
    parser.add_argument("make_example_panel")
    parser.add_argument("--panels", type=int, default=200)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--folder", type=pathlib.Path)
    parser.add_argument("--trouble-only", action="store_true", help="do not measure the time")
    o = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = o.folder or pathlib.Path(scratch)
        panels, disk = folder / "panels", folder / "disk"
        if not panels.exists():
            make_panels(o.make_example_panel, panels, o.panels)
        if o.trouble_only:
            batch(o.beadmesh, panels, folder / "many", o.jobs)
        else:
            measure_speed(o, panels, folder)
        disk.mkdir()
        space = 20_000_000 + 2 * sum(path.stat().st_size for path in (folder / "many").rglob("*") if path.is_file())
        mount = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={space}", "none", disk], capture_output=True, text=True)
        if mount.returncode:
            sys.exit("no right to mount, the disturbed run is left out: " + mount.stderr.strip())
        try:
            failed = [what for what, holds in check_trouble(o, panels, decks(folder / "many"), disk, folder) if not holds]
        finally:
            subprocess.run(["umount", disk], check=True)
    print("nothing lost, each named" if not failed else "FAILED: " + "; ".join(failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
