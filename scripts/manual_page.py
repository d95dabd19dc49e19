#!/usr/bin/env python3
"""Writes the manual page from what the program says about itself.

  manual_page.py PROGRAM OUT.1        OUT.1: in man's own language, for `man -l`
"""
import re
import subprocess
import sys

STATUS = [("0", "done"), ("1", "done, but something fell short and is named"),
          ("2", "wrong usage or unreadable input; nothing is written"), ("3", "internal error")]


def help_of(program, *verb):
    return subprocess.run([program, *verb, "--help"], capture_output=True, text=True, check=True).stdout


def escaped(text):
    """Safe as text of a page: no control line, hyphens that can be searched for."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text[:1] in ".'" else text


def sections(text):
    """Description, usage, and (title, [(item, words)]) of each list."""
    lines = text.splitlines()
    description, usage, lists = lines[0], "", []
    for line in lines[1:]:
        if line.startswith("Usage: "):
            usage = line.removeprefix("Usage: ")
        elif re.match(r"[A-Z]\w*:$", line):
            lists.append((line[:-1], []))
        elif not line.startswith(" "):
            if line:
                break
        elif found := re.match(r"  (\S.*?)(?:  +(\S.*))?$", line):
            lists[-1][1].append((found[1], found[2] or ""))
        elif lists and lists[-1][1]:
            item, words = lists[-1][1][-1]
            lists[-1][1][-1] = (item, f"{words} {line.strip()}".strip())
    return description, usage, lists


def item_lines(item, words):
    """A tagged paragraph: names in bold, the kind of value in italics."""
    names, _, value = item.partition(" ")
    value = re.sub(r" ?\bREQUIRED\b", "", value)
    tag = f"\\fB{escaped(names)}\\fR" + (f" \\fI{escaped(value)}\\fR" if value else "")
    return [".TP", tag, escaped(words)]


def page(program):
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
    description, _, lists = sections(help_of(program))
    out = [f'.TH BEADMESH 1 "" "beadmesh {version}" "User Commands"', ".SH NAME",
           "beadmesh \\- recognise the beads of sheet\\-metal panels and mesh them on purpose", ".SH SYNOPSIS"]
    verbs = [name for title, items in lists if title == "Subcommands" for name, _ in items]
    for verb in verbs:
        _, usage, _ = sections(help_of(program, verb))
        words = usage.split()[1:]
        out += [".B beadmesh " + verb, escaped(" ".join(words[1:])), ".br"]
    out += [".SH DESCRIPTION", escaped(description)]
    for verb in verbs:
        what, _, verb_lists = sections(help_of(program, verb))
        out += [f'.SH "{verb.upper()}"', escaped(what[:1].upper() + what[1:]) + "."]
        for _, items in verb_lists:
            for item, words in items:
                out += item_lines(item, words)
    out += [".SH EXIT STATUS"]
    for status, meaning in STATUS:
        out += [".TP", f"\\fB{status}\\fR", escaped(meaning)]
    return "\n".join(out) + "\n"


def main():
    program, path = sys.argv[1:]
    with open(path, "w", encoding="utf-8") as file:
        file.write(page(program))


if __name__ == "__main__":
    main()
