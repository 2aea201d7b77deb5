#include "perimpact/impactor/gauges_of.hpp"

#include <fmt/format.h>

#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

using namespace fccda;

std::vector<NamedGauge> gauges_of(const ImpactorSetup& setup, const Surface& surface, const RigidBody& body) {
  std::vector<NamedGauge> gauges;
  for (const GaugeSetup& gauge : setup.gauges) {
    const std::string key = fmt::format("impactors.{}.gauges.{}", setup.name, gauge.name);
    Gauge::Mounting mounting{.parts = gauge.surface_parts, .point = gauge.point.value_or(body.properties().centre_of_mass)};
    if (gauge.axis) {
      if (*gauge.axis == Vec3d{}) throw SetupError(key + ".axis", "axis is zero and has no direction; give one, such as [0, 0, 1].");
      mounting.axis = normalised(*gauge.axis);
    }
    try {
      gauges.push_back({setup.name + "." + gauge.name, Gauge(mounting, surface)});
    } catch (const InputError& error) {
      throw SetupError(key + ".surface_parts", fmt::format("gauge {}: {}", gauge.name, error.what()));
    }
  }
  return gauges;
}

}  // namespace perimpact
