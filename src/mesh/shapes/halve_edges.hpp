/// Cuts the triangles of a sheet smaller where its edges are too long, at points that the caller places.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace fccda {

struct SheetRules {
  /// How long an edge is over what it may be at most; above 1 it is halved.
  std::function<double(int, int)> excess;
  /// Length of an edge [m], by which the longest of a triangle is chosen.
  std::function<double(int, int)> length;
  /// Makes the vertex halfway between two; its number.
  std::function<int(int, int)> middle;
};

/// Halves edges until none has an excess above 1. Always the longest edge of a triangle is halved, and before it any longer one of the
/// triangle beyond, so that the sheet stays without gaps and angles do not grow small (Rivara, Int. J. Numer. Methods Eng. 40 (1997) 3313).
/// Which triangle comes first does not depend on anything but the numbers. At most two triangles share an edge.
void halve_edges(std::vector<std::array<int, 3>>& triangles, const SheetRules& rules);

}  // namespace fccda
