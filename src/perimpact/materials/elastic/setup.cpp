#include "perimpact/materials/elastic/setup.hpp"

#include <fmt/format.h>

#include <utility>

#include "perimpact/deck_model/deck_context.hpp"
#include "perimpact/deck_model/setup.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<ElasticSetup>> ElasticSetup::fields() {
  using S = ElasticSetup;
  static const Field<S> all[] = {
      {"youngs_modulus", &S::youngs_modulus, "Pa", positive(), optional, "Young's modulus E. Required, unless ice gives it."},
      {"density", &S::density, "kg/m3", positive(), required, "Mass density ρ."},
      {"critical_stretch", &S::critical_stretch, "1", positive(), optional,
       "A bond whose stretch exceeds this fails irreversibly. Where critical_stretch, fracture_energy and flexural_strength are all absent, bonds never "
       "break."},
      {"fracture_energy", &S::fracture_energy, "J/m2", positive(), optional,
       "In place of critical_stretch: fracture energy G₀ per unit area of crack (critical energy release rate)."},
      {"flexural_strength", &S::flexural_strength, "Pa", positive(), optional,
       "In place of critical_stretch: surface stress at which a plate fails in bending; critical stretch (1 - 1/n) σ/E with n layers of particles."},
      {"layers", &S::layers, "1", between(2, 1000), optional,
       "Layers of particles through the thickness in bending, for flexural_strength. Where absent, those across the thinnest direction."}};
  return all;
}

namespace {

void check_criterion(const ElasticSetup& material, const BodyContext& deck) {
  const std::pair<const char*, bool> criteria[] = {{"critical_stretch", material.critical_stretch.has_value()},
                                                   {"fracture_energy", material.fracture_energy.has_value()},
                                                   {"flexural_strength", material.flexural_strength.has_value()}};
  const char* first = nullptr;
  for (const auto& [key, is_given] : criteria) {
    if (is_given && first)
      deck.refuse(key, fmt::format("{} is given together with {}, but each alone determines when bonds fail; remove one of the two (perimpact check reports "
                                   "what each implies).",
                                   key, first));
    if (is_given) first = key;
  }
  if (material.layers && !material.flexural_strength)
    deck.refuse("layers", "layers applies to flexural_strength only, which is not given; remove it, or give flexural_strength.");
}

}  // namespace

void ElasticSetup::check(BodyContext& deck) {
  if (ice) ice->apply(*this, deck);
  if (!youngs_modulus) deck.refuse("youngs_modulus is missing; give it, or ice with temperature and salinity or with brine_volume.");
  check_criterion(*this, deck);
  if (plasticity) plasticity->check(*this, deck);
}

}  // namespace perimpact
