/// A script that opens the frames of a results folder in ParaView: open_in_paraview.py.
///
/// Python rather than a state file (.pvsm): it contains no absolute paths, so that the folder can be moved, and it names only what it sets, so
/// that it suits other versions of ParaView than that of its test.
#pragma once

#include <string>

#include "io/report/frames.hpp"

namespace perimpact::report {

std::string paraview_script(const Frames& frames);

}  // namespace perimpact::report
