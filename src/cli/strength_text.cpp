#include "cli/strength_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "perimpact/body/compressive_strength.hpp"

namespace perimpact {

namespace {

/// Layers that are too soft in bending carry less than the layers of a plate at the same stretch.
std::string soft_layers(const BodySetup& setup, const Body& body) {
  if (body.bending) return "";
  const auto thin = bending_of_thin(setup, body.particles);
  if (!thin || thin->layers != body.failure->layers) return "";
  return fmt::format("; with the bending stiffness of these layers {:.4g} Pa", thin->relative * body.failure->flexural_strength);
}

std::string compression_text(const CompressiveStrength& strength, bool yields) {
  if (yields)
    return fmt::format("  {:<18}at {:.4g} Pa in uniaxial compression{}\n", "yields", strength.uniform,
                       *strength.faces < strength.uniform ? fmt::format("; specimens with free faces split before, at about {:.3g} Pa", *strength.faces) : "");
  const bool uniform_fails = std::isfinite(strength.uniform);
  std::string text = uniform_fails ? fmt::format("at {:.4g} Pa in uniaxial compression", strength.uniform) : "never in uniaxial compression";
  if (strength.faces && std::isfinite(*strength.faces) && *strength.faces < strength.uniform)
    text += fmt::format("{} where strain is uniform; specimens with free faces at about {:.3g} Pa", uniform_fails ? "" : ",", *strength.faces);
  return fmt::format("  {:<18}{}\n", "bonds break", text);
}

}  // namespace

std::string strength_text(const BodySetup& setup, const Body& body) {
  std::string text;
  if (const auto& failure = body.failure)
    text += fmt::format("  {:<18}above a stretch of {:.4g}: fracture energy {:.4g} J/m2, flexural strength {:.4g} Pa with {} layers{}\n", "bond failure",
                        failure->stretch, failure->fracture_energy, failure->flexural_strength, failure->layers, soft_layers(setup, body));
  if (const auto strength = compressive_strength(setup, body)) text += compression_text(*strength, body.internal.plastic() != nullptr);
  return text;
}

}  // namespace perimpact
