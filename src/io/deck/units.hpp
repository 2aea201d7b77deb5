/// Conversion of numbers with units to SI by UDUNITS-2 (https://www.unidata.ucar.edu/software/udunits).
///
/// Additional units: `kn` is the knot, 1852 m/h (the kilonewton is kN), and `deg` the degree. Stricter than UDUNITS: there is no
/// conversion to reciprocals (5 Hz is not a time), and angle is a dimension, so that Hz (cycles) and rad/s, deg/s or rpm (angle) are not
/// confused.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace perimpact::deck {

/// Quantity measured by an SI unit.
struct UnitKind {
  std::string_view unit;     ///< as in the tables of fields: "m", "kg/m3", "1" for pure numbers
  std::string_view what;     ///< "a length"
  std::string_view example;  ///< "9 mm"
};

/// All units that fields may have.
std::span<const UnitKind> unit_kinds();

/// The kind of a field's unit. Throws std::logic_error if it is none of unit_kinds().
const UnitKind& kind_of(std::string_view unit);

struct Converted {
  double value = 0;
  std::string complaint;  ///< error, empty if `value` is valid: "that is a mass; write a length, for example 9 mm"
};

/// "9 mm" → 0.009 for the unit m; a plain number is already in SI. Powers of ten are exact: "9 mm" is the same double as 0.009.
/// Does not throw for invalid text; throws InputError if the unit database of UDUNITS-2 is not installed. Thread-safe.
Converted to_si(std::string_view text, std::string_view unit);

}  // namespace perimpact::deck
