"""The package as a package: names, docstrings, stubs."""
import ast
import inspect
import os
import pathlib
import re
import subprocess
import sys

import beadmesh
from beadmesh import _core

FOLDER = pathlib.Path(beadmesh.__file__).parent


def test_every_public_name_has_a_docstring():
    for name in beadmesh.__all__:
        assert hasattr(beadmesh, name)
        thing = getattr(beadmesh, name)
        if inspect.isclass(thing) or inspect.isfunction(thing):
            assert thing.__doc__ and not thing.__doc__.startswith(f"{name}("), f"{name} has no docstring of its own"


def test_every_public_function_is_annotated():
    for name in beadmesh.__all__:
        thing = getattr(beadmesh, name)
        if inspect.isfunction(thing):
            signature = inspect.signature(thing)
            assert signature.return_annotation is not inspect.Signature.empty
            assert all(p.annotation is not inspect.Parameter.empty for p in signature.parameters.values()), name


def test_the_stub_is_that_of_the_compiled_part():
    """Same names, and the same arguments in the same order."""
    assert (FOLDER / "py.typed").exists()
    stub = ast.parse((FOLDER / "_core.pyi").read_text())
    declared = {node.name: node for node in stub.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    actual = {name for name in dir(_core) if not name.startswith("_")}
    assert declared.keys() == actual
    for name, node in declared.items():
        if isinstance(node, ast.ClassDef):
            members = {part.name for part in node.body if isinstance(part, ast.FunctionDef) and part.name != "__init__"}
            assert members == {member for member in vars(getattr(_core, name)) if not member.startswith("_")}
            node = next((part for part in node.body if part.name == "__init__"), None)
            if node is None:
                continue
            text = getattr(_core, name).__init__.__doc__
        else:
            text = getattr(_core, name).__doc__
        names = [argument.arg for argument in node.args.args if argument.arg != "self"]
        inside = text.splitlines()[0].split("(", 1)[1]
        assert re.findall(r"(?:^|, )(\w+): ", inside.rsplit(") ->", 1)[0]) == (["self"] if "self:" in inside else []) + names


def test_types_hold(tmp_path):
    """Within the package, and for a user who knows it by its annotations alone."""
    user = tmp_path / "user.py"
    user.write_text("import beadmesh\n"
                    "mesh = beadmesh.mesh(beadmesh.read('a.step'), size=5, local_sizes=[((1, 2, 3), 10, 2)])\n"
                    "reveal_type(mesh.sets[0].crest_nodes)\n"
                    "beadmesh.read('a.step', unit=3)\n")
    mypy = [sys.executable, "-m", "mypy", "--cache-dir", str(tmp_path), "--ignore-missing-imports"]
    inside = subprocess.run([*mypy, "-p", "beadmesh"], capture_output=True, text=True, cwd=FOLDER.parent)
    assert inside.returncode == 0, inside.stdout
    outside = subprocess.run([*mypy, str(user)], capture_output=True, text=True, env={**os.environ, "MYPYPATH": str(FOLDER.parent)})
    said = outside.stdout.splitlines()
    assert "ndarray" in said[0] and "signedinteger" in said[0]
    assert 'Argument "unit" to "read" has incompatible type "int"; expected "str"' in said[1]
    assert "Found 1 error" in said[2]


def test_version_is_that_of_the_program(program):
    shown = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    assert re.search(rf"beadmesh {re.escape(beadmesh.__version__)}\b", shown)
