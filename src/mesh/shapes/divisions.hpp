/// Into how many panels lengths and circles are divided.
#pragma once

#include <initializer_list>
#include <string_view>

namespace fccda {

enum class PanelKind { triangles, quads };

/// The smallest number of equal parts of `length` that are at most `panel` long, and 1 at least. A whole number of panels is taken as
/// such, although lengths like 0.05 and 0.001 are rounded.
double divisions(double length, double panel);

/// The smallest multiple of 4 of equal chords of a circle that are at most `panel` long: with a vertex on one axis, a polygon of so many
/// sides has vertices on both axes and is its own mirror image in both.
double circle_divisions(double radius, double panel);

/// Throws InputError where a length of a shape is not positive and finite, or its panel is negative or no number. A panel of 0 is for the
/// default of the shape.
void expect_sizes(std::initializer_list<double> lengths, double panel, std::string_view shape);

/// Throws InputError where a shape would have more than a hundred million panels, before any memory is asked for.
void expect_affordable(double panels, double panel, std::string_view shape);

}  // namespace fccda
