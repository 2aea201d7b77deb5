#include "io/report/paraview_script.hpp"

#include <fmt/format.h>

#include <string_view>

#include "io/output/json.hpp"

namespace perimpact::report {

namespace {

constexpr std::string_view head = R"py("""Opens this run in ParaView, with its bodies coloured and its impactors.

    paraview --state=open_in_paraview.py        or File > Load State, in the window

Written by `perimpact report`. It reads frames/ beside this file, so move both together.
"""

import os

from paraview import simple

)py";

constexpr std::string_view instructions = R"py(
# File > Load State names this file; --script and the Python shell do not, and need the results folder as the current one
folder = os.path.dirname(os.path.abspath(globals().get("__file__", "here")))
TITLES = {"damage": "damage [-]", "velocity": "speed [m/s]"}


def read(name, extension):
    path = os.path.join(folder, "frames", name + extension)
    if not os.path.exists(path):
        raise SystemExit(path + " does not exist. Open this script with File > Load State, in the results folder of the run.")
    version = simple.GetParaViewVersion()
    if extension == ".vtkhdf" and (version.major, version.minor) < (5, 12):
        raise SystemExit(path + " needs ParaView 5.12 or later. This is %d.%d; run with output.frame_format: vtp for it." % (version.major, version.minor))
    source = simple.OpenDataFile(path, registrationName=name)
    source.UpdatePipeline()
    return source


simple._DisableFirstRenderCameraReset()
view = simple.GetActiveViewOrCreate("RenderView")
view.OrientationAxesVisibility = 1
shown_bodies = []
for name, extension, spacing, array in BODIES:
    source = read(name, extension)
    shown = simple.Show(source, view)
    shown.SetRepresentationType("Point Gaussian")
    shown.GaussianRadius = 0.6 * spacing
    shown.ShaderPreset = "Sphere"
    if array:
        simple.ColorBy(shown, ("POINTS", array, "Magnitude") if array == "velocity" else ("POINTS", array))
        shown.SetScalarBarVisibility(view, True)
    shown_bodies.append((source, shown, array))
for name, extension in IMPACTORS:
    shown = simple.Show(read(name, extension), view)
    shown.SetRepresentationType("Surface")
    shown.ColorArrayName = ["POINTS", ""]
    shown.DiffuseColor = shown.AmbientColor = [0.62, 0.66, 0.7]
    shown.Opacity = 0.5

scene = simple.GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
for array in {array for _, _, array in shown_bodies if array}:
    colours = simple.GetColorTransferFunction(array)
    if array == "damage":
        colours.ApplyPreset("Black-Body Radiation", True)
        colours.InvertTransferFunction()
        colours.RescaleTransferFunction(0.0, 1.0)
    else:
        colours.ApplyPreset("Viridis (matplotlib)", True)
        next(shown for _, shown, its in shown_bodies if its == array).RescaleTransferFunctionToDataRangeOverTime()
    bar = simple.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = TITLES[array], ""

times = [time for source, _, _ in shown_bodies for time in source.TimestepValues or []]
if times:
    scene.AnimationTime = max(times)
view.CameraViewUp = [0, 0, 1]
view.CameraFocalPoint = [0, 0, 0]
view.CameraPosition = [0.55, -0.72, 0.5]
boxes = [source.GetDataInformation().GetBounds() for source, _, _ in shown_bodies]
if boxes:  # the bodies fill the view, however large the impactors are
    view.ResetCamera(*[extreme(box[k] for box in boxes) for k, extreme in enumerate([min, max] * 3)])
else:
    view.ResetCamera()
simple.Render(view)
)py";

/// A string literal, in JSON as in Python.
std::string quoted(const std::string& word) {
  std::string text = output::Json(word).text();
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

/// The array that colours a body. Damage of one that cannot break is zero, and frames have those fields that were requested.
std::string_view array_of(const BodyFrames& body) {
  const bool may_break = body.has("fragment") || !body.has("velocity");
  if (body.has("damage") && may_break) return "\"damage\"";
  return body.has("velocity") ? "\"velocity\"" : "None";
}

}  // namespace

std::string paraview_script(const Frames& frames) {
  std::string out(head);
  const auto series = [](const auto& each) { return quoted(each.name) + ", " + quoted(each.frames.front().step ? ".vtkhdf" : ".pvd"); };
  out += "BODIES = [  # name, extension of its series, spacing [m], array that colours it\n";
  for (const BodyFrames& each : frames.bodies) out += fmt::format("    ({}, {}, {}),\n", series(each), each.spacing, array_of(each));
  out += "]\nIMPACTORS = [";
  for (const ImpactorFrames& each : frames.impactors) out += fmt::format("{}({})", &each == &frames.impactors.front() ? "" : ", ", series(each));
  out += "]\n";
  return out.append(instructions);
}

}  // namespace perimpact::report
