"""Many panels: manifests, what can go wrong with one of them, going on, the summary, Slurm's side."""
import csv
import hashlib
import html
import html.parser
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import time
import unittest

from command import PROGRAM, TIMEOUT, Case, example, run


def plate(length=20.0):
    """A flat plate as STL text: the smallest panel there is."""
    corners = [(0, 0, 0), (length, 0, 0), (length, length, 0), (0, length, 0)]
    facets = []
    for triangle in ((0, 1, 2), (0, 2, 3)):
        facets.append("facet normal 0 0 1\nouter loop")
        facets += ["vertex %g %g %g" % corners[i] for i in triangle]
        facets.append("endloop\nendfacet")
    return ("solid plate\n" + "\n".join(facets) + "\nendsolid plate\n").encode()


class BatchCase(Case):
    """A folder with panels, and one for results."""

    def setUp(self):
        super().setUp()
        self.out = self.folder / "out"
        self.panels = self.folder / "panels"
        self.panels.mkdir()

    def add_plates(self, count):
        for i in range(count):
            (self.panels / f"plate_{i:03}.stl").write_bytes(plate(20 + i))

    def batch(self, manifest=None, *options, status=0, **how):
        result = subprocess.run([PROGRAM, "batch", str(manifest or self.panels), "--out", str(self.out), *map(str, options)],
                                capture_output=True, text=True, timeout=TIMEOUT, **how)
        self.assertEqual(status, result.returncode, result.stderr + result.stdout)
        return result

    def summary(self):
        """Of the last batch: panels by name."""
        self.whole = json.loads((self.out / "batch.json").read_text())
        self.assertEqual("beadmesh.batch/1", self.whole["schema"])
        return {panel["name"]: panel for panel in self.whole["panels"]}

    def outcomes(self):
        return {name: panel["outcome"] for name, panel in self.summary().items()}

    def results(self, ignore=("log.txt", "state.json")):
        return {path.relative_to(self.out): path.read_bytes() for path in self.out.glob("panels/*/*")
                if path.name not in ignore}

    def assert_nothing_half(self):
        """No folder or file of work is left, and every panel's folder is whole."""
        for path in (self.out / "panels").rglob("*"):
            self.assertFalse(path.name.startswith("."), path)
        for folder in (self.out / "panels").iterdir():
            self.assertTrue((folder / "state.json").exists(), folder)
            self.assertTrue((folder / "log.txt").exists(), folder)


class Manifests(BatchCase):
    """The panels of a batch and what is asked of each."""

    def lines(self, *lines):
        return self.file("list.txt", "\n".join(lines).encode())

    def toml(self, text):
        return self.file("list.toml", text.encode())

    def size_of(self, name):
        """The element size that a deck says it was made with."""
        deck = (self.out / "panels" / name / f"{name}.bdf").read_text()
        return float(deck.split(", size ")[1].split(" mm")[0])

    def test_a_folder_and_those_below_it(self):
        self.add_plates(2)
        (self.panels / "left").mkdir()
        (self.panels / "left" / "door.stl").write_bytes(plate())
        (self.panels / "notes.txt").write_bytes(b"no panel")
        (self.panels / "state.stl").write_bytes(plate())
        self.out = self.panels / "out"  # results within the folder are no panels
        self.batch()
        (self.out / "panels" / "left_door" / "copy.stl").write_bytes(plate())
        self.batch()
        self.assertEqual(["left_door", "plate_000", "plate_001", "state_"], list(self.summary()))
        self.assertGreater(self.summary()["state_"]["mesh"]["quads"], 0)

    def test_a_list_with_options(self):
        self.add_plates(1)
        (self.panels / "with space.stl").write_bytes(plate())
        shutil.copy(self.panels / "plate_000.stl", self.panels / "quoted name.stl")
        self.file("coarse.toml", b"size = 8.0\n")
        manifest = self.lines("# a comment", "", "panels/plate_000.stl", "panels/with space.stl",
                              "'panels/quoted name.stl' --size 4 --thickness=2", "panels/plate_000.stl --config coarse.toml")
        self.batch(manifest)
        self.assertEqual(["plate_000", "with_space", "quoted_name", "plate_000-2"], list(self.summary()))
        self.assertEqual([5, 5, 4, 8], [self.size_of(name) for name in self.summary()])

    def test_defaults_and_panels_of_a_toml_manifest(self):
        self.add_plates(3)
        self.file("nvh.toml", b'preset = "nvh"\n')
        manifest = self.toml('[defaults]\nsize = 4.5\nmin_edge = 1.5\n[defaults.bead]\nmin_rise = 0.04\n'
                             '[[panel]]\ninput = "panels/plate_000.stl"\n'
                             '[[panel]]\nname = "fine"\ninput = "panels/plate_001.stl"\nsize = 3\n'
                             '[[panel]]\ninput = "panels/plate_002.stl"\nconfig = "nvh.toml"\noptions = ["--thickness", "2"]\n')
        self.batch(manifest)
        self.assertEqual(["plate_000", "fine", "plate_002"], list(self.summary()))
        self.assertEqual([4.5, 3, 10], [self.size_of(name) for name in self.summary()])

    def test_the_command_line_lies_between_defaults_and_panels(self):
        self.add_plates(2)
        manifest = self.toml('[defaults]\nsize = 4.5\n[[panel]]\ninput = "panels/plate_000.stl"\n'
                             '[[panel]]\ninput = "panels/plate_001.stl"\nsize = 3\n')
        self.batch(manifest, "--size", "6.5", "--min-edge", "1.25")
        self.assertEqual([6.5, 3], [self.size_of(name) for name in self.summary()])

    def test_the_resolved_manifest_gives_the_same(self):
        self.add_plates(2)
        manifest = self.toml('[defaults]\nsize = 4.1\n[[panel]]\nname = "a"\ninput = "panels/plate_000.stl"\n'
                             '[[panel]]\ninput = "panels/plate_001.stl"\noptions = ["--min-edge", "1.9"]\n')
        self.batch(manifest, "--thickness", "1.7")
        first, summary = self.results(), (self.out / "batch.json").read_bytes()
        result = self.batch(self.out / "batch.toml")
        self.assertIn("2 were done before", result.stdout)
        self.batch(self.out / "batch.toml", "--force")
        self.assertEqual(first, self.results())
        self.assertEqual(summary, (self.out / "batch.json").read_bytes())

    def test_wrong_manifests_are_refused_with_their_line(self):
        self.add_plates(1)
        panel = 'input = "panels/plate_000.stl"\n'
        for text, names in (("[defaults]\nsiz = 3\n[[panel]]\n" + panel, "list.toml:2"), ("[[panel]]\nsize = 3\n", "input"),
                            ("[[panel]]\n" + panel + "size = 'x'\n", "list.toml:3"), ("[[panel]]\n" + panel + "jobs = 3\n", "--threads"),
                            ("[[panel]]\n" + panel + "size = 3\nmin_edge = 4\n", "list.toml:1"), ("\nx = [1\n", "list.toml:2"),
                            ("[[panel]]\n" + panel + "name = '../up'\n", "../up"), ("panels = 1\n", "panels"), ("", "no panel"),
                            ("[[panel]]\n" + panel + "options = ['--json', 'x']\n", "--json"),
                            ("[[panel]]\n" + panel + "config = 'none.toml'\n", "none.toml"), ("panel = 3\n", "[[panel]]")):
            with self.subTest(text=text):
                self.assert_refused("batch", self.toml(text), "--out", self.out, names=names)
        for line, names in (("panels/plate_000.stl --sise 3", "list.txt:1"), ("'panels/plate_000.stl", "quote"),
                            ("panels/plate_000.stl -o x.bdf", "-o"), ("panels/plate_000.stl --help", "--help"),
                            ("# nothing", "no panel"), ("a.stl\0", "list.txt:1")):
            with self.subTest(line=line):
                self.assert_refused("batch", self.lines(line), "--out", self.out, names=names)
        self.assert_refused("batch", self.panels / "plate_000.stl", "--out", self.out, names="beadmesh mesh")
        self.assert_refused("batch", self.folder / "none", "--out", self.out, names="none")

    def test_wrong_options_are_refused(self):
        self.add_plates(1)
        for options in (("--deck", "xyz"), ("--deck", "../x.bdf"), ("--report", "pdf"), ("--timeout", "-1"), ("--memory", "nan"),
                        ("--threads", "0"), ("--submit",), ("--tasks", "3"), ("--task", "3", "--tasks", "2"), ("--task", "2"),
                        ("--slurm", "--collect"), ("--size", "0"), ("--preset", "x"), ("--slurm", "--slurm-option", "x")):
            with self.subTest(options=options):
                shutil.rmtree(self.out, ignore_errors=True)
                result = self.batch(None, *options, status=2)
                self.assertEqual(1, len(result.stderr.splitlines()), result.stderr)
                self.assertEqual("", result.stdout)


class Mishaps(BatchCase):
    """What befalls one panel stops no other and is named."""

    def test_ten_broken_inputs(self):
        self.add_plates(3)
        whole = example("single").read_bytes()
        broken = {"empty.step": b"", "cut.step": whole[:len(whole) // 2], "text.step": b"no step at all\n", "noise.stl": bytes(range(256)) * 9,
                  "cut.stl": plate()[:90], "cut.iges": b"S      1\n", "text.brep": b"DBRep_DrawableShape\n", "zero.stl": b"solid x\nendsolid x\n",
                  "nan.stl": plate().replace(b"20 20 0", b"nan nan nan")}
        for name, content in broken.items():
            (self.panels / f"broken_{name}").write_bytes(content)
        manifest = self.file("list.txt", "\n".join([f"panels/{path.name}" for path in sorted(self.panels.iterdir())] + ["panels/missing.step"]).encode())
        result = self.batch(manifest, status=1)
        outcomes = self.outcomes()
        self.assertEqual(["done"] * 3, [outcome for name, outcome in outcomes.items() if name.startswith("plate")])
        bad = {name: outcome for name, outcome in outcomes.items() if not name.startswith("plate")}
        self.assertEqual({"refused"}, set(bad.values()), bad)
        self.assertEqual(10, len(bad))
        for name in bad:
            self.assertIn("error read.", self.summary()[name]["message"])
            self.assertIn(name, result.stdout)
            self.assertIn("error read.", (self.out / "panels" / name / "log.txt").read_text())
        self.assertEqual({"panels": 13, "done": 3, "fell_short": 0, "failed": 10, "not_run": 0},
                         {key: self.whole["totals"][key] for key in ("panels", "done", "fell_short", "failed", "not_run")})
        self.assert_nothing_half()

    def test_a_panel_past_its_time(self):
        self.add_plates(2)
        (self.panels / "large.stl").write_bytes(plate(400))
        manifest = self.file("list.txt", b"panels/large.stl --size 0.3\npanels/plate_000.stl\npanels/plate_001.stl\n")
        self.batch(manifest, "--timeout", "4", status=1)
        self.assertEqual({"large": "timed out", "plate_000": "done", "plate_001": "done"}, self.outcomes())
        self.assertIn("4 s", self.summary()["large"]["message"])
        self.assert_nothing_half()

    def test_a_panel_past_its_memory(self):
        self.add_plates(2)
        (self.panels / "large.stl").write_bytes(plate(400))
        manifest = self.file("list.txt", b"panels/large.stl --size 0.3\npanels/plate_000.stl\npanels/plate_001.stl\n")
        self.batch(manifest, "--memory", "110", status=1)
        self.assertEqual({"large": "out of memory", "plate_000": "done", "plate_001": "done"}, self.outcomes())
        self.assertIn("internal.memory", self.summary()["large"]["message"])

    def start(self, *options):
        batch = subprocess.Popen([PROGRAM, "batch", str(self.manifest), "--out", str(self.out), "--jobs", "2", *options],
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(batch.stderr.close)
        self.addCleanup(batch.stdout.close)
        self.addCleanup(batch.wait)
        self.addCleanup(batch.kill)
        return batch

    def slow_batch(self, *options):
        """A batch at work on a panel that takes a while; the process of that panel."""
        self.add_plates(3)
        (self.panels / "slow.step").write_bytes(example("basic").read_bytes())
        self.manifest = self.file("list.txt", b"panels/slow.step --size 4\n" + b"".join(b"panels/plate_%03d.stl\n" % i for i in range(3)))
        batch = self.start(*options)
        return batch, self.worker_of(batch, "slow.step")

    def worker_of(self, batch, name, other_than=None):
        deadline = time.monotonic() + TIMEOUT
        while time.monotonic() < deadline:
            children = pathlib.Path(f"/proc/{batch.pid}/task/{batch.pid}/children").read_text().split()
            for child in children:
                try:
                    words = pathlib.Path(f"/proc/{child}/cmdline").read_bytes()
                except OSError:
                    continue
                if name.encode() in words and b"\0mesh\0" in words and int(child) != other_than:
                    return int(child)
            time.sleep(0.01)
        self.fail(f"no worker for {name}")

    def test_a_killed_worker_is_tried_again(self):
        batch, worker = self.slow_batch()
        os.kill(worker, signal.SIGKILL)
        batch.communicate(timeout=TIMEOUT)
        self.assertIn(self.outcomes()["slow"], ("done", "fell short"))
        self.assertEqual(2, json.loads((self.out / "panels/slow/state.json").read_text())["cost"]["attempts"])
        self.assert_nothing_half()

    def test_a_worker_killed_twice_is_named_and_done_by_the_next_call(self):
        batch, worker = self.slow_batch()
        os.kill(worker, signal.SIGKILL)
        os.kill(self.worker_of(batch, "slow.step", worker), signal.SIGKILL)
        out, _ = batch.communicate(timeout=TIMEOUT)
        self.assertEqual(1, batch.returncode)
        self.assertIn("signal 9", out)
        self.assertEqual({"slow": "killed", "plate_000": "done", "plate_001": "done", "plate_002": "done"}, self.outcomes())
        self.assertEqual(9, self.summary()["slow"]["signal"])
        self.batch(self.manifest, status=self.status_of_slow())
        self.assertIn(self.outcomes()["slow"], ("done", "fell short"))

    def test_a_crash_is_named_and_not_tried_again(self):
        batch, worker = self.slow_batch()
        os.kill(worker, signal.SIGILL)  # others are caught while a panel is read
        batch.communicate(timeout=TIMEOUT)
        self.assertEqual("crashed", self.outcomes()["slow"])
        self.assertEqual(1, json.loads((self.out / "panels/slow/state.json").read_text())["cost"]["attempts"])

    def status_of_slow(self):
        return run("mesh", self.panels / "slow.step", "-o", self.folder / "x.bdf", "--size", "4").returncode

    def test_an_interrupted_batch_ends_its_workers_and_goes_on_later(self):
        batch, worker = self.slow_batch()
        batch.send_signal(signal.SIGTERM)
        out, _ = batch.communicate(timeout=TIMEOUT)
        self.assertEqual(1, batch.returncode)
        self.assertFalse(pathlib.Path(f"/proc/{worker}").exists())
        self.assertEqual("not run", self.outcomes()["slow"])
        self.assert_nothing_half()

    def test_a_killed_batch_leaves_no_worker_and_goes_on_later(self):
        batch, worker = self.slow_batch()
        batch.kill()
        batch.communicate(timeout=TIMEOUT)
        deadline = time.monotonic() + TIMEOUT
        while pathlib.Path(f"/proc/{worker}/exe").exists() and time.monotonic() < deadline:
            time.sleep(0.02)
        self.manifest = self.file("list.txt", b"".join(b"panels/plate_%03d.stl\n" % i for i in range(3)))
        self.batch(self.manifest)
        self.assertEqual(["done"] * 3, list(self.outcomes().values()))
        self.assert_nothing_half()

    def test_two_batches_do_not_share_a_folder(self):
        batch, _ = self.slow_batch()
        result = self.batch(self.manifest, status=2)
        self.assertIn("batch.busy", result.stderr)
        self.assertIsNone(batch.poll())

    def test_files_that_cannot_be_written_to_their_end(self):
        """A limit on the size of files acts as a full disk does on the large ones."""
        self.add_plates(1)
        (self.panels / "wide.stl").write_bytes(plate(500))
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1_200_000, 1_200_000))
        result = self.batch(None, status=1, preexec_fn=limit)
        self.assertEqual({"plate_000": "done", "wide": "not written"}, self.outcomes())
        self.assertIn("error write.full", self.summary()["wide"]["message"])
        self.assertIn("wide", result.stdout)
        self.assertEqual(["log.txt"], [pathlib.Path(file).name for file in self.summary()["wide"]["files"]])
        self.assert_nothing_half()
        result = self.batch()
        self.assertIn("1 were done before", result.stdout)
        self.assertEqual(["done"] * 2, list(self.outcomes().values()))

    def test_a_full_disk(self):
        """A small file system of its own, where the tests may mount one."""
        disk = self.folder / "disk"
        disk.mkdir()
        mount = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1m", "none", str(disk)], capture_output=True, text=True)
        if mount.returncode:
            self.skipTest("no right to mount: " + mount.stderr.strip())
        self.addCleanup(subprocess.run, ["umount", str(disk)], check=True)
        self.add_plates(40)
        self.out = disk / "out"
        result = self.batch(None, "--report", "none", "--size", "1", status=1)
        lost = [line.split()[0] for line in result.stdout.splitlines() if "not written" in line]
        kept = [path.name for path in (self.out / "panels").iterdir() if not path.name.startswith(".")]
        self.assertGreater(len(lost), 0)
        self.assertGreater(len(kept), 0)
        self.assertEqual(40, len(set(lost) | set(kept)))
        for name in set(kept) - set(lost):  # whole, though the disk is full
            self.assertTrue((self.out / "panels" / name / f"{name}.bdf").read_text().endswith("ENDDATA\n"))
        subprocess.run(["mount", "-o", "remount,size=100m", str(disk)], check=True)
        result = self.batch(None, "--report", "none", "--size", "1")
        self.assertIn(f"{40 - len(lost)} were done before", result.stdout)
        self.assertEqual(["done"] * 40, list(self.outcomes().values()))
        self.assert_nothing_half()


class Resuming(BatchCase):
    """A second call does what is new, and nothing else."""

    def ages(self):
        return {path.name: (path / "state.json").stat().st_mtime_ns for path in (self.out / "panels").iterdir()}

    def done_again(self, *options, status=0):
        before = self.ages()
        self.batch(None, *options, status=status)
        return sorted(name for name, age in self.ages().items() if before.get(name) != age)

    def test_only_what_has_changed_is_done_again(self):
        self.add_plates(3)
        self.batch()
        self.assertEqual([], self.done_again())
        (self.panels / "plate_001.stl").write_bytes(plate(33))
        self.assertEqual(["plate_001"], self.done_again())
        (self.panels / "new.stl").write_bytes(plate(12))
        self.assertEqual(["new"], self.done_again())
        (self.out / "panels/plate_002/plate_002.bdf").unlink()
        self.assertEqual(["plate_002"], self.done_again())
        (self.out / "panels/plate_000/state.json").write_text("{ no state")
        self.assertEqual(["plate_000"], self.done_again())
        everything = ["new", "plate_000", "plate_001", "plate_002"]
        self.assertEqual(everything, self.done_again("--size", "4"))
        self.assertEqual([], self.done_again("--size", "4", "--jobs", "1", "--timeout", "99"))
        self.assertEqual(everything, self.done_again("--size", "4", "--force"))
        self.assertEqual(everything, self.done_again("--size", "4", "--report", "none"))

    def test_another_version_does_all_again(self):
        self.add_plates(1)
        self.batch()
        state = self.out / "panels/plate_000/state.json"
        value = json.loads(state.read_text())
        value["version"] = "0.0.0"
        state.write_text(json.dumps(value))
        self.assertEqual(["plate_000"], self.done_again())

    def test_what_failed_is_tried_again(self):
        self.add_plates(1)
        (self.panels / "bad.stl").write_bytes(b"")
        self.batch(status=1)
        self.assertEqual(["bad"], self.done_again(status=1))
        (self.panels / "bad.stl").write_bytes(plate())
        self.assertEqual(["bad"], self.done_again())

    def test_the_hash_is_sha256(self):
        for length in (0, 1, 55, 56, 63, 64, 65, 1000, 70000):
            (self.panels / f"n{length}.stl").write_bytes(b"x" * length)
        self.batch(status=1)
        for state in self.out.glob("panels/*/state.json"):
            value = json.loads(state.read_text())
            expected = hashlib.sha256(pathlib.Path(value["input"]).read_bytes()).hexdigest()
            self.assertEqual(expected, value["input_sha256"])


class PageParser(html.parser.HTMLParser):
    """Links, rows and ids of a page; anything it would load from elsewhere."""

    def __init__(self):
        super().__init__()
        self.links, self.rows, self.loads = [], 0, []

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.rows += tag == "tr"
        if tag == "a":
            self.links.append(attributes["href"])
        if "src" in attributes or tag == "link":
            self.loads.append((tag, attributes))


class Summaries(BatchCase):
    """JSON, CSV and page say the same, whatever the order in which panels were done."""

    def fill(self, panel="single"):
        self.add_plates(3)
        (self.panels / "beads.step").write_bytes(example(panel).read_bytes())
        (self.panels / 'a "b" & <c>.stl').write_bytes(b"")
        (self.panels / "ümlaut #1.stl").write_bytes(plate())

    def test_three_forms_of_one_summary(self):
        self.fill("basic")
        self.batch(None, "--size", "8", status=1)
        panels = self.summary()
        with open(self.out / "batch.csv", newline="") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual(list(panels), [row["name"] for row in rows])
        self.assertEqual([panel["outcome"] for panel in panels.values()], [row["outcome"] for row in rows])
        self.assertEqual([panel["input"] for panel in panels.values()], [row["input"] for row in rows])
        table = json.loads((self.out / "panels/beads/beads.json").read_text())
        beads = panels["beads"]["beads"]
        for kind in ("I", "generic", "annular"):
            self.assertEqual(sum(bead["kind"] == kind for bead in table["beads"]), beads[kind])
        self.assertEqual(table["mesh"]["quads"], panels["beads"]["mesh"]["quads"])
        self.assertEqual(table["mesh"]["quality"]["scaled_jacobian_min"], panels["beads"]["mesh"]["scaled_jacobian_min"])
        self.assertEqual(sum(panel["mesh"]["nodes"] for panel in panels.values() if "mesh" in panel), self.whole["totals"]["nodes"])
        self.assertEqual(table["mesh"]["quads"], int(next(row for row in rows if row["name"] == "beads")["quads"]))
        for panel in panels.values():
            for file in panel["files"]:
                self.assertTrue((self.out / file).is_file(), file)

    def test_the_page(self):
        self.fill()
        self.batch(status=1)
        page = PageParser()
        text = (self.out / "batch.html").read_text()
        page.feed(text)
        self.assertEqual([], page.loads)
        self.assertEqual(7, page.rows)
        self.assertNotIn("<c>", text.replace("&lt;c&gt;", ""))
        from urllib.parse import unquote
        linked = {unquote(link) for link in page.links}
        self.assertEqual({file for panel in self.summary().values() for file in panel["files"]}, linked)

    def test_the_page_sorts_and_filters(self):
        browser = shutil.which("chromium")
        if not browser:
            self.skipTest("not installed: chromium")
        for name, length in (("b_small", 10), ("a_large", 60), ("c_middle", 30)):
            (self.panels / f"{name}.stl").write_bytes(plate(length))
        (self.panels / "broken.stl").write_bytes(b"")
        self.batch(status=1)
        page = (self.out / "batch.html").read_text().replace("</html>", """<script>{
            const shown = () => [...document.querySelectorAll("tbody tr")].filter(r => !r.hidden).map(r => r.cells[0].textContent.trim());
            const head = [...document.querySelectorAll("th button")].find(b => b.textContent === "quads");
            const steps = [];
            head.click(), steps.push(shown()), head.click(), steps.push(shown());
            const outcome = document.getElementById("outcome"), text = document.getElementById("text");
            outcome.value = "bad", outcome.dispatchEvent(new Event("change")), steps.push(shown());
            outcome.value = "", text.value = "LARGE", text.dispatchEvent(new Event("input")), steps.push(shown());
            document.title = JSON.stringify(steps);}</script></html>""")
        result = subprocess.run([browser, "--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking",
                                 f"--user-data-dir={self.folder / 'browser'}", "--dump-dom", str(self.file("page.html", page.encode()))],
                                capture_output=True, text=True, timeout=TIMEOUT)
        steps = json.loads(html.unescape(result.stdout.split("<title>")[1].split("</title>")[0]))
        up = ["broken", "b_small", "c_middle", "a_large"]
        self.assertEqual([up, up[::-1], ["broken"], ["a_large"]], steps)

    def test_the_same_bytes_for_any_number_of_workers(self):
        self.fill()
        self.batch(None, "--jobs", "3", status=1)
        names = "batch.json", "batch.csv", "batch.html", "batch.toml"
        first = [(self.out / name).read_bytes() for name in names], self.results()
        self.batch(None, "--jobs", "1", "--threads", "2", "--force", status=1)
        self.assertEqual(first, ([(self.out / name).read_bytes() for name in names], self.results()))

    def test_a_panel_gets_what_mesh_alone_gives(self):
        (self.panels / "beads.step").write_bytes(example("single").read_bytes())
        self.batch(None, "--size", "6")
        run("mesh", self.panels / "beads.step", "-o", self.folder / "x.bdf", "--size", "6")
        self.assertEqual((self.folder / "x.bdf").read_bytes(), (self.out / "panels/beads/beads.bdf").read_bytes())
        command = (self.out / "panels/beads/log.txt").read_text().splitlines()[0]
        self.assertTrue(command.startswith("beadmesh mesh "), command)
        (self.out / "panels/beads/beads.bdf").unlink()
        subprocess.run(command.replace("beadmesh", PROGRAM, 1), shell=True, check=True, capture_output=True)
        self.assertEqual((self.folder / "x.bdf").read_bytes(), (self.out / "panels/beads/beads.bdf").read_bytes())


if __name__ == "__main__":
    unittest.main()
