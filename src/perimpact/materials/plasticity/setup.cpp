#include "perimpact/materials/plasticity/setup.hpp"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "perimpact/deck_model/deck_context.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/materials/plasticity/plasticity.hpp"

namespace perimpact {

using namespace fccda;  // the ranges
using enum Presence;

std::span<const Field<PlasticitySetup>> PlasticitySetup::fields() {
  using S = PlasticitySetup;
  static const Field<S> all[] = {
      {"surface",
       &S::surface,
       "",
       {},
       optional,
       "Yield surface J2 = a0 + a1 p + a2 p², by its source: riska-frederking (uniaxial compressive strength 4.43 MPa), derradji-aouat (9.35 MPa), kierkegaard "
       "(9.0 MPa), or von-mises (J2 = σ²/3 at every pressure; needs compressive_strength)."},
      {"compressive_strength", &S::compressive_strength, "Pa", positive(), optional,
       "Uniaxial compressive strength to which the surface of Riska and Frederking is scaled, or that of von-mises."},
      {"failure_strain", &S::failure_strain, "1", positive(), optional,
       "ε0: a particle loses its cohesion where its equivalent plastic strain exceeds ε0 + ((p/p2 - N)/M)², p its pressure and p2 that at which the surface "
       "closes."},
      {"failure_width", &S::failure_width, "1", positive(), optional, "M in that formula."},
      {"failure_pressure", &S::failure_pressure, "1", at_least(0), optional, "N in that formula: the share of p2 at which ice fails first."},
      {"friction_angle", &S::friction_angle, "rad", between(0, 1.4), optional,
       "Angle of internal friction φ of ice that has failed: its shear strength is then that of a granular material, J2 <= c p², c = 12 sin²φ/(3 - sin φ)². "
       "Where absent, failed ice keeps its shear strength and loses its tensile strength alone."}};
  return all;
}

namespace {

/// The models that support plasticity, and that of the body.
template <class... Materials>
void refuse_model(const std::variant<Materials...>& material, const BodyContext& deck) {
  std::vector<std::string_view> yielding;
  ((Materials::may_yield ? yielding.push_back(Materials::name) : void()), ...);
  const auto is_among_them = [](const auto& one) { return std::decay_t<decltype(one)>::may_yield; };
  if (std::visit(is_among_them, material)) return;
  const std::string_view model = std::visit([](const auto& one) { return std::decay_t<decltype(one)>::name; }, material);
  deck.refuse("plasticity", fmt::format("plasticity is for the models {}, but the model is {}; change the model, or remove plasticity.",
                                        fmt::join(yielding, " and "), model));
}

}  // namespace

void PlasticitySetup::check(const ElasticSetup& material, const BodyContext& deck) const {
  refuse_model(deck.body.material, deck);
  if (deck.body.is_plane())
    deck.refuse("plasticity", fmt::format("plasticity needs all three normal stresses, but the body is of plane {}; write plane: none, or remove plasticity.",
                                          deck.body.plane.word()));
  const auto yields_at = surface.as<YieldSurface>();
  if (yields_at == YieldSurface::von_mises && !compressive_strength)
    deck.refuse("plasticity.surface", "surface is von-mises, which has no strength of its own; give compressive_strength.");
  if (yields_at != YieldSurface::von_mises && yields_at != YieldSurface::riska_frederking && compressive_strength)
    deck.refuse("plasticity.compressive_strength",
                fmt::format("compressive_strength is given beside surface: {}, which has its own strength; remove one of the two (without surface, the one of "
                            "Riska and Frederking is scaled).",
                            surface.word()));
  const double strength = compressive_strength.value_or(YieldEllipse::published(yields_at).compressive_strength());
  if (material.flexural_strength && *material.flexural_strength >= strength)
    deck.refuse("plasticity", fmt::format("the compressive strength of {:.4g} Pa is not above the flexural_strength of {:.4g} Pa, so the body would yield "
                                          "before it breaks in bending; give a larger compressive_strength, or a smaller flexural_strength.",
                                          strength, *material.flexural_strength));
  if (deck.is_quasi_static)
    deck.refuse("plasticity", "plasticity depends on the path, but relax computes equilibrium states without a path; remove one of the two.");
  if (friction_angle && !material.critical_stretch && !material.fracture_energy && !material.flexural_strength)
    deck.refuse("plasticity.friction_angle",
                "friction_angle is for ice that has failed, but bonds of this material never break; give critical_stretch, fracture_energy or "
                "flexural_strength, or remove friction_angle.");
  const std::optional<FailureSetup>& failure = deck.body.failure;
  if (!failure) return;
  if (failure->compression.as<CompressionFailure>() != CompressionFailure::none)
    deck.refuse_body("failure.compression",
                     fmt::format("compression is {}, but a material with plasticity yields under pressure in place of breaking; remove one of the two.",
                                 failure->compression.word()));
  if (failure->compression_hardening > 0)
    deck.refuse_body("failure.compression_hardening",
                     "compression_hardening is given beside plasticity, which has its own limit of bonds under pressure; remove one of the two.");
}

}  // namespace perimpact
