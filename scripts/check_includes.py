#!/usr/bin/env python3
"""Reads the includes of the library and fails on an arrow that points back.

  check_includes.py [ROOT]        ROOT: the repository, default the folder above this script

Rules: a room includes only itself and the rooms below it (BELOW); public headers, which are those that another room or
a program can see, include no third-party header but <tl/expected.hpp>; OpenCASCADE is seen in read/ alone, outside the
library in examples/ and in tests of these two.
Prints one line a breach; exit status 1 where there is one.
"""
import pathlib
import re
import sys

BELOW = {  # a room: the rooms directly below it; what those may use, it may use as well
    "core": [],
    "geometry": ["core"],
    "panel": ["geometry"],
    "delaunay": ["geometry"],
    "read": ["panel", "delaunay"],
    "flatten": ["panel", "delaunay"],
    "medial": ["delaunay"],
    "bead": ["medial", "flatten", "panel"],
    "blocking": ["bead", "flatten", "panel"],
    "mesh": ["blocking", "flatten", "panel"],
    "write": ["mesh"],
    "report": ["mesh"],
    "pipeline": ["mesh"],
}
THIRD_PARTY_IN_PUBLIC = {"tl/expected.hpp"}
PROGRAMS = ("apps", "python", "examples", "benchmarks", "fuzz")
INCLUDE = re.compile(r'^\s*#\s*include\s*(<[^>]+>|"[^"]+")')
OPENCASCADE = re.compile(r"\.(hxx|lxx|gxx)$")


def allowed(room):
    """The rooms that a room may include, itself among them."""
    rooms, todo = set(), [room]
    while todo:
        at = todo.pop()
        if at not in rooms:
            rooms.add(at)
            todo += BELOW.get(at, [])
    return rooms


def includes(path):
    """(line number, name, in quotes?) of every include of a file."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        found = INCLUDE.match(line)
        if found:
            yield number, found[1][1:-1], found[1][0] == '"'


def is_standard(name):
    """A header of the C++ standard library: no folder, no ending."""
    return "/" not in name and "." not in name


def room_of(path, library):
    """The folder below the library; a file beside the folders is a room of its own name."""
    parts = path.relative_to(library).parts
    return parts[0] if len(parts) > 1 else path.stem


def public_headers(root, library):
    """Names of the headers that another room, a program or the Python module includes, directly or by a header."""
    seen, todo = set(), []
    for path in sources(library):
        room = room_of(path, library)
        todo += [n for _, n, _ in includes(path) if n.startswith("beadmesh/") and n.split("/")[1] != room]
    for folder in PROGRAMS:
        todo += [n for path in sources(root / folder) for _, n, _ in includes(path) if n.startswith("beadmesh/")]
    while todo:
        name = todo.pop()
        path = library.parent / name
        if name not in seen and path.is_file():
            seen.add(name)
            todo += [n for _, n, _ in includes(path) if n.startswith("beadmesh/")]
    return seen


def check_library_file(path, library, public):
    """Breaches of one source or header of the library, as (line number, text)."""
    room = room_of(path, library)
    if room not in BELOW:
        yield 1, f"room '{room}' has no place in the order; add it to scripts/check_includes.py"
        return
    below = allowed(room)
    is_public = path.relative_to(library.parent).as_posix() in public
    for number, name, quoted in includes(path):
        if name.startswith("beadmesh/"):
            target = name.split("/")[1].removesuffix(".h")
            if target not in below:
                yield number, f"{room} must not include {target} ({name})"
        elif OPENCASCADE.search(name) and room != "read":
            yield number, f"OpenCASCADE outside read/ ({name})"
        elif quoted:
            yield number, f'write the full name "beadmesh/..." ({name})'
        elif is_public and not is_standard(name) and name not in THIRD_PARTY_IN_PUBLIC:
            yield number, f"third-party header in a public header ({name})"


def check_outside(path):
    """Breaches of a program or test: OpenCASCADE."""
    for number, name, _ in includes(path):
        if OPENCASCADE.search(name):
            yield number, f"OpenCASCADE outside read/ and examples/ ({name})"


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in {".h", ".cpp"})


def check(root):
    """All breaches under a repository, as printable lines."""
    library, lines = root / "src" / "beadmesh", []
    public = public_headers(root, library)
    files = [(p, check_library_file(p, library, public)) for p in sources(library)]
    for folder in PROGRAMS + ("tests",):
        for path in sources(root / folder):
            if not path.relative_to(root).as_posix().startswith(("examples/", "tests/examples/", "tests/read/")):
                files.append((path, check_outside(path)))
    for path, breaches in files:
        lines += [f"{path.relative_to(root)}:{number}: {text}" for number, text in breaches]
    return lines


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    if root.is_file():
        root = root.parent.parent
    lines = check(root)
    print("\n".join(lines) if lines else "includes: every arrow points the right way")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
