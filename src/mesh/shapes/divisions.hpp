/// Subdivision of lengths and circles into panels.
#pragma once

#include <initializer_list>
#include <string_view>

namespace fccda {

/// Kind of panels of a generated surface.
enum class PanelKind { triangles, quads };

/// The smallest number of equal parts of `length` that are at most `panel` long, at least 1. A ratio that is whole up to rounding (lengths
/// such as 0.05 and 0.001) is taken as whole.
double divisions(double length, double panel);

/// The smallest multiple of 4 of equal chords of a circle that are at most `panel` long: with a vertex on one axis, such a polygon has
/// vertices on both axes and is symmetric about both.
double circle_divisions(double radius, double panel);

/// Throws InputError if a length of a shape is not positive and finite, or its edge length `panel` is negative or not a number. 0 stands for
/// the default of the shape.
void expect_sizes(std::initializer_list<double> lengths, double panel, std::string_view shape);

/// Throws InputError if a shape would have more than a hundred million panels, before memory is allocated.
void expect_affordable(double panels, double panel, std::string_view shape);

}  // namespace fccda
