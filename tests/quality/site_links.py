"""Every link inside a built site leads to a file, and to a place in it where it names one; and no page asks the network for anything.

    site_links.py FOLDER
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.loads, self.places = [], [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if "id" in attributes:
            self.places.add(attributes["id"])
        if tag == "a" and attributes.get("href"):
            self.links.append(attributes["href"])
        if tag in ("img", "script", "source") and attributes.get("src"):
            self.loads.append(attributes["src"])
        if tag == "link" and "stylesheet" in (attributes.get("rel") or ""):
            self.loads.append(attributes["href"])


def faults_of(root):
    pages = {path: Page(path) for path in root.rglob("*.html")}
    assert len(pages) > 30, f"there are hardly any pages in {root}"
    for path, page in pages.items():
        name = path.relative_to(root)
        for link in page.loads:
            if urlsplit(link).netloc:
                yield f"{name} loads {link} from the network"
        for link in page.links + page.loads:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not target.is_file():
                yield f"{name} links to {link}, which is not there"
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].places:
                yield f"{name} links to {link}, but that page has no such place"


def main():
    faults = sorted(set(faults_of(Path(sys.argv[1]).resolve())))
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
