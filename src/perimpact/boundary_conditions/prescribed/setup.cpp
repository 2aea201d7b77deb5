#include "perimpact/boundary_conditions/prescribed/setup.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>

#include "perimpact/deck_model/deck_context.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<DisplacementSetup>> DisplacementSetup::fields() {
  using S = DisplacementSetup;
  static const Field<S> all[] = {
      {"velocity", &S::velocity, "m/s", any_number(), optional, "Constant velocity from t = 0 on."},
      {"displacement", &S::displacement, "m", any_number(), optional, "Constant displacement from t = 0 on."},
      {"times", &S::times, "s", any_number(), optional, table_times_sentence},
      {"velocities", &S::velocities, "m/s", any_number(), optional,
       "Velocity at each time; the displacement is zero at t = 0. Constant before the first time and after the last."},
      {"displacements", &S::displacements, "m", any_number(), optional,
       "In place of velocities: displacement from the undeformed position at each time. Constant before the first time and after the last."},
      {"file", &S::file, "", {}, optional, table_file_sentence}};
  return all;
}

std::span<const Field<PrescribedSetup>> PrescribedSetup::fields() {
  static const Field<PrescribedSetup> all[] = {{"particle_set", &PrescribedSetup::particle_set, "", {}, optional, particle_set_sentence}};
  return all;
}

namespace {

void check_history(DisplacementSetup& history, const std::string& key, const BodyContext& deck) {
  const std::pair<std::string_view, bool> forms[] = {
      {"velocity", history.velocity.has_value()},  {"displacement", history.displacement.has_value()}, {"times", !history.times.empty()},
      {"velocities", !history.velocities.empty()}, {"displacements", !history.displacements.empty()},  {"file", !history.file.empty()}};
  std::string_view first;
  for (const auto& [form, is_given] : forms) {
    if (!is_given) continue;
    if (first.empty()) first = form;
    if (first != form && (first == "velocity" || first == "displacement"))
      throw SetupError(fmt::format("{}.{}", key, form),
                       fmt::format("{} is given together with {}, which applies at all times; keep one of the two.", form, first));
  }
  if (first.empty()) throw SetupError(key, fmt::format("{} needs a velocity or a displacement, times with either, or a file.", key));
  if (first == "velocity" || first == "displacement") return;
  check_table(history, key, deck.places);
  deck.read_table(history, key);
}

}  // namespace

void PrescribedSetup::check(BodyContext& deck) {
  if (!x && !y && !z) deck.refuse(fmt::format("{} prescribes no motion; give x, y or z.", deck.key));
  for (std::size_t axis = 0; axis < std::size(axis_words); ++axis)
    if (auto& history = of(axis)) check_history(*history, fmt::format("{}.{}", deck.key, axis_words[axis]), deck);
  if (z) refuse_along_z("z", deck);
}

}  // namespace perimpact
