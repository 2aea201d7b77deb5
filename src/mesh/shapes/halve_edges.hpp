/// Bisection of the triangles of a sheet where edges are too long, with new vertices placed by the caller.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace fccda {

struct SheetRules {
  /// Ratio of an edge's length to the largest admissible one; above 1 it is halved.
  std::function<double(int, int)> excess;
  /// Length of an edge [m], for the choice of the longest of a triangle.
  std::function<double(int, int)> length;
  /// Creates the vertex halfway between two; returns its number.
  std::function<int(int, int)> middle;
};

/// Halves edges until none has an excess above 1. Only the longest edge of a triangle is halved, after any longer one of the triangle
/// beyond, so that the sheet stays conforming and angles stay bounded (Rivara, Int. J. Numer. Methods Eng. 40 (1997) 3313).
/// The order of triangles depends on nothing but their numbers. At most two triangles share an edge.
void halve_edges(std::vector<std::array<int, 3>>& triangles, const SheetRules& rules);

}  // namespace fccda
