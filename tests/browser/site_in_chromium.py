"""Every page of the built documentation as Chromium shows it: nothing on the console, every image drawn, every link inside to a page that is there,
nothing requested from the network.

    site_in_chromium.py build/docs
"""

import sys
import time
from pathlib import Path
from urllib.parse import unquote, urlsplit

from chromium import Page

# For images that were not decoded, and addresses of all links, as the browser resolves them. Lazy images are asked for first.
STATE = """(async () => {
  const images = [...document.images];
  images.forEach(each => each.loading = 'eager');
  await Promise.all(images.map(each => each.decode().catch(() => {})));
  return {title: document.title, text: document.body.innerText.length, images: images.length,
          missing: images.filter(each => !each.naturalWidth).map(each => each.src), links: [...document.links].map(each => each.href)};
})()"""


def faults_of(page, file, here):
    page.complaints.clear()
    page.open(file)
    page.wait_for(f"location.href.endsWith('{file.name}') && document.readyState === 'complete'")
    state = page.value(STATE)
    yield from (f"says on its console: {each}" for each in page.complaints)
    yield from (f"lacks the image {each}" for each in state["missing"])
    if not state["title"] or state["text"] < 20:
        yield f"is empty: its title is {state['title']!r}, its text {state['text']} characters long"
    for link in set(state["links"]):
        parts = urlsplit(link)
        if parts.scheme != "file":
            continue
        if Path(unquote(parts.path)) not in here:
            yield f"links to {link}, which is not there"


def main():
    root = Path(sys.argv[1]).resolve()
    here = {path for path in root.rglob("*") if path.is_file()}
    # Doxygen's pages are of one make, and their links are tried by site_links.py: the first page of each of the two references is opened
    pages = sorted(path for path in here if path.suffix == ".html" and (root / "cpp" not in path.parents or path.name == "index.html"))
    assert len(pages) > 60, f"there are hardly any pages in {root}"
    begin, faults = time.monotonic(), []
    page = Page(1280, 900)
    try:
        for file in pages:
            if "http-equiv=\"refresh\"" in file.read_text(encoding="utf-8"):
                continue  # leads to another page at once
            faults += [f"{file.relative_to(root)} {each}" for each in faults_of(page, file, here)]
    finally:
        page.close()
    print("\n".join(faults))
    print(f"{len(pages)} pages opened in {time.monotonic() - begin:.0f} s")
    sys.exit(1 if faults else 0)


main()
