#include "io/deck/consistency_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "io/deck/yaml_node.hpp"
#include "perimpact/materials/ice/ice.hpp"
#include "perimpact/materials/plasticity/plasticity.hpp"

namespace perimpact::deck {

namespace {

/// Sets modulus and strength from the ice properties where the deck gives none.
void apply_ice(BodySetup& body, const std::string& path, const Places& places) {
  ElasticSetup& material = std::visit([](auto& one) -> ElasticSetup& { return one; }, body.material);
  const std::string its = path + ".material";
  if (!material.ice) {
    if (!material.youngs_modulus) refuse(places.of(its), "youngs_modulus is missing; give it, or ice with temperature and salinity or with brine_volume.");
    return;
  }
  const IceSetup& ice = *material.ice;
  const bool is_whole = ice.temperature && ice.salinity, is_half = ice.temperature.has_value() != ice.salinity.has_value();
  if (is_half || (ice.brine_volume && is_whole) || (!ice.brine_volume && !is_whole))
    refuse(places.of(its + ".ice"), "ice needs either brine_volume or both temperature and salinity; give one or the other.");
  const double brine = ice.brine_volume ? *ice.brine_volume : brine_volume(*ice.salinity, *ice.temperature);
  constexpr double most_brine = 0.25;  // the modulus formula vanishes at 0.256
  if (brine > most_brine)
    refuse(
        places.of(its + ".ice"),
        fmt::format("ice of salinity {} g/kg at {} degC has a brine volume of {:.3g}, and its strength is negligible above {}; use colder or less saline ice.",
                    *ice.salinity, *ice.temperature, brine, most_brine));
  if (!material.youngs_modulus) material.youngs_modulus = ice_youngs_modulus(brine);
  if (!material.critical_stretch && !material.fracture_energy && !material.flexural_strength) material.flexural_strength = ice_flexural_strength(brine);
  if (!ice.thickness) return;
  if (!body.spacing)
    refuse(places.of(its + ".ice.thickness"), "thickness is given, but a body from a file has no spacing from which layers follow; give layers.");
  if (!material.flexural_strength) refuse(places.of(its + ".ice.thickness"), "thickness applies to flexural_strength only, which is not given; remove it.");
  const int layers = std::max(2, static_cast<int>(std::lround(*ice.thickness / *body.spacing)));
  if (material.layers.value_or(layers) != layers)
    refuse(places.of(its + ".layers"), fmt::format("layers is {}, but ice {} m thick has {} layers of {} m; remove one of the two.", *material.layers,
                                                   *ice.thickness, layers, *body.spacing));
  material.layers = layers;
}

void check_bending(const BodySetup& body, const std::string& path, const Places& places) {
  const ThinAxis axis = body.bending_calibration.as<ThinAxis>();
  if (axis == ThinAxis::none) return;
  const auto at = places.of(path + ".bending_calibration");
  if (!body.spacing) refuse(at, "bending_calibration needs layers of a lattice, but a body from a file has none; remove it.");
  if (std::holds_alternative<CorrespondenceSetup>(body.material))
    refuse(at, "bending_calibration scales the stiffness of bonds, but the model correspondence has none; remove it, or use more layers.");
  if (body.is_plane() && axis == ThinAxis::z)
    refuse(at, "bending_calibration is z, but a plane body bends in x and y only; use x or y, the axis across the thin direction.");
}

void check_failure(const BodySetup& body, const std::string& path, const Places& places) {
  const ElasticSetup& material = body.elastic();
  const std::pair<const char*, bool> criteria[] = {{"critical_stretch", material.critical_stretch.has_value()},
                                                   {"fracture_energy", material.fracture_energy.has_value()},
                                                   {"flexural_strength", material.flexural_strength.has_value()}};
  const char* first = nullptr;
  for (const auto& [key, is_given] : criteria) {
    if (is_given && first)
      refuse(places.of(fmt::format("{}.material.{}", path, key)),
             fmt::format(
                 "{} is given together with {}, but each alone determines when bonds fail; remove one of the two (perimpact check reports what each implies).",
                 key, first));
    if (is_given) first = key;
  }
  if (material.layers && !material.flexural_strength)
    refuse(places.of(path + ".material.layers"), "layers applies to flexural_strength only, which is not given; remove it, or give flexural_strength.");
  if (!body.failure) return;
  if (!first)
    refuse(places.of(path + ".failure"),
           "failure is given, but the material never fails; give it a critical_stretch, fracture_energy or flexural_strength, or remove failure.");
  const bool is_limit = body.failure->compression.as<CompressionFailure>() == CompressionFailure::limit;
  if (is_limit && !body.failure->critical_compression)
    refuse(places.of(path + ".failure.compression"), "compression is limit, but critical_compression is missing; give it, such as 0.01.");
  if (!is_limit && body.failure->critical_compression)
    refuse(places.of(path + ".failure.critical_compression"),
           fmt::format("critical_compression is given, but compression is {}; set compression: limit, or remove it.", body.failure->compression.word()));
  if (body.failure->compression_hardening > 0 && body.failure->compression.as<CompressionFailure>() != CompressionFailure::none)
    refuse(places.of(path + ".failure.compression_hardening"),
           fmt::format("compression_hardening strengthens bonds in compression, but compression is {}, which breaks them; keep one of the two.",
                       body.failure->compression.word()));
  if (body.failure->seed && !body.failure->weibull_modulus)
    refuse(places.of(path + ".failure.seed"), "seed is given without weibull_modulus, so there is no scatter; give both or none.");
}

void check_plasticity(const BodySetup& body, const std::string& path, const Places& places) {
  const ElasticSetup& material = body.elastic();
  if (!material.plasticity) return;
  const PlasticitySetup& plasticity = *material.plasticity;
  const std::string its = path + ".material.plasticity";
  const std::string_view model = std::visit([](const auto& one) { return std::decay_t<decltype(one)>::name; }, body.material);
  if (!std::holds_alternative<BondBasedSetup>(body.material) && !std::holds_alternative<OrdinaryStateSetup>(body.material))
    refuse(places.of(its),
           fmt::format("plasticity is for the models bond-based and ordinary-state, but the model is {}; change the model, or remove plasticity.", model));
  if (body.is_plane())
    refuse(places.of(its),
           fmt::format("plasticity needs all three normal stresses, but the body is of plane {}; write plane: none, or remove plasticity.", body.plane.word()));
  const auto surface = plasticity.surface.as<YieldSurface>();
  if (surface == YieldSurface::von_mises && !plasticity.compressive_strength)
    refuse(places.of(its + ".surface"), "surface is von-mises, which has no strength of its own; give compressive_strength.");
  if (surface != YieldSurface::von_mises && places.has(its + ".surface") && plasticity.compressive_strength)
    refuse(places.of(its + ".compressive_strength"),
           fmt::format("compressive_strength is given beside surface: {}, which has its own strength; remove one of the two (without surface, the one of Riska "
                       "and Frederking is scaled).",
                       plasticity.surface.word()));
  const double strength = plasticity.compressive_strength.value_or(YieldEllipse::published(surface).compressive_strength());
  if (material.flexural_strength && *material.flexural_strength >= strength)
    refuse(places.of(its),
           fmt::format("the compressive strength of {:.4g} Pa is not above the flexural_strength of {:.4g} Pa, so the body would yield before it "
                       "breaks in bending; give a larger compressive_strength, or a smaller flexural_strength.",
                       strength, *material.flexural_strength));
  if (!body.failure) return;
  if (body.failure->compression.as<CompressionFailure>() != CompressionFailure::none)
    refuse(places.of(path + ".failure.compression"),
           fmt::format("compression is {}, but a material with plasticity yields under pressure in place of breaking; remove one of the two.",
                       body.failure->compression.word()));
  if (body.failure->compression_hardening > 0)
    refuse(places.of(path + ".failure.compression_hardening"),
           "compression_hardening is given beside plasticity, which has its own limit of bonds under pressure; remove one of the two.");
}

}  // namespace

void make_material_consistent(BodySetup& body, const Places& places) {
  const std::string path = "bodies." + body.name;
  apply_ice(body, path, places);
  check_bending(body, path, places);
  check_failure(body, path, places);
  check_plasticity(body, path, places);
}

}  // namespace perimpact::deck
