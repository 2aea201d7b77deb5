"""Builds the C++ reference with Doxygen: cpp_reference.py FOLDER writes FOLDER/fccda and FOLDER/perimpact.

fccda: fccda/fccda.hpp and all that it includes, and fccda/fccda.h; everything there must be documented. perimpact: the headers of the solver, which are not installed;
for those who work on it. In both, any warning is an error."""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCE = ROOT / "src"

COMMON = """
QUIET = YES
WARN_AS_ERROR = FAIL_ON_WARNINGS
GENERATE_LATEX = NO
HAVE_DOT = NO
DISABLE_INDEX = NO
GENERATE_TREEVIEW = YES
SEARCHENGINE = YES
HTML_TIMESTAMP = NO
JAVADOC_AUTOBRIEF = YES
DISTRIBUTE_GROUP_DOC = YES
MACRO_EXPANSION = YES
EXTRACT_STATIC = YES
SHOW_INCLUDE_FILES = YES
VERBATIM_HEADERS = NO
SOURCE_BROWSER = NO
"""


def headers_from(header):
    """The header and all of ours that it includes, by paths below src/."""
    found, waiting = set(), [header]
    while waiting:
        name = waiting.pop()
        if name not in found and (SOURCE / name).exists():  # CMake writes the lists of materials and the like to the build folder
            found.add(name)
            waiting += re.findall(r'^#include "([^"]+)"', (SOURCE / name).read_text(encoding="utf-8"), re.MULTILINE)
    return found


def build(name, brief, headers, folder, more):
    (folder / name).mkdir(parents=True)
    front = folder / f"{name}.dox"
    front.write_text(f"/** @mainpage {name}\n{brief}: [classes](annotated.html), [functions](namespace{name}.html), [headers](files.html). "
                     f"Guides and theory are in <a href=\"../../docs/index.html\">the documentation</a>. */\n"
                     f"/** @namespace {name} {brief}. */\n", encoding="utf-8")
    version = re.search(r"project\(perimpact VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
    settings = {
        "PROJECT_NAME": name, "PROJECT_BRIEF": f'"{brief}"', "PROJECT_NUMBER": version, "OUTPUT_DIRECTORY": folder / name, "HTML_OUTPUT": ".",
        "STRIP_FROM_PATH": SOURCE, "STRIP_FROM_INC_PATH": SOURCE, "INCLUDE_PATH": SOURCE,
        "INPUT": " ".join([str(front)] + [str(SOURCE / each) for each in sorted(headers)]),
        "INPUT_FILTER": f'"/usr/bin/python3 {ROOT / "docs/site/cpp_filter.py"}"', **more}
    text = COMMON + "".join(f"{key} = {value}\n" for key, value in settings.items())
    if subprocess.run(["doxygen", "-"], input=text, text=True, cwd=ROOT).returncode != 0:
        sys.exit(f"doxygen warns about the headers of {name}; correct their comments.")
    front.unlink()


def without_dead_links(folder):
    """Doxygen 1.9 links to the section of nested classes where all of them are private and it writes none, and to constants of enumerations in
    other files by a wrong name. Such links become plain text."""
    text_of = {path: path.read_text(encoding="utf-8") for path in folder.rglob("*.html")}
    places = {path: set(re.findall(r'(?:id|name)="([^"]+)"', text)) for path, text in text_of.items()}
    for path, text in text_of.items():
        def kept(link):
            file, place = link[1], link[2]
            target = (path.parent / file).resolve() if file else path
            return link[0] if place in places.get(target, {place}) else link[3]

        changed = re.sub(r'<a [^>]*href="([^"#:]*)#([^"]+)"[^>]*>(.*?)</a>', kept, text)
        if changed != text:
            path.write_text(changed, encoding="utf-8")


def main():
    folder = Path(sys.argv[1]).resolve()
    library = headers_from("fccda/fccda.hpp") | {"fccda/fccda.h"}
    solver = headers_from("perimpact/simulation/simulation.hpp") - library
    tags = folder / "fccda.tag"
    build("fccda", "Contact of points with a moving rigid surface", library, folder,
          {"WARN_IF_UNDOCUMENTED": "YES", "HIDE_UNDOC_MEMBERS": "NO", "GENERATE_TAGFILE": tags})
    build("perimpact", "The peridynamic solver", solver, folder,
          {"EXTRACT_ALL": "YES", "WARN_IF_UNDOCUMENTED": "NO", "TAGFILES": f"{tags}=../fccda"})
    tags.unlink()
    without_dead_links(folder)


main()
