#include "io/deck/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "base/contract.hpp"
#include "base/error.hpp"
#include "io/deck/trimmed.hpp"

namespace perimpact::deck {

namespace {

constexpr std::string_view temperature = "degC";  // the only unit with an offset

constexpr UnitKind kinds[] = {{"m", "a length", "9 mm"},
                              {"m3", "a volume", "1 cm3"},
                              {"s", "a time", "0.1 us"},
                              {"kg", "a mass", "1.57 kg"},
                              {"m/s", "a velocity", "32 m/s"},
                              {"m/s2", "an acceleration", "9.81 m/s2"},
                              {"Pa", "a pressure or stiffness", "9.5 GPa"},
                              {"J/m2", "an energy of an area", "12 J/m2"},
                              {"kg/m3", "a density", "900 kg/m3"},
                              {"kg m2", "a moment of inertia", "0.02 kg m2"},
                              {"rad/s", "an angular velocity", "30 rpm"},
                              {"rad", "an angle", "45 deg"},
                              {"Hz", "a frequency", "3 Hz"},
                              {"1/s", "a rate", "0.5 1/s"},
                              {"N", "a force", "5 kN"},
                              {"N m", "a moment", "3 kN m"},
                              {"m2", "an area", "4 cm2"},
                              {"N/m3", "a force density", "-8829 N/m3"},
                              {"1", "a pure number", "0.25"},
                              {temperature, "a temperature", "-5 degC"},
                              {"g/kg", "a salinity", "5 g/kg"}};

using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using Converter = std::unique_ptr<cv_converter, decltype(&cv_free)>;

/// UDUNITS has global state: one call at a time.
std::mutex& udunits_turn() {
  static std::mutex turn;
  return turn;
}

ut_system* load_system() {
  ut_set_error_message_handler(ut_ignore);
  ut_system* system = ut_read_xml(nullptr);
  if (system == nullptr) throw fccda::InputError("The unit database of UDUNITS-2 cannot be read; install it (Debian package libudunits2-data).");
  const auto alias = [&](const char* symbol, const char* definition) {
    ut_unit* unit = ut_parse(system, definition, UT_UTF8);
    EXPECTS(unit != nullptr);
    ut_map_symbol_to_unit(symbol, UT_UTF8, unit);  // a symbol, because names ignore case and kN would be a knot
    ut_free(unit);
  };
  alias("kn", "international_knot");
  alias("deg", "degree");
  return system;
}

ut_system* units_of_udunits() {
  static ut_system* system = load_system();
  return system;
}

/// Null if `text` is not a unit.
Unit parse_unit(std::string_view text) {
  const std::string terminated(text);
  return {ut_parse(units_of_udunits(), terminated.c_str(), UT_UTF8), ut_free};
}

/// Conversion factor between units; empty if their dimensions differ.
std::optional<double> factor(ut_unit* from, ut_unit* to) {
  const Unit quotient(ut_divide(from, to), ut_free);
  if (!quotient) return std::nullopt;
  // The quotient must be a number. This format keeps "rad", although UDUNITS compares angles as pure numbers, and marks units
  // with an offset (°C, "s since 2000-01-01") by an @.
  std::array<char, 256> definition;
  const int length = ut_format(quotient.get(), definition.data(), definition.size(), UT_ASCII | UT_DEFINITION);
  if (length < 0 || static_cast<std::size_t>(length) >= definition.size()) return std::nullopt;
  std::string_view left(definition.data(), static_cast<std::size_t>(length));
  if (left.ends_with(" 1")) left.remove_suffix(2);
  double ratio{};
  const auto [end, error] = std::from_chars(left.data(), left.data() + left.size(), ratio);
  if (error != std::errc{} || end != left.data() + left.size()) return std::nullopt;
  const Converter converter(ut_get_converter(from, to), cv_free);
  if (!converter || cv_convert_double(converter.get(), 0.0) != 0.0) return std::nullopt;
  return cv_convert_double(converter.get(), 1.0);
}

/// digits · by. A power of ten is added to the exponent, so that 0.1 us and 1e-7 are the same double; 10⁻⁶ is not representable, and
/// the product would be rounded three times.
double scaled(std::string_view digits, double number, double by) {
  const double power = std::round(std::log10(by));
  const bool is_power_of_ten = std::fabs(by / std::pow(10.0, power) - 1) < 4e-16;
  if (!is_power_of_ten || number == 0) return number * by;  // 0 may have any exponent
  const std::size_t mantissa = std::min(digits.find_first_of("eE"), digits.size());
  int exponent = 0;
  if (mantissa < digits.size()) {
    const std::size_t sign = digits[mantissa + 1] == '+' ? 1 : 0;
    std::from_chars(digits.data() + mantissa + 1 + sign, digits.data() + digits.size(), exponent);
  }
  const std::string shifted = fmt::format("{}e{}", digits.substr(0, mantissa), exponent + static_cast<int>(power));
  double value{};
  const auto [end, error] = std::from_chars(shifted.data(), shifted.data() + shifted.size(), value);
  return error == std::errc{} ? value : number * by;
}

/// "a mass" for a unit of some field, otherwise "in kg2".
std::string what_it_is(std::string_view unit_text, ut_unit* unit) {
  for (const UnitKind& kind : kinds)
    if (factor(unit, parse_unit(kind.unit).get())) return std::string(kind.what);
  return fmt::format("in {}", unit_text);
}

std::string wrong_kind(std::string_view unit_text, ut_unit* unit, const UnitKind& wanted) {
  const bool is_frequency = factor(unit, parse_unit("Hz").get()).has_value();
  const bool is_angle_rate = factor(unit, parse_unit("rad/s").get()).has_value();
  if (wanted.unit == "rad/s" && is_frequency)
    return fmt::format("{} counts cycles, not angle, and is not converted; write {} in rad/s, deg/s or rpm, for example {}", unit_text, wanted.what,
                       wanted.example);
  if (wanted.unit == "Hz" && is_angle_rate)
    return fmt::format("{} counts angle, not cycles, and is not converted; write {} in Hz, for example {}", unit_text, wanted.what, wanted.example);
  if (wanted.unit == "1") return fmt::format("it is {} and has no unit; write a number, for example {}", wanted.what, wanted.example);
  return fmt::format("that is {}; write {}, for example {}", what_it_is(unit_text, unit), wanted.what, wanted.example);
}

}  // namespace

std::span<const UnitKind> unit_kinds() { return kinds; }

const UnitKind& kind_of(std::string_view unit) {
  const auto kind = std::find_if(std::begin(kinds), std::end(kinds), [&](const UnitKind& k) { return k.unit == unit; });
  if (kind == std::end(kinds)) throw std::logic_error(fmt::format("\"{}\" is no unit of the deck", unit));
  return *kind;
}

Converted to_si(std::string_view text, std::string_view unit) {
  const UnitKind& wanted = kind_of(unit);
  text = trimmed(text);
  std::string_view digits = text;
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  double number{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error == std::errc::result_out_of_range) return {.complaint = "the number is outside the range of double precision; use one between 1e-300 and 1e300"};
  if (error != std::errc{} || !std::isfinite(number))
    return {.complaint = fmt::format("that is not a number; write {}, for example {}", wanted.what, wanted.example)};

  const std::string_view unit_text = trimmed(digits.substr(static_cast<std::size_t>(end - digits.data())));
  if (unit_text.empty()) return {.value = number};
  const std::lock_guard turn(udunits_turn());
  const char first = unit_text.front();
  const bool is_rate = unit_text.size() > 2 && unit_text.starts_with("1/") && std::isalpha(static_cast<unsigned char>(unit_text[2])) != 0;  // "2 1/s"
  const bool is_number_again =
      !is_rate && ((first >= '0' && first <= '9') || first == '.' || first == ',' || first == '-' || first == '+');  // "1,5 m", which UDUNITS would multiply
  const Unit given = is_number_again ? Unit(nullptr, ut_free) : parse_unit(unit_text);
  if (!given) return {.complaint = fmt::format("{} is not a unit; write {}, for example {}", unit_text, wanted.what, wanted.example)};
  if (wanted.unit == temperature) {
    const Converter converter(ut_get_converter(given.get(), parse_unit(temperature).get()), cv_free);
    if (!converter) return {.complaint = wrong_kind(unit_text, given.get(), wanted)};
    return {.value = cv_convert_double(converter.get(), number)};
  }
  const std::optional<double> by = factor(given.get(), parse_unit(wanted.unit).get());
  if (!by) return {.complaint = wrong_kind(unit_text, given.get(), wanted)};
  return {.value = scaled(digits.substr(0, static_cast<std::size_t>(end - digits.data())), number, *by)};
}

}  // namespace perimpact::deck
