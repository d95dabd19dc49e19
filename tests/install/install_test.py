"""What is installed, from outside: libraries for find_package, program, manual page, completion, Python and Debian packages."""
import functools
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
BUILD = pathlib.Path(os.environ["BEADMESH_BUILD"])
PYTHON = os.environ["BEADMESH_PYTHON"]
MAKE_EXAMPLE_PANEL = os.environ["MAKE_EXAMPLE_PANEL"]
_scratch = tempfile.TemporaryDirectory()
SCRATCH = pathlib.Path(_scratch.name)


def run(*command, status=0, **options):
    """Standard output of a command that must end with `status`."""
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=900, **options)
    if done.returncode != status:
        raise AssertionError(f"{command} ended with {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout + done.stderr if status else done.stdout


@functools.cache
def prefix(*components):
    """A fresh folder with these components installed; all where none is given."""
    folder = SCRATCH / ("-".join(components) or "all")
    for component in components or (None,):
        run("cmake", "--install", BUILD, "--prefix", folder, *(["--component", component] if component else []))
    return folder


def needed(library):
    """Shared libraries that a file names."""
    return re.findall(r"\(NEEDED\).*\[(.*)\]", run("readelf", "-d", library))


def configure(folder, build, *options, status=0):
    return run("cmake", "-S", SOURCE / "tests/install/consumer", "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={folder}",
               "-DCMAKE_DISABLE_FIND_PACKAGE_OpenCASCADE=ON", "-DCMAKE_BUILD_TYPE=Debug", *options, status=status)


@functools.cache
def panel():
    path = SCRATCH / "single.step"
    run(MAKE_EXAMPLE_PANEL, "single", path)
    return path


class Core(unittest.TestCase):
    """The component core, without the others and without OpenCASCADE."""

    def test_nothing_of_opencascade(self):
        folder = prefix("core")
        libraries = [path for path in folder.rglob("*.so*")]
        self.assertTrue(libraries)
        for library in libraries:
            self.assertFalse([name for name in needed(library) if name.startswith("libTK")])
        self.assertFalse((folder / "bin").exists())
        self.assertFalse((folder / "include/beadmesh/read/panel_reader.h").exists())
        self.assertTrue((folder / "include/beadmesh/medial/medial_object.h").exists())
        self.assertFalse((folder / "include/beadmesh/write/deck_text.h").exists())  # a room's own

    def test_a_consumer(self):
        build = SCRATCH / "consumer-core"
        configure(prefix("core"), build)
        run("cmake", "--build", build)
        said = run(build / "medial_of_rectangle", cwd=build)
        self.assertEqual("5 edges, 58.284 long; write.ending\n", said)
        self.assertIn("*ELEMENT_SHELL", (build / "one.k").read_text())

    def test_cad_is_missed_in_words(self):
        said = configure(prefix("core"), SCRATCH / "consumer-none", "-DWITH_CAD=ON", status=1)
        self.assertIn("beadmesh is installed without its component cad", said)

    def test_it_is_configured_where_there_is_no_opencascade(self):
        build = SCRATCH / "without"
        run("cmake", "-S", SOURCE, "-B", build, "-G", "Ninja", "-DBEADMESH_CAD=OFF", "-DCMAKE_DISABLE_FIND_PACKAGE_OpenCASCADE=ON")
        targets = run("cmake", "--build", build, "--target", "help")
        self.assertIn("beadmesh_shared", targets)
        for absent in ("beadmesh_cad", "beadmesh_app", "beadmesh_python"):
            self.assertNotIn(absent, targets)


class Everything(unittest.TestCase):
    def test_a_consumer(self):
        build = SCRATCH / "consumer-all"
        configure(prefix(), build, "-DWITH_CAD=ON")
        run("cmake", "--build", build, "--target", "mesh_panel", "medial_of_rectangle")
        self.assertRegex(run(build / "mesh_panel", panel()), r"^1 beads, \d{3,} quads\n$")
        self.assertIn("read.not_found", run(build / "mesh_panel", "missing.step", status=1))

    def test_the_core_is_in_one_library_only(self):
        folder = prefix()
        cad, = folder.rglob("libbeadmesh_cad.so")
        self.assertIn("libbeadmesh.so.0.1", needed(cad))
        self.assertIn("libTKernel.so.7", needed(cad))
        symbols = run("nm", "-D", "--defined-only", "-C", cad)
        self.assertIn("beadmesh::read_panel(", symbols)
        self.assertNotIn("beadmesh::verify_panel(", symbols)

    def test_the_program(self):
        program = prefix() / "bin/beadmesh"
        version = run(program, "--version")
        self.assertRegex(version, r"^beadmesh \d+\.\d+\.\d+\n")
        for part in ("OpenCASCADE 7", "oneTBB 20", "Eigen 3", "fmt ", "zlib 1", "nlohmann JSON 3", "CLI11 ", "toml++ ", "tl::expected "):
            self.assertRegex(version, re.escape(part) + r"[\d.]*\d")
        self.assertIn("1 beads (1 I", run(program, "beads", panel()).replace("1 bead ", "1 beads "))

    def test_the_python_package(self):
        folder = prefix() / "lib/python3/dist-packages"
        code = f"import beadmesh; print(beadmesh.__file__, len(beadmesh.beads(beadmesh.read({str(panel())!r})).beads))"
        said = run(PYTHON, "-c", code, env={**os.environ, "PYTHONPATH": str(folder), "PYTHONDONTWRITEBYTECODE": "1"})
        self.assertEqual(f"{folder}/beadmesh/__init__.py 1\n", said)
        self.assertTrue((folder / "beadmesh/py.typed").exists() and (folder / "beadmesh/_core.pyi").exists())


class ManualPage(unittest.TestCase):
    def test_it_renders_without_a_warning(self):
        page = prefix() / "share/man/man1/beadmesh.1"
        done = subprocess.run(["man", "--warnings", "-l", str(page)], capture_output=True, text=True, timeout=60,
                              env={**os.environ, "MANWIDTH": "100", "LC_ALL": "C.UTF-8"})
        self.assertEqual((0, ""), (done.returncode, done.stderr))
        text = re.sub(r".\b", "", done.stdout) if "\b" in done.stdout else done.stdout
        program = prefix() / "bin/beadmesh"
        verbs = re.findall(r"^  ([a-z]+) ", run(program, "--help").split("Subcommands:")[1].split("\n\n")[0], re.M)
        self.assertIn("mesh", verbs)
        for verb in verbs:
            self.assertIn(verb.upper(), text)
            for option in re.findall(r"^  (?:-\w,)?(--[a-z-]+)", run(program, verb, "--help"), re.M):
                self.assertIn(option, text.replace("\u2010", "-"))


class Completion(unittest.TestCase):
    def complete(self, *words, folder="."):
        """What bash offers for the last word."""
        script = prefix() / "share/bash-completion/completions/beadmesh"
        line = " ".join(f"'{word}'" for word in words)
        code = (f"source {script}; COMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; _beadmesh; "
                'printf "%s\\n" "${COMPREPLY[@]}"; complete -p beadmesh')
        said = run("bash", "--norc", "-c", code, cwd=folder).splitlines()
        self.assertEqual("complete -F _beadmesh beadmesh", said[-1])
        return [word for word in said[:-1] if word]

    def test_of_bash(self):
        program = str(prefix() / "bin/beadmesh")
        self.assertLessEqual({"mesh", "beads", "medial", "check"}, set(self.complete(program, "")))
        self.assertEqual(["medial"], self.complete(program, "med"))
        self.assertEqual(["--min-edge"], self.complete(program, "mesh", "--min"))
        self.assertIn("--id-offset", self.complete(program, "mesh", "--"))
        self.assertNotIn("--id-offset", self.complete(program, "check", "--"))
        self.assertEqual(["crash"], self.complete(program, "mesh", "--preset", "c"))
        self.assertEqual(["--version"], self.complete(program, "--v"))

    def test_of_files(self):
        program = str(prefix() / "bin/beadmesh")
        with tempfile.TemporaryDirectory() as folder:
            for name in ("floor.STEP", "floor.bdf", "floor.txt", "notes.doc", "two words.stl"):
                (pathlib.Path(folder) / name).touch()
            (pathlib.Path(folder) / "parts").mkdir()
            offered = self.complete(program, "mesh", "", folder=folder)
            self.assertLessEqual({"floor.STEP", "two words.stl", "parts/"}, set(offered))
            self.assertNotIn("notes.doc", offered)
            self.assertEqual(["floor.bdf"], self.complete(program, "mesh", "floor.STEP", "-o", "fl", folder=folder))

    def test_syntax_of_the_others(self):
        """Where the shells are there."""
        for shell, path in (("zsh", "zsh/vendor-completions/_beadmesh"), ("fish", "fish/vendor_completions.d/beadmesh.fish")):
            script = prefix() / "share" / path
            self.assertTrue(script.read_text().strip())
            if subprocess.run(["which", shell], capture_output=True).returncode == 0:
                run(shell, "-n", script)


class DebianPackage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = SCRATCH / "deb"
        run("cpack", "--config", BUILD / "CPackConfig.cmake", "-G", "DEB", "-B", folder)
        cls.package, = folder.glob("*.deb")

    def test_fields(self):
        fields = run("dpkg-deb", "-I", self.package)
        self.assertRegex(self.package.name, r"^beadmesh_\d+\.\d+\.\d+_\w+\.deb$")
        for line in (" Package: beadmesh\n", " Section: science\n", " Recommends: python3, python3-numpy\n"):
            self.assertIn(line, fields)
        depends = re.search(r" Depends: (.*)", fields)[1]
        for name in ("libocct-foundation-7.6", "libocct-data-exchange-7.6", "libtbb12", "libfmt9", "libstdc++6"):
            self.assertIn(name, depends)
        self.assertNotIn("beadmesh", depends)
        self.assertRegex(depends, r"libc6 \(>= [\d.]+\)")

    def test_contents_run(self):
        listing = run("dpkg-deb", "-c", self.package)
        names = {line.split()[5] for line in listing.splitlines()}
        for name in ("bin/beadmesh", "lib/libbeadmesh_cad.so.0.1", "include/beadmesh/pipeline.h", "share/man/man1/beadmesh.1",
                     "lib/cmake/beadmesh/beadmeshConfig.cmake", "share/bash-completion/completions/beadmesh",
                     "lib/python3/dist-packages/beadmesh/__init__.py", "share/doc/beadmesh/LICENSE"):
            self.assertIn("./usr/" + name, names)
        self.assertFalse([name for name in names if "example" in name or "test" in name])
        root = SCRATCH / "root"
        run("dpkg-deb", "-x", self.package, root)
        self.assertTrue(run(root / "usr/bin/beadmesh", "--version").startswith("beadmesh "))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
