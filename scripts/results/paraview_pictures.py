"""Pictures of any results folder with ParaView, one for each frame or for some times:

    xvfb-run -a -s "-noreset -screen 0 1280x1024x24" pvpython scripts/results/paraview_pictures.py RESULTS [--out FOLDER] [--times 20e-6 60e-6] [--colour damage] [--from 0.4 -1 0.8]

Writes FOLDER/picture_00007.png and so on (default: RESULTS/pictures), numbered like the frames. Bodies are balls of their particles, coloured by damage
where bonds may break, else by speed; impactors are their panels. `--from` is where the eye is, seen from the middle of all bodies; z is up. Debian: paraview, python3-paraview, xvfb, xauth. Without xvfb-run ParaView needs a screen;
without -noreset the server may be restarting when ParaView asks for it a second time ("bad X server connection").
"""

import argparse
import json
import sys
from pathlib import Path

try:
    from paraview import simple
except ImportError:
    sys.exit("error: this needs ParaView's own Python: xvfb-run -a -s -noreset pvpython scripts/results/paraview_pictures.py RESULTS (Debian: paraview, python3-paraview, xvfb, xauth)")

COLOURS = {  # array: title of the bar, ParaView's preset
    "damage": ("damage [-]", "Inferno (matplotlib)"),
    "velocity": ("speed [m/s]", "Inferno (matplotlib)"),
    "displacement": ("displacement [m]", "Viridis (matplotlib)"),
    "fragment": ("fragment [-]", "Turbo"),
}
SIZE = 1000, 640
INK = [0.11, 0.15, 0.2]


def spacings(report, name, bounds, points):
    """Between particles [m]: of a cloud without one, from its box."""
    given = report["bodies"][name].get("spacing [m]")
    extents = [max(bounds[2 * axis + 1] - bounds[2 * axis], 0) for axis in range(3)]
    filled = [extent for extent in extents if extent > 1e-9 * max(extents)]
    volume = 1.0
    for extent in filled:
        volume *= extent
    return given or (volume / points) ** (1 / len(filled))


def read(folder, name):
    path = folder / "frames" / f"{name}.vtkhdf"  # from ParaView 5.12 on
    if not path.exists():
        path = path.with_suffix(".pvd")
    if not path.exists():
        sys.exit(f"error: {path} is not there: the run left no pictures. Run it with output.frames above 0")
    reader = simple.OpenDataFile(str(path.resolve()))  # a relative name is taken from where ParaView was started
    reader.UpdatePipeline()
    return reader


def show_body(view, folder, report, name, colour):
    source = read(folder, name)
    information = source.GetDataInformation()
    arrays = [source.PointData.GetArray(i).Name for i in range(len(source.PointData))]
    if colour not in arrays:
        colour = "damage" if colour is None and "fragment" in arrays else "velocity" if colour is None else sys.exit(f"error: {name} has no array {colour}; it has {', '.join(arrays)}")
    shown = simple.Show(source, view, "GeometryRepresentation")
    shown.SetRepresentationType("Point Gaussian")
    shown.GaussianRadius = 0.7 * spacings(report, name, information.GetBounds(), information.GetNumberOfPoints())
    shown.ShaderPreset = "Sphere"
    simple.ColorBy(shown, ("POINTS", colour, "Magnitude") if colour in ("velocity", "displacement") else ("POINTS", colour))
    return source, shown, colour


def show_impactor(view, folder, name):
    source = read(folder, name)
    shown = simple.Show(source, view, "GeometryRepresentation")
    shown.ColorArrayName = ["POINTS", ""]
    shown.SetRepresentationType("Surface With Edges")
    shown.EdgeColor = [0.55, 0.58, 0.63]
    shown.LineWidth = 0.5
    shown.DiffuseColor = shown.AmbientColor = [0.83, 0.85, 0.88]
    return source


def look(view, sources, eye):
    bounds = [source.GetDataInformation().GetBounds() for source in sources]
    low, high = [min(b[2 * axis] for b in bounds) for axis in range(3)], [max(b[2 * axis + 1] for b in bounds) for axis in range(3)]
    extents = [b - a for a, b in zip(low, high)]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    view.CameraFocalPoint = middle
    view.CameraPosition = [m + 3 * max(extents) * e for m, e in zip(middle, eye)]
    view.CameraViewUp = [0, 0, 1]
    view.ResetCamera(*[value for pair in zip(low, high) for value in pair])
    view.GetActiveCamera().Dolly(1.2)  # ParaView leaves room for turning


def in_words(time):
    size, unit = next(pair for pair in ((1, "s"), (1e-3, "ms"), (1e-6, "µs"), (0, "µs")) if time >= pair[0])
    return f"{time / (size or 1e-6):.4g} {unit}"


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("results", type=Path)
    arguments.add_argument("--out", type=Path)
    arguments.add_argument("--times", type=float, nargs="+", help="[s]; the nearest frames. All if left out")
    arguments.add_argument("--colour", choices=COLOURS, help="damage where bonds may break, else velocity")
    arguments.add_argument("--from", dest="eye", type=float, nargs=3, default=[-0.35, -0.9, 0.9])
    given = arguments.parse_args()
    try:
        report = json.loads((given.results / "run.json").read_text())
    except FileNotFoundError:
        sys.exit(f"error: {given.results}/run.json is not there: is this the folder of a run?")
    out = given.out or given.results / "pictures"
    out.mkdir(parents=True, exist_ok=True)

    simple._DisableFirstRenderCameraReset()
    view = simple.CreateRenderView()
    view.ViewSize, view.Background, view.UseColorPaletteForBackground, view.OrientationAxesVisibility = SIZE, [1, 1, 1], 0, 0
    bodies = [show_body(view, given.results, report, name, given.colour) for name in report["bodies"]]
    impactors = [show_impactor(view, given.results, name) for name in report["impactors"]]
    times = list(bodies[0][0].TimestepValues)
    wanted = range(len(times)) if given.times is None else [min(range(len(times)), key=lambda i: abs(times[i] - time)) for time in given.times]
    label = simple.Text()
    text = simple.Show(label, view)
    text.FontSize, text.Color, text.WindowLocation = 16, INK, "Upper Left Corner"

    # one scale for all frames, so that pictures can be compared; damage has a scale of its own
    for colour in {colour for _, _, colour in bodies}:
        title, preset = COLOURS[colour]
        table = simple.GetColorTransferFunction(colour)
        table.ApplyPreset(preset, True)
        highest = 0.0
        for number in wanted:
            for source, _, own in bodies:
                if own == colour:
                    source.UpdatePipeline(times[number])
                    array = source.PointData[colour]
                    highest = max(highest, array.GetRange(-1 if array.GetNumberOfComponents() > 1 else 0)[1])
        table.RescaleTransferFunction(0, 1 if colour == "damage" else highest or 1)
        bar = simple.GetScalarBar(table, view)
        bar.Title, bar.ComponentTitle, bar.TitleColor, bar.LabelColor = title, "", INK, INK
        bar.TitleFontSize, bar.LabelFontSize, bar.ScalarBarLength, bar.WindowLocation = 16, 14, 0.3, "Lower Right Corner"
        bar.LabelFormat = bar.RangeLabelFormat = "%.3g"
        bar.Visibility = 1
    look(view, [source for source, *_ in bodies] + impactors, given.eye)
    for number in wanted:
        view.ViewTime = times[number]
        label.Text = in_words(times[number])
        path = out / f"picture_{number:05d}.png"
        simple.SaveScreenshot(str(path), view, ImageResolution=SIZE)
        print(path)


main()
