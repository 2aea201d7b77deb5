#include "perimpact/impactor/modes_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <string>

#include "base/contract.hpp"
#include "mesh_io/modes/modes_on.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

namespace {

double frequency(const fccda::Mode& mode) { return mode.angular_frequency / (2 * std::numbers::pi); }

void leave_out_high_modes(fccda::Modes& modes, const ElasticImpactorSetup& elastic, const std::string& key) {
  if (!elastic.highest_frequency) return;
  const auto lowest =
      std::min_element(modes.begin(), modes.end(), [](const fccda::Mode& a, const fccda::Mode& b) { return a.angular_frequency < b.angular_frequency; });
  if (frequency(*lowest) > *elastic.highest_frequency)
    throw SetupError(key + ".highest_frequency", fmt::format("highest_frequency is {:.4g} Hz, but the lowest mode of {} has {:.4g} Hz; raise it, or remove "
                                                             "elastic.",
                                                             *elastic.highest_frequency, elastic.modes, frequency(*lowest)));
  std::erase_if(modes, [&](const fccda::Mode& mode) { return frequency(mode) > *elastic.highest_frequency; });
}

}  // namespace

fccda::Modes modes_of(const ImpactorSetup& setup, const fccda::Surface& surface) {
  EXPECTS(setup.elastic.has_value());
  const ElasticImpactorSetup& elastic = *setup.elastic;
  const std::string key = fmt::format("impactors.{}.elastic", setup.name);
  try {
    fccda::Modes modes = fccda::modes_on(surface.panels(), fccda::read_modes(elastic.modes));
    leave_out_high_modes(modes, elastic, key);
    if (elastic.damping)
      for (fccda::Mode& mode : modes) mode.damping_ratio = *elastic.damping;
    return modes;
  } catch (const SetupError&) {
    throw;
  } catch (const fccda::InputError& error) {
    throw SetupError(key + ".modes", error);
  }
}

}  // namespace perimpact
