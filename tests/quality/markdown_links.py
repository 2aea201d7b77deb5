"""Every link between files of the repository leads to a file, and to a heading of it where it names one, as the Markdown is read on its own.

    markdown_links.py ROOT
"""

import re
import subprocess
import sys
from pathlib import Path
from urllib.parse import unquote, urlsplit

IMAGE = re.compile(r"!\[[^\]]*\]\(([^()\s]+)\)")  # also inside the text of a link
LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\[\]]*\]|!\[[^\]]*\]\([^)]*\))*\]\(([^()\s]+)\)")


def text_of(page):
    """Without what is code, in blocks and in words."""
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL))


def slugs_of(page):
    """The places that headings are, as GitHub names them."""
    found = set()
    for heading in re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL), re.MULTILINE):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
        slug = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        again = 0
        while (name := slug if again == 0 else f"{slug}-{again}") in found:
            again += 1
        found.add(name)
    return found


def faults_of(root):
    listed = subprocess.run(["git", "-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard", "*.md"], capture_output=True, text=True)
    pages = [root / name for name in listed.stdout.split("\0") if name] or [
        path for path in root.rglob("*.md") if not {"build", "node_modules", "results"} & set(path.relative_to(root).parts)]
    pages = [page for page in pages if page.is_file()]
    assert len(pages) > 30, f"there are hardly any pages in {root}"
    links = 0
    for page in pages:
        text = text_of(page)
        for link in {*LINK.findall(text), *IMAGE.findall(text)}:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            links += 1
            target = (page.parent / unquote(parts.path)).resolve() if parts.path else page
            if not target.exists():
                yield f"{page.relative_to(root)}: {link} is not there"
            elif parts.fragment and target.suffix == ".md" and unquote(parts.fragment) not in slugs_of(target):
                yield f"{page.relative_to(root)}: {link}: no heading of {target.name} is called that"
    assert links > 200, "hardly any links were found"


def main():
    faults = list(faults_of(Path(sys.argv[1]).resolve()))
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
