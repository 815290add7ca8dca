#!/usr/bin/env python3
"""Write keywords.md: what the options -list... of vertexContactFoam print.

    . etc/bashrc; tutorials/reference/writeKeywords.py [FILE]

FILE is the page (default: keywords.md beside this script). Lists of models of
OpenFOAM, which differ from release to release, are left out.
"""

import re
import subprocess
import sys
from pathlib import Path

PAGE = Path(__file__).resolve().parent/"keywords.md"

# Options in the order of the page, and the page that explains them
LISTS = (
    ("Materials", "case.md"),
    ("StartFields", "case.md"),
    ("BoundaryConditions", "case.md"),
    ("BodyForces", "case.md"),
    ("Pairings", "contact.md"),
    ("ContactLaws", "contact.md"),
    ("Controls", "options.md"),
    ("Presets", "options.md"),
    ("Integrators", "options.md"),
    ("Schemes", "options.md"),
    ("FunctionObjects", "output.md"),
)

HEAD = """# Keywords

The keywords of a case, with units and defaults, as `vertexContactFoam -list…` prints them. `writeKeywords.py` writes this page from that output, and a test
fails if the page is out of date. The solver accepts no other keywords in these places: a wrong one is an error that names the valid ones. `controlDict` also
has OpenFOAM's own keywords and [variables](options.md#keywords-of-controldict).
"""


def run(*arguments):
    return subprocess.run(["vertexContactFoam", *arguments], check=True,
                          capture_output=True, text=True).stdout


def printed(option):
    """The output of the option after OpenFOAM's banner, without the names of
    OpenFOAM's own models."""
    text = re.split(r"(?m)^// (?:\* )+//$", run(f"-list{option}"), 1)[1]
    text = re.sub(r"(?m)(^'.*OpenFOAM\))\n +\(.*\)$", r"\1", text)
    return "\n".join(line.rstrip() for line in text.strip().splitlines())


def page():
    options = re.findall(r"(?m)^ *-list(\w+)", run("-help"))
    known = [option for option, _ in LISTS]
    own = [option for option in options if option[0].isupper()
           and option not in known]
    if own:
        raise SystemExit(f"writeKeywords.py: no place for -list{own[0]}")
    text = HEAD
    for option, explained in LISTS:
        title, rows = printed(option).split("\n\n", 1)
        name, place = title.split(": ", 1)
        text += (f"\n## {name}\n\n`-list{option}`: {place}. Explained in "
                 f"[{explained[:-3]}]({explained}).\n\n"
                 f"```text\n{rows}\n```\n")
    return text


if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else PAGE
    target.write_text(page())
