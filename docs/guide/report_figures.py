#!/usr/bin/python3
"""Draws the pictures of report.md: reports of two runs of shipped cases, as Chromium shows them.

    docs/guide/report_figures.py PLATE/report.html SHIP/report.html

PLATE: results of cases/plate_impact/deck.yaml. SHIP: results of cases/ship_ice/deck.yaml; its first 2.6 s, in 26 frames, are enough
(--set time.end="2.6 s" --set output.frames=26). Needs chromium and python3-pil.
"""

import sys
from pathlib import Path

from PIL import Image

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tests/browser"))
from chromium import Page  # noqa: E402

WIDTH, HEIGHT = 1240, 700
LARGEST = 200  # [kB]


def draw(report, picture, share, choices):
    """The frame at this share of the run, with the values of its controls."""
    page = Page(WIDTH, HEIGHT)
    try:
        page.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "light"}])
        page.open(report)
        page.wait_for("document.documentElement?.dataset.state === 'ready'", 300)
        last = int(page.value("document.getElementById('slider').max"))
        for control, value in {"slider": round(last * share), **choices}.items():
            page.value(f"""(e => {{
                e.value = [...e.options ?? []].find(each => each.text === '{value}')?.value ?? '{value}';
                for (const kind of ['input', 'change']) e.dispatchEvent(new Event(kind));
            }})(document.getElementById('{control}'))""")
        page.value("new Promise(done => setTimeout(() => done(true), 1000))")
        assert not page.complaints, page.complaints
        page.picture(picture)
    finally:
        page.close()
    Image.open(picture).convert("RGB").save(picture, optimize=True)
    size = picture.stat().st_size / 1000
    assert size < LARGEST, f"{picture} has {size:.0f} kB; choose a simpler view"
    print(f"{picture}: {size:.0f} kB")


def main():
    plate, ship = (Path(each) for each in sys.argv[1:])
    draw(plate, HERE / "figures/report_plate.png", 60 / 200, {"colour": "speed", "range": "of the frame", "opacity": 0.6})
    draw(ship, HERE / "figures/report_ship.png", 1.6 / 2.6, {"colour": "damage", "opacity": 0.4})


main()
