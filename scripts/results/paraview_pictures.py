"""Pictures of any results folder with ParaView, one for each frame or for some times:

    xvfb-run -a -s "-noreset -screen 0 1280x1024x24" pvpython scripts/results/paraview_pictures.py RESULTS [--out FOLDER] [--times 20e-6 60e-6] [--colour damage] [--from 0.4 -1 0.8]

Writes FOLDER/picture_00007.png and so on (default: RESULTS/pictures), numbered like the frames. Bodies are balls of their particles, coloured by damage
where bonds may break, else by speed, as far as the frames have them; impactors are their panels. `--from` is where the eye is, seen from the middle of all bodies; z is up. Debian: paraview, python3-paraview, xvfb, xauth. Without xvfb-run ParaView needs a screen;
without -noreset the server may be restarting when ParaView asks for it a second time ("bad X server connection").
"""

import json
import sys
from pathlib import Path

try:
    from paraview import simple
except ImportError:
    sys.exit("error: this needs ParaView's own Python: xvfb-run -a -s -noreset pvpython scripts/results/paraview_pictures.py RESULTS (Debian: paraview, python3-paraview, xvfb, xauth)")

sys.path.insert(0, str(Path(__file__).resolve().parent))
from results_folder import options, refuse, run  # noqa: E402

COLOURS = {  # array: title of the bar, ParaView's preset
    "damage": ("damage [-]", "Inferno (matplotlib)"),
    "velocity": ("speed [m/s]", "Inferno (matplotlib)"),
    "displacement": ("displacement [m]", "Viridis (matplotlib)"),
    "fragment": ("fragment [-]", "Turbo"),
    "plastic_strain": ("plastic strain [-]", "Viridis (matplotlib)"),
}
SIZE = 1000, 640
INK = [0.11, 0.15, 0.2]


def spacing_of(folder, name, bounds, points):
    """Between particles [m]: that of run.json, else, as of a cloud without one, from their box."""
    report = folder / "run.json"  # a run that has not ended has none
    given = json.loads(report.read_text(encoding="utf-8"))["bodies"][name].get("spacing [m]") if report.exists() else None
    extents = [max(bounds[2 * axis + 1] - bounds[2 * axis], 0) for axis in range(3)]
    filled = [extent for extent in extents if extent > 1e-9 * max(extents)]
    volume = 1.0
    for extent in filled:
        volume *= extent
    return given or (volume / points) ** (1 / max(len(filled), 1))


def read(folder):
    """Bodies and impactors by their names: those that have frames."""
    bodies, impactors = {}, {}
    for path in sorted([*(folder / "frames").glob("*.pvd"), *(folder / "frames").glob("*.vtkhdf")]):  # .vtkhdf from ParaView 5.12 on
        source = simple.OpenDataFile(str(path.resolve()))  # a relative name is taken from where ParaView was started
        source.UpdatePipeline()
        (impactors if simple.servermanager.Fetch(source).GetNumberOfPolys() else bodies)[path.stem] = source
    return bodies, impactors


def array_of(arrays, wanted):
    """The array that colours a body with these. Damage of one that cannot break is zero."""
    if wanted in arrays:
        return wanted
    may_break = "fragment" in arrays or "velocity" not in arrays
    return "damage" if "damage" in arrays and may_break else "velocity" if "velocity" in arrays else None


def arrays_of(source):
    """The numbers of components of the arrays, by their names."""
    arrays = [source.PointData.GetArray(i) for i in range(len(source.PointData))]
    return {array.Name: array.GetNumberOfComponents() for array in arrays}


def show_body(view, source, spacing, arrays, colour):
    shown = simple.Show(source, view, "GeometryRepresentation")
    shown.SetRepresentationType("Point Gaussian")
    shown.GaussianRadius = 0.7 * spacing
    shown.ShaderPreset = "Sphere"
    if colour:
        simple.ColorBy(shown, ("POINTS", colour, "Magnitude") if arrays[colour] > 1 else ("POINTS", colour))


def show_impactor(view, source):
    shown = simple.Show(source, view, "GeometryRepresentation")
    shown.ColorArrayName = ["POINTS", ""]
    shown.SetRepresentationType("Surface With Edges")
    shown.EdgeColor = [0.55, 0.58, 0.63]
    shown.LineWidth = 0.5
    shown.DiffuseColor = shown.AmbientColor = [0.83, 0.85, 0.88]


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
    parser = options(__doc__)
    parser.add_argument("--out", type=Path)
    parser.add_argument("--times", type=float, nargs="+", help="[s]; the nearest frames. All if left out")
    parser.add_argument("--colour", metavar="ARRAY", help="an array of the frames; damage where bonds may break, else velocity, if left out")
    parser.add_argument("--from", dest="eye", type=float, nargs=3, default=[-0.35, -0.9, 0.9])
    given = parser.parse_args()
    sources, impactors = read(given.results)
    everything = [*sources.values(), *impactors.values()]
    if not everything:
        refuse(f"{given.results} has no frames; run the deck with output.frames above 0.")
    arrays = {name: arrays_of(source) for name, source in sources.items()}
    known = sorted({array for each in arrays.values() for array in each})
    if given.colour and given.colour not in known:
        refuse(f"no frames have {given.colour}; they have {', '.join(known) or 'no arrays'}.")
    colours = {name: array_of(each, given.colour) for name, each in arrays.items()}
    out = given.out or given.results / "pictures"
    out.mkdir(parents=True, exist_ok=True)

    simple._DisableFirstRenderCameraReset()
    view = simple.CreateRenderView()
    view.ViewSize, view.Background, view.UseColorPaletteForBackground, view.OrientationAxesVisibility = SIZE, [1, 1, 1], 0, 0
    for name, source in sources.items():
        information = source.GetDataInformation()
        show_body(view, source, spacing_of(given.results, name, information.GetBounds(), information.GetNumberOfPoints()), arrays[name], colours[name])
    for source in impactors.values():
        show_impactor(view, source)
    times = list(everything[0].TimestepValues)
    wanted = range(len(times)) if given.times is None else [min(range(len(times)), key=lambda i: abs(times[i] - time)) for time in given.times]
    label = simple.Text()
    text = simple.Show(label, view)
    text.FontSize, text.Color, text.WindowLocation = 16, INK, "Upper Left Corner"

    # one scale for all frames, so that pictures can be compared; damage has a scale of its own
    for colour in {colour for colour in colours.values() if colour}:
        title, preset = COLOURS.get(colour, (colour.replace("_", " "), "Viridis (matplotlib)"))
        table = simple.GetColorTransferFunction(colour)
        table.ApplyPreset(preset, True)
        highest = 0.0
        for number in wanted:
            for name, source in sources.items():
                if colours[name] == colour:
                    source.UpdatePipeline(times[number])
                    highest = max(highest, source.PointData[colour].GetRange(-1 if arrays[name][colour] > 1 else 0)[1])
        table.RescaleTransferFunction(0, 1 if colour == "damage" else highest or 1)
        bar = simple.GetScalarBar(table, view)
        bar.Title, bar.ComponentTitle, bar.TitleColor, bar.LabelColor = title, "", INK, INK
        bar.TitleFontSize, bar.LabelFontSize, bar.ScalarBarLength, bar.WindowLocation = 16, 14, 0.3, "Lower Right Corner"
        bar.LabelFormat = bar.RangeLabelFormat = "%.3g"
        bar.Visibility = 1
    look(view, everything, given.eye)
    for number in wanted:
        view.ViewTime = times[number]
        label.Text = in_words(times[number])
        path = out / f"picture_{number:05d}.png"
        simple.SaveScreenshot(str(path), view, ImageResolution=SIZE)
        print(path)


run(main)
