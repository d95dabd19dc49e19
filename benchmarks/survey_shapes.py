#!/usr/bin/env python3
"""Meshes every bead shape over widths, heights, bases and sizes, and prints what became of each bead.

  survey_shapes.py BEADMESH MAKE_EXAMPLE_PANEL [--widths 8,16,40] [--shares 0.2,0.4] [--bases flat,double]
                   [--sizes 5/2.5,8/4] [--only T,comb] [--seed 0] [--random 1-20] [--folder DIR] [--all] [--json FILE]

Panels are those of `make_example_panel shapes` and, with --random, of `make_example_panel random`. A height is a share
of the width, between 2 and 10 mm. A row: method, worst scaled Jacobian in the bead and in the elements beside it,
irregular nodes in the bead, triangles, edges under the minimum element length (MEL), share of the crest that is covered
by element edges in plan, tips of the crest that end on the boundary, notes. Rows that hold the goals are printed with --all only.
--folder keeps panels, decks, tables and pictures. Needs: python3-numpy.
"""
import argparse
import collections
import json
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

GOALS = {"I": 0.85, "generic": 0.65, "annular": 0.93}
NEAR = 0.1  # mm, between a crest and the element edge that covers it, besides the sagitta of the element
TIME_LIMIT = 600  # seconds a run


# ---------------------------------------------------------------- the deck

def read_deck(path):
    """Points by node id, elements as lists of node ids, sets by id."""
    points, elements, sets, text = {}, {}, {}, ""
    lines = iter(path.read_text().splitlines())
    for line in lines:
        if line.startswith("SET "):
            name, text = line[4:].split(" = ")
            while text.rstrip().endswith(","):
                text += next(lines)
            sets[int(name)] = members(text)
        elif line.startswith("GRID*"):
            rest = next(lines)
            points[int(line[8:24])] = (float(line[40:56]), float(line[56:72]), float(rest[8:24]))
        elif line.startswith(("CQUAD4", "CTRIA3")):
            corners = 4 if line.startswith("CQUAD4") else 3
            elements[int(line[8:16])] = [int(line[24 + 8 * k:32 + 8 * k]) for k in range(corners)]
    return points, elements, sets


def members(text):
    """Ids of a SET: `1,4 THRU 6` is 1, 4, 5, 6."""
    ids = []
    for part in text.split(","):
        ends = [int(end) for end in part.split("THRU")]
        ids += range(ends[0], ends[-1] + 1)
    return ids


def scaled_jacobian(p):
    """Worst corner against the normal of the element, as Verdict defines it."""
    k = len(p)
    normal = np.cross(p[2] - p[0], p[3] - p[1]) if k == 4 else np.cross(p[1] - p[0], p[2] - p[0])
    normal /= max(np.linalg.norm(normal), 1e-300)
    worst = 1e300
    for i in range(k):
        a, b = p[(i + 1) % k] - p[i], p[i - 1] - p[i]
        worst = min(worst, np.dot(np.cross(a, b), normal) / max(np.linalg.norm(a) * np.linalg.norm(b), 1e-300))
    return float(worst if k == 4 else worst * 2 / 3 ** 0.5)


def sides(corners):
    return [tuple(sorted((corners[i - 1], corners[i]))) for i in range(len(corners))]


class Deck:
    def __init__(self, path):
        points, self.elements, self.sets = read_deck(path)
        self.points = {n: np.array(p) for n, p in points.items()}
        self.around, self.neighbours = collections.defaultdict(list), collections.defaultdict(set)
        for e, corners in self.elements.items():
            for n in corners:
                self.around[n].append(e)
            for a, b in sides(corners):
                self.neighbours[a].add(b)
                self.neighbours[b].add(a)

    def jacobian(self, element):
        return scaled_jacobian(np.array([self.points[n] for n in self.elements[element]]))

    def bead(self, number):
        """What the elements of a bead and those beside them are like."""
        own = set(self.sets[10000 + number])
        nodes = {n for e in own for n in self.elements[e]}
        beside = {e for n in nodes for e in self.around[n]} - own
        inner = [n for n in nodes if all(e in own for e in self.around[n])]
        return {"elements": len(own), "trias": sum(len(self.elements[e]) == 3 for e in own),
                "jacobian": min(self.jacobian(e) for e in own),
                "beside": min((self.jacobian(e) for e in beside), default=1.0),
                "irregular": sum(len(self.neighbours[n]) != 4 for n in inner), "lengths": self.lengths(own)}

    def lengths(self, own):
        return sorted(float(np.linalg.norm(self.points[a] - self.points[b]))
                      for a, b in {side for e in own for side in sides(self.elements[e])})

    def crest_edges(self, number):
        crest = set(self.sets.get(20000 + number, []))
        pairs = {s for e in self.sets[10000 + number] for s in sides(self.elements[e]) if crest.issuperset(s)}
        return np.array([[self.points[a][:2], self.points[b][:2]] for a, b in sorted(pairs)]).reshape(-1, 2, 2)


# ---------------------------------------------------------------- the crest

def even_points(line, step):
    """Points along a line as seen from above."""
    p = np.array(line)[:, :2]
    at = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(p, axis=0), axis=1))])
    t = np.linspace(0, at[-1], max(3, int(at[-1] / step) + 2))
    return np.stack([np.interp(t, at, p[:, k]) for k in range(2)], axis=1)


def sagitta(points, length):
    """What edges of this length around a point miss of the bow through the points."""
    reach = max(1, int(0.5 * length / max(np.linalg.norm(points[1] - points[0]), 1e-9)))
    if len(points) < 2 * reach + 1:
        return np.zeros(len(points))
    bow = np.linalg.norm(points[reach:-reach] - (points[:-2 * reach] + points[2 * reach:]) / 2, axis=1)
    bow = np.pad(bow, 2 * reach, mode="edge")  # the edge over a point may have its middle half a length away
    return np.lib.stride_tricks.sliding_window_view(bow, 2 * reach + 1).max(axis=1)


def crest_coverage(ridge, edges, size):
    """Share of the points along all crest lines that lie on an element edge between crest nodes, seen from above."""
    if not len(edges):
        return 0.0
    a, u = edges[:, 0], edges[:, 1] - edges[:, 0]
    covered = total = 0
    for line in ridge:
        points = even_points(line, 0.5)
        allowed = NEAR + sagitta(points, size)
        t = np.einsum("pek,ek->pe", points[:, None] - a, u) / np.maximum(np.einsum("ek,ek->e", u, u), 1e-300)
        gap = np.linalg.norm(points[:, None] - a - np.clip(t, 0, 1)[..., None] * u, axis=2).min(axis=1)
        covered += int((gap <= allowed).sum())
        total += len(points)
    return covered / total


def distance_to_loops(feature, point):
    best = 1e300
    for edge in (e for loop in feature["footprint"] for e in loop):
        if edge["t"] == "L":
            p, q = np.array(edge["p"]), np.array(edge["q"])
            t = np.clip(np.dot(point - p, q - p) / np.dot(q - p, q - p), 0, 1)
            best = min(best, np.linalg.norm(point - p - t * (q - p)))
            continue
        turns = edge["a0"] + edge["ang"] * np.linspace(0, 1, 200)
        arc = np.array(edge["c"]) + edge["r"] * np.stack([np.cos(turns), np.sin(turns)], axis=1)
        best = min(best, np.linalg.norm(arc - point, axis=1).min())
    return best


def loose_tips(ridge, feature):
    """Ends of the crest that lie neither on the boundary nor on another crest line."""
    ends = [np.array(line[k]) for line in ridge for k in (0, -1) if np.linalg.norm(np.subtract(line[0], line[-1])) > 1e-6]
    alone = [p for i, p in enumerate(ends) if all(np.linalg.norm(p - q) > 0.05 for j, q in enumerate(ends) if j != i)]
    return sum(bool(distance_to_loops(feature, p[:2]) > 0.3) for p in alone)


# ---------------------------------------------------------------- panels and rows

def bead_row(deck, bead, feature, size, min_edge):
    row = {"name": feature["name"], "kind": feature["paper_rule"], "width": round(feature["mean_width"], 1),
           "height": round(feature["height"], 1)}
    if bead is None:
        return {**row, "method": "not a bead"}
    row.update(deck.bead(bead["id"]), id=bead["id"], method=bead["mesh"]["method"], notes=bead["mesh"]["notes"],
               found=[bead["kind"], bead["shape"]], letter=bead["shape"] == feature["shape"],
               crest=crest_coverage(bead["ridge"], deck.crest_edges(bead["id"]), size),
               tips=loose_tips(bead["ridge"], feature))
    row["short"] = sum(length < min_edge * (1 - 1e-6) for length in row.pop("lengths"))
    return row


def shortfalls(row):
    """What a row misses of the goals, in words."""
    if row["method"] == "not a bead":
        return ["not a bead"] if row["kind"] != "none" else []
    out = [] if row["method"] == "blocks" else [row["method"]]
    out += [f"taken for {row['found'][0]}"] if row["kind"] not in ("none", row["found"][0]) else []
    out += [f"letter {row['found'][1]}"] if not row["letter"] else []
    out += ["jacobian"] if row["jacobian"] < GOALS.get(row["kind"], 0.65) else []
    out += ["triangles"] if row["trias"] else []
    out += ["under MEL"] if row["short"] else []
    out += ["crest"] if row["crest"] < 0.995 else []
    out += ["tips"] if row["tips"] else []
    return out


def text_of(row):
    if row["method"] == "not a bead":
        return f"{row['name']:15} {row['width']:4.0f} {row['height']:4.1f}  not a bead: {row.get('reason', '')}"
    return (f"{row['name']:15} {row['width']:4.0f} {row['height']:4.1f}  {row['method']:8} sj {row['jacobian']:5.2f} beside {row['beside']:5.2f} "
            f"irr {row['irregular']:3d} tri {row['trias']:2d} short {row['short']:2d} crest {row['crest']:.3f} "
            f"n {row['elements']:4d} {' '.join(row['found'])}  [{', '.join(shortfalls(row))}] {'; '.join(row['notes'])}")


class Survey:
    def __init__(self, arguments, folder):
        self.arguments, self.folder, self.rows = arguments, folder, []

    def panel(self, name, *options):
        """STEP file and features of a panel, made where it is not there yet."""
        step, truth = self.folder / f"{name}.step", self.folder / f"{name}.truth.json"
        if not truth.exists():
            subprocess.run([self.arguments.maker, *options[:1], step, truth, *map(str, options[1:])], check=True)
        return step, json.loads(truth.read_text())["features"]

    def mesh(self, name, step, features, size, min_edge):
        run = self.folder / f"{name}-{size:g}-{min_edge:g}"
        deck, table, picture = (run.with_name(run.name + ending) for ending in (".bdf", ".mesh.json", ".svg"))
        command = [self.arguments.program, "mesh", step, "-o", deck, "--size", f"{size:g}", "--min-edge", f"{min_edge:g}",
                   "--json", table, "--report", picture]
        start = time.time()
        try:
            done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=TIME_LIMIT)
            failed = "" if done.returncode in (0, 1) else f"exit {done.returncode}: {done.stderr.strip()}"
        except subprocess.TimeoutExpired:
            failed = f"no answer in {TIME_LIMIT} s"
        if failed:
            print(f"{run.name}: {failed}", flush=True)
            self.rows.append({"panel": run.name, "name": "panel", "kind": "none", "method": "not a bead", "reason": failed})
            return
        self.judge(run.name, deck, json.loads(table.read_text()), features, size, min_edge, time.time() - start)

    def judge(self, run, deck, table, features, size, min_edge, seconds):
        deck = Deck(deck)
        by_face = {face: bead for bead in table["beads"] for face in bead["faces"]}
        reasons = {f["face"]: f["reason"] for f in table["faces_not_beads"]}
        face, rows = 1, []  # the sheet comes first, then the features; holes have no face
        for feature in features:
            if feature["shape"] in ("hole", "slot"):
                continue
            face += 1
            rows.append(bead_row(deck, by_face.get(face), feature, size, min_edge))
            rows[-1].update(panel=run, reason=reasons.get(face, ""))
        quality = table["mesh"]["quality"]
        print(f"{run}: {seconds:.1f} s, {table['mesh']['quads']} quads, {table['mesh']['trias']} triangles, "
              f"jacobian {quality['scaled_jacobian_min']:.2f}, edges {quality['edge_min']:.2f} to {quality['edge_max']:.2f} mm")
        for row in rows:
            if self.arguments.all or shortfalls(row):
                print("  " + text_of(row))
        sys.stdout.flush()
        self.rows += rows

    def summary(self):
        beads = [r for r in self.rows if r["method"] != "not a bead"]
        missed = [r for r in self.rows if r["method"] == "not a bead" and r["kind"] != "none"]
        print(f"\n{len(beads)} beads, {len(missed)} not found; "
              f"methods {dict(collections.Counter(r['method'] for r in beads))}")
        print(f"by blocks: {100 * sum(r['method'] == 'blocks' for r in beads) / max(1, len(beads) + len(missed)):.2f} %")
        print(f"{'shape':15} beads  blocks  goal held  jacobian: worst, 10 %, median  irregular: median, most  beside")
        for name in dict.fromkeys(r["name"] for r in beads):
            of = [r for r in beads if r["name"] == name]
            jacobian, irregular = sorted(r["jacobian"] for r in of), sorted(r["irregular"] for r in of)
            print(f"{name:15} {len(of):5d} {sum(r['method'] == 'blocks' for r in of):7d} "
                  f"{sum('jacobian' not in shortfalls(r) for r in of):10d}  {jacobian[0]:15.2f} {jacobian[len(of) // 10]:5.2f} "
                  f"{jacobian[len(of) // 2]:7.2f}  {irregular[len(of) // 2]:17d} {irregular[-1]:5d}  {min(r['beside'] for r in of):6.2f}")


def numbers(text):
    return [float(part) for part in text.split(",")]


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("maker")
    parser.add_argument("--widths", type=numbers, default=[8, 10, 12, 16, 20, 25, 30, 40])
    parser.add_argument("--shares", type=numbers, default=[0.2, 0.4])
    parser.add_argument("--bases", default="flat,cylinder,double,saddle")
    parser.add_argument("--sizes", default="5/2.5,8/4,3/1.5,10/4")
    parser.add_argument("--only")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--random", help="first-last seed of random panels, instead of the shapes")
    parser.add_argument("--folder", type=pathlib.Path)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--json", type=pathlib.Path)
    return parser.parse_args()


def panels(survey, arguments):
    """Name, STEP file and features of each panel."""
    if arguments.random:
        first, last = arguments.random.split("-")
        for seed in range(int(first), int(last) + 1):
            yield (f"random-{seed}", *survey.panel(f"random-{seed}", "random", "--seed", seed))
        return
    only = ["--only", arguments.only] if arguments.only else []
    for width in arguments.widths:
        for height in dict.fromkeys(min(10.0, max(2.0, round(width * share, 1))) for share in arguments.shares):
            for base in arguments.bases.split(","):
                name = f"w{width:g}-h{height:g}-{base}-{arguments.seed}" + (f"-{arguments.only}" if only else "")
                yield (name, *survey.panel(name, "shapes", "--width", width, "--height", height, "--base", base,
                                           "--seed", arguments.seed, *only))


def main():
    arguments = parse()
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.folder or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        survey = Survey(arguments, folder)
        for name, step, features in panels(survey, arguments):
            for size, min_edge in (map(float, pair.split("/")) for pair in arguments.sizes.split(",")):
                survey.mesh(name, step, features, size, min_edge)
        survey.summary()
        if arguments.json:
            arguments.json.write_text(json.dumps(survey.rows, indent=1) + "\n")


if __name__ == "__main__":
    main()
