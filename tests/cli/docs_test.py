"""The commands of README.md and of the guide, run as they stand there; the option reference; the links between pages."""
import os
import pathlib
import re
import shutil
import subprocess
import unittest

from command import MAKE_EXAMPLE_PANEL, PROGRAM, Case

ROOT = pathlib.Path(__file__).resolve().parents[2]
TIMEOUT = 300  # seconds for a command


def commands_of(page):
    """Commands of the indented blocks of a page, each with the lines printed below it."""
    commands = []
    for line in page.read_text().splitlines():
        if line.startswith("    $ "):
            commands.append((line[6:], []))
        elif line.startswith("    ") and commands and commands[-1]:
            commands[-1][1].append(line[4:])
        else:
            commands.append(None)  # the block is over
    return [command for command in commands if command]


def stable(line):
    """A line without what a later version, or another machine, may print otherwise: figures, times, spaces."""
    return re.sub(r"\s+", " ", re.sub(r"-?\d[\d.,]*(e[+-]?\d+)?", "#", line)).strip()


class Pages(Case):
    def setUp(self):
        super().setUp()
        folders = {str(pathlib.Path(program).parent) for program in (PROGRAM, MAKE_EXAMPLE_PANEL)}
        self.environment = dict(os.environ, PATH=":".join([*folders, os.environ["PATH"]]))

    def run_page(self, name, needs=()):
        missing = [program for program in needs if not shutil.which(program)]
        if missing:
            self.skipTest("not installed: " + ", ".join(missing))
        commands = commands_of(ROOT / name)
        self.assertGreater(len(commands), 3)
        for command, expected in commands:
            with self.subTest(command=command):
                self.run_command(command, expected)

    def run_command(self, command, expected):
        if command.startswith("cat ") and not (self.folder / command[4:]).exists():
            self.file(command[4:], "\n".join(expected).encode() + b"\n")  # a file that the reader is to write
            return
        result = subprocess.run(command, shell=True, cwd=self.folder, env=self.environment, text=True, timeout=TIMEOUT,
                                capture_output=True)
        whole = result.stdout + result.stderr
        printed = whole.splitlines()
        expects_error = any(line.startswith("error ") for line in expected)
        self.assertEqual(expects_error, result.returncode == 2, whole)
        self.assertLess(result.returncode, 3, whole)
        left = [stable(line) for line in printed]
        for line in filter(str.strip, expected):
            if line.strip() == "...":
                continue
            self.assertIn(stable(line), left, whole)
            left = left[left.index(stable(line)) + 1:]
        for line in expected:  # how many beads there are, and of which kinds, is no figure that may drift
            if re.search(r" beads? \(", line):
                self.assertIn(line.strip(), [one.strip() for one in printed])

    def test_readme(self):
        self.run_page("README.md")

    def test_guide(self):
        self.run_page("docs/guide.md", needs=("ccx",))

    def test_option_reference_is_up_to_date(self):
        printed = subprocess.run([PROGRAM, "options"], capture_output=True, text=True, check=True, timeout=TIMEOUT).stdout
        self.assertEqual(printed, (ROOT / "docs/options.md").read_text(), "run: beadmesh options > docs/options.md")

    def test_every_page_of_a_stage_has_its_picture(self):
        stages = (ROOT / "docs/README.md").read_text().split("## The stages")[1].split("\n\n[install]")[0]
        pages = re.findall(r"^\d+\. \[\w+\]\((\w+\.md)\)", stages, re.M)
        self.assertGreater(len(pages), 12)
        for page in pages:
            self.assertRegex((ROOT / "docs" / page).read_text(), r"!\[[^]]+\]\(pictures/", page)

    def test_links_between_pages(self):
        for page in (*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")):
            for target in re.findall(r"\]\(([^)#\s]+)", page.read_text()):
                if "://" not in target:
                    self.assertTrue((page.parent / target).exists(), f"{page.name}: {target}")

    def test_every_page_is_in_the_index(self):
        index = (ROOT / "docs/README.md").read_text()
        for page in ROOT.glob("docs/*.md"):
            if page.name != "README.md":
                self.assertIn(f"({page.name})", index)


if __name__ == "__main__":
    unittest.main()
