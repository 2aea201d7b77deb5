"""The developer guide and what its steps add, without compiling it (additions.test.py does).

    steps.test.py REPOSITORY ["the sentence"]
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402
from steps import ADDED, GUIDE, grown_tree, sections  # noqa: E402


@claim("the steps of the developer guide name every file that they add, and lines that fit the sources")
def fits(t):
    grown_tree(t.folder)


@claim("a material and a boundary condition are one folder and one line, and a column is one line")
def counts(t):
    steps = sections(GUIDE.read_text())
    for title in ADDED:
        folders = {line.rsplit("/", 1)[0] for line in steps[title] if line.startswith("+++ ")}
        lines = [line for line in steps[title] if line.startswith("+") and not line.startswith("+++ ")]
        # a reader and contact bounds need an #include beside their entry; fccda, which knows nothing of decks, has a list of its own
        most = {"reader": (1, 2), "contact bounds": (2, 3), "output column": (0, 1)}.get(title, (1, 1))
        t.assertLessEqual((len(folders), len(lines)), most, title)


main()
