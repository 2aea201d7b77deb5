/// Modes of a file on the vertices of a surface.
#pragma once

#include "fccda/elastic/modes.hpp"
#include "fccda/modes/modes_file.hpp"
#include "mesh/panels.hpp"

namespace fccda {

/// The modes on the vertices of the panels, which are found among the points of the file by their positions, within a millionth of the size of the surface, in
/// any order; other points of the file are ignored. Vertices that no panel uses have zero shapes and stresses where the file has no point for them.
///
/// Throws InputError with the first vertex that has no point; where several points at a vertex move differently; where a mode does not move the surface or is,
/// on it, a linear combination of the modes before it.
Modes modes_on(const Panels& panels, const ModesFile& file);

}  // namespace fccda
