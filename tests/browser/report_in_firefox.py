"""A report as Firefox shows it: it loads, draws, saves and prints as in Chromium, and complains of nothing.

    report_in_firefox.py PROGRAM
"""

import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
from claims import DECK, changed
from firefox import Page
from saved import expect_paper, expect_saved

COLOURS = """(() => {
  const view = document.getElementById('canvas');
  const copy = Object.assign(document.createElement('canvas'), { width: view.width, height: view.height });
  const context = copy.getContext('2d');
  context.drawImage(view, 0, 0);
  return new Set(new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer)).size;
})()"""


def main():
    with tempfile.TemporaryDirectory(prefix="perimpact-") as folder:
        folder = Path(folder)
        (folder / "deck.yaml").write_text(changed(DECK, ("density: 8000 kg/m3}", "density: 8000 kg/m3, critical_stretch: 0.0001}")))
        subprocess.run([Path(sys.argv[1]).resolve(), "run", "deck.yaml", "--force"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        downloads = folder / "downloads"
        downloads.mkdir()
        page = Page(1200, 760, downloads)
        try:
            page.open(folder / "results/report.html")
            seconds = page.wait_for("['ready', 'failed'].includes(document.documentElement.dataset.state)")
            assert page.value("document.documentElement.dataset.state") == "ready", page.value("document.body.innerText")
            page.press("End")
            assert page.value("document.getElementById('slider').value") == "4", "End goes to the last frame"
            for colour in page.value("[...document.getElementById('colour').options].map(each => each.value)"):
                page.value(f"(e => {{ e.value = '{colour}'; e.dispatchEvent(new Event('change')); }})(document.getElementById('colour'))")
            page.value("(e => { e.value = 'speed'; e.dispatchEvent(new Event('change')); })(document.getElementById('colour'))")
            page.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))")
            colours = page.value(COLOURS)
            assert colours > 500, f"the view has {colours} colours only"
            expect_saved(page, downloads, folder / "results", frames=5)
            expect_paper(page, folder)
            assert page.complaints == [], page.complaints
            print(f"Firefox {page.about['browserVersion']}: ready after {seconds:.1f} s; view, files and paper are as they should be")
        finally:
            page.close()


main()
