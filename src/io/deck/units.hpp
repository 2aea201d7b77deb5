/// Numbers with units, into SI, through UDUNITS-2 (https://www.unidata.ucar.edu/software/udunits).
///
/// Ours beside its units: `kn` is the knot, 1852 m/h (not the kilonewton, which is kN), and `deg` the degree. Stricter than
/// UDUNITS: units are not turned into their reciprocals (5 Hz is no time), and angles count as a dimension, so that Hz, which
/// counts cycles, and rad/s, deg/s or rpm, which count angle, are not taken for each other.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace perimpact::deck {

/// What an SI unit measures.
struct UnitKind {
  std::string_view unit;     ///< as in the tables of fields: "m", "kg/m3", "1" for pure numbers
  std::string_view what;     ///< "a length"
  std::string_view example;  ///< "9 mm"
};

/// All units that fields may have.
std::span<const UnitKind> unit_kinds();

/// The kind of a field's unit, which must be one of unit_kinds().
const UnitKind& kind_of(std::string_view unit);

struct Converted {
  double value = 0;
  std::string complaint;  ///< why `value` means nothing and what to write: "that is a mass; write a length, for example 9 mm"
};

/// "9 mm" → 0.009 for the unit m; a plain number is in SI already. Powers of ten are exact: "9 mm" is the same double as 0.009.
/// Never throws for what the user wrote; throws InputError where the unit database of UDUNITS-2 is not installed. Safe to call
/// from several threads.
Converted to_si(std::string_view text, std::string_view unit);

}  // namespace perimpact::deck
