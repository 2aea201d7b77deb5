"""What both browsers save from a report, and print, compared with the results folder."""

import csv
import struct
import subprocess
import time
import zipfile

import matplotlib.image
import numpy

FLOAT = 2.0**-23  # curves have single precision


def saved(folder, pattern, seconds=60):
    """The file that the browser has finished writing: browsers write to another name first."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = [path for path in folder.glob(pattern) if path.stat().st_size > 0]
        if found and not list(folder.glob("*.part")) and not list(folder.glob("*.crdownload")):
            return found[0]
        time.sleep(0.1)
    raise SystemExit(f"within {seconds} s the browser saved no {pattern}, but {[path.name for path in folder.iterdir()]}")


def size_of_png(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "not a PNG"
    return struct.unpack(">II", data[16:24])


def expect_saved(page, folder, results, frames):
    """The three buttons: the picture has twice the pixels of the view, the film one picture per frame, the table the numbers of history.csv."""
    wide, tall = page.value("[document.getElementById('canvas').clientWidth, document.getElementById('canvas').clientHeight]")
    page.value("document.getElementById('save-picture').click()")
    picture = saved(folder, "*_frame_*.png")
    assert size_of_png(picture.read_bytes()) == (2 * wide, 2 * tall), (size_of_png(picture.read_bytes()), wide, tall)
    colours = numpy.unique((255 * matplotlib.image.imread(picture)[..., :3]).astype(int).reshape(-1, 3), axis=0)
    assert len(colours) > 500, f"the picture has {len(colours)} colours only"

    page.value("document.getElementById('save-film').click()")
    with zipfile.ZipFile(saved(folder, "*_frames.zip")) as film:
        assert film.testzip() is None, film.testzip()
        assert film.namelist() == [f"frame_{k:04}.png" for k in range(frames)], film.namelist()
        pictures = [film.read(name) for name in film.namelist()]
    assert {size_of_png(each) for each in pictures} == {(wide & ~1, tall & ~1)}, {size_of_png(each) for each in pictures}
    assert len(set(pictures)) == frames, "frames of the film are equal"

    page.value("document.getElementById('save-table').click()")
    got, wanted = (list(csv.reader(path.read_text().splitlines())) for path in (saved(folder, "*_curves.csv"), results / "history.csv"))
    assert len(got) == len(wanted) and len(got[0]) > 3, (len(got), len(wanted), got[0])
    for k, name in enumerate(got[0]):
        other = wanted[0].index(name)
        for row, of_run in zip(got[1:], wanted[1:]):
            assert abs(float(row[k]) - float(of_run[other])) <= FLOAT * abs(float(of_run[other])), (name, row[k], of_run[other])


def expect_paper(page, folder):
    """Both orientations: the view and the charts are drawn on the first page, in light colours also from the dark page, and all pages are there."""
    page.value("document.documentElement.dataset.theme === 'dark' || document.getElementById('theme').click()")
    for landscape in (False, True):
        page.paper(folder / "paper.pdf", landscape)
        subprocess.run(["pdftoppm", "-r", "50", "-png", "-singlefile", folder / "paper.pdf", folder / "paper"], check=True)
        first = matplotlib.image.imread(folder / "paper.png")[..., :3]
        assert (first.shape[1] > first.shape[0]) == landscape, first.shape
        dark = numpy.mean(numpy.all(first < 0.25, axis=-1))
        assert dark < 0.05, f"{100 * dark:.1f} % of the paper is dark"
        coloured = numpy.mean(numpy.ptp(first, axis=-1) > 0.2)
        assert coloured > 0.02, f"only {100 * coloured:.2f} % of the paper is coloured: the view is missing"
        blue = numpy.array([0x3B, 0x82, 0xC4]) / 255  # of the first curve
        assert numpy.sum(numpy.all(numpy.abs(first - blue) < 0.12, axis=-1)) > 20, "no curve on the first page"
        text = subprocess.run(["pdftotext", folder / "paper.pdf", "-"], check=True, capture_output=True, text=True).stdout
        for word in ("Curves", "Map", "Run", "Checks", "Deck", "About", "youngs_modulus"):
            assert word in text, f"{word} is not on paper"
        assert "Opacity" not in text and "Save CSV" not in text, "controls are on paper"
    assert page.value("document.documentElement.dataset.theme") == "dark", "printing has changed the theme"
