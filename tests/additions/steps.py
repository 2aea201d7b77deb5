"""The steps of docs/developer/structure.md, "To add …", as diffs, and what they make of a copy of the sources with tests/fixtures/additions."""

import re
import shutil
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parent.parent.parent
FIXTURES = REPOSITORY / "tests/fixtures/additions"
GUIDE = REPOSITORY / "docs/developer/structure.md"
ADDED = ["material", "boundary condition", "contact bounds", "reader", "output column"]


def sections(guide):
    """Title of a section → the lines of its diff."""
    found = {}
    for section in re.split(r"^### ", guide, flags=re.MULTILINE)[1:]:
        title, text = section.split("\n", 1)
        blocks = re.findall(r"^```diff\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        if blocks:
            assert len(blocks) == 1, f"two diffs in the section {title}"
            found[re.sub(r"^(a|an) ", "", title)] = blocks[0].splitlines()
    return found


def names_of(pattern):
    """ball.{hpp,cpp} → ball.hpp, ball.cpp"""
    inner = re.search(r"\{([^}]*)\}", pattern)
    return [pattern.replace(inner[0], each) for each in inner[1].split(",")] if inner else [pattern]


def insert(lines, new):
    """The line after the last one that starts alike, up to the first quote, or parenthesis where it has none."""
    start = re.match(r'[^"]*"|[^(]*\(', new.strip())[0]
    alike = [k for k, line in enumerate(lines) if line.strip().startswith(start)]
    assert alike, f"no line starts with {start}, like: {new}"
    lines.insert(alike[-1] + 1, new)


def apply_steps(steps, tree):
    """Copies the new files and changes the lines that the steps name; returns the new files."""
    files, target, replaced = [], None, None
    for line in steps:
        if line.startswith("+++ "):
            for name in names_of(line[4:]):
                assert not (tree / name).exists(), f"{name} is no new file"
                (tree / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(FIXTURES / name, tree / name)
                files.append(name)
        elif line.startswith("--- "):
            target = tree / line[4:]
        else:
            lines = target.read_text().splitlines()
            if line.startswith("-"):
                replaced = lines.index(line[1:])
                del lines[replaced]
            elif replaced is not None:
                lines.insert(replaced, line[1:])
                replaced = None
            else:
                insert(lines, line[1:])
            target.write_text("\n".join(lines) + "\n")
    return files


def grown_tree(folder):
    """A copy of the sources to which one of each was added; unchanged files keep their time, so that a second run compiles little."""
    fresh, tree = folder / "fresh", folder / "tree"
    shutil.rmtree(fresh, ignore_errors=True)
    for part in ("src", "cmake", "packaging"):
        shutil.copytree(REPOSITORY / part, fresh / part)
    (fresh / "report/dist").mkdir(parents=True)
    for name in ("CMakeLists.txt", "CHANGELOG.md", "report/dist/template.html"):
        shutil.copyfile(REPOSITORY / name, fresh / name)
    steps = sections(GUIDE.read_text())
    assert sorted(steps) == sorted(ADDED), f"the guide has steps for {sorted(steps)}"
    named = [name for title in ADDED for name in apply_steps(steps[title], fresh)]
    kept = [path.relative_to(FIXTURES).as_posix() for path in (FIXTURES / "src").rglob("*") if path.is_file()]
    assert sorted(named) == sorted(kept), f"the guide and {FIXTURES} differ in {sorted(set(named) ^ set(kept))}"
    for path in (path for path in fresh.rglob("*") if path.is_file()):
        other = tree / path.relative_to(fresh)
        if other.is_file() and other.read_bytes() == path.read_bytes():
            shutil.copystat(other, path)
    shutil.rmtree(tree, ignore_errors=True)
    fresh.rename(tree)
    return tree
