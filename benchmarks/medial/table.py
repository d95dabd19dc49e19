#!/usr/bin/env python3
"""Markdown tables of the docs from the lines that benchmark_medial writes: table.py RESULTS.jsonl"""
import json
import math
import sys
from collections import defaultdict

OURS, CDT, CHECK, BOOST = "medial object", "our CDT", "check of the region", "Boost Voronoi"
ROUGH, SAMPLES = "object without polish", "samples and CDT"
CGAL, GRAPH = "CGAL CDT", "CGAL segment Delaunay graph"


def read(path):
    cases, outlines = defaultdict(dict), []
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            record = json.loads(line)
            if "accuracy" in record:
                outlines.append(record)
                continue
            cases[record["domain"], record["segments"], record["angle"]][record["candidate"]] = record
    return cases, outlines


def table(head, rows):
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * 3 + "---:|" * (len(head) - 3))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def named(case):
    domain, segments, angle = case
    return [domain, f"{segments:.0e}".replace("e+0", "e"), f"{angle:g}"]


def seconds(records, candidate):
    return records.get(candidate, {}).get("seconds")


def microseconds(records, candidate, segments):
    value = seconds(records, candidate)
    return "-" if value is None else f"{value / segments * 1e6:.2f}"


def ratio(records, over, under):
    a, b = seconds(records, over), seconds(records, under)
    return "-" if a is None or b is None else f"{a / b:.2f}"


def times(cases):
    print("Microseconds per segment, and ratios of times:\n")
    head = ["domain", "segments", "angle", "medial object", "our CDT", "CGAL CDT", "Boost", "CGAL segment graph",
            "object / our CDT", "object / CGAL CDT", "Boost / object"]
    rows = []
    for case, records in cases.items():
        columns = [microseconds(records, name, case[1]) for name in (OURS, CDT, CGAL, BOOST, GRAPH)]
        rows.append(named(case) + columns +
                    [ratio(records, OURS, CDT), ratio(records, OURS, CGAL), ratio(records, BOOST, OURS)])
    table(head, rows)


def stages(cases):
    print("Where the time goes, microseconds per segment. The check of the region comes before the medial object:\n")
    head = ["domain", "segments", "angle", "check", "CDT alone", "boundary, samples, CDT", "graph", "polish, attributes",
            "medial object"]
    rows = []
    for case, records in cases.items():
        if SAMPLES not in records:
            continue
        at = {name: records[name]["seconds"] / case[1] * 1e6 for name in (CHECK, CDT, SAMPLES, ROUGH, OURS)}
        columns = [at[CHECK], at[CDT], at[SAMPLES], at[ROUGH] - at[SAMPLES], at[OURS] - at[ROUGH], at[OURS]]
        rows.append(named(case) + [f"{value:.2f}" for value in columns])
    table(head, rows)


def memory(cases):
    print("Bytes per segment at the peak, and growth: time over n log n, against the size before:\n")
    head = ["domain", "segments", "angle", "medial object", "our CDT", "CGAL CDT", "Boost", "resident, object",
            "object / n log n", "our CDT / n log n"]
    before, rows = {}, []
    for case, records in cases.items():
        domain, segments, angle = case
        columns = []
        for name in (OURS, CDT, CGAL, BOOST):
            peak = records.get(name, {}).get("peak_bytes", -1)
            columns.append("-" if peak < 0 else f"{peak / segments:.0f}")
        columns.append(f"{records[OURS]['resident_bytes'] / segments:.0f}")
        for name in (OURS, CDT):
            growth = records[name]["seconds"] / (segments * math.log(segments))
            last = before.get((domain, angle, name))
            columns.append("-" if last is None else f"{growth / last:.2f}")
            before[domain, angle, name] = growth
        rows.append(named(case) + columns)
    table(head, rows)


def accuracy(outlines):
    print("At the same accuracy: the outline itself against as many segments as Boost needs. Error: the greatest\n"
          "|r - distance to the outline| over the diagonal:\n")
    rows = [[record["accuracy"], record["candidate"], str(record["count"]), f"{record['seconds'] * 1e3:.2f}",
             f"{record['error']:.1e}"] for record in outlines]
    table(["domain", "candidate", "points given", "ms", "error"], rows)


def main():
    cases, outlines = read(sys.argv[1])
    times(cases)
    stages(cases)
    memory(cases)
    accuracy(outlines)
    print("What was found: " + "; ".join(sorted({f"{case[0]} {records[OURS]['result']}"
                                                 for case, records in cases.items()})))


if __name__ == "__main__":
    main()
