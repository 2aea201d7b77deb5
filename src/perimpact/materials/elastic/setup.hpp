/// The part of a material's setup that all materials have in common, and the table of its fields.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "base/parameter.hpp"
#include "perimpact/materials/elastic/influence.hpp"
#include "perimpact/materials/elastic/isotropic.hpp"
#include "perimpact/materials/ice/setup.hpp"
#include "perimpact/materials/plasticity/setup.hpp"

namespace perimpact {

using fccda::Choice;
using fccda::Field;

struct BodyContext;

inline constexpr std::string_view influence_words[] = {"constant", "inverse", "inverse-square", "parabolic", "gaussian"};
static_assert(fccda::are_enumerators<Influence>(influence_words));

/// Parameters common to all materials.
struct ElasticSetup {
  std::optional<double> youngs_modulus;  ///< [Pa] required
  double poissons_ratio = 0.25;
  double density{};  ///< [kg/m³]
  // failure criterion: at most one of these three; bonds never break where all are absent
  std::optional<double> critical_stretch;   ///< [-]
  std::optional<double> fracture_energy;    ///< [J/m²]
  std::optional<double> flexural_strength;  ///< [Pa]
  std::optional<int> layers;                ///< of particles through the thickness in bending
  std::optional<IceSetup> ice;              ///< source of the values that the deck does not give
  std::optional<PlasticitySetup> plasticity;

  /// The fields that every material has.
  static std::span<const Field<ElasticSetup>> fields();
  template <class Walker, class Material>
  static void sections(Walker& walk, Material& material) {
    walk.section("ice", material.ice, fccda::Presence::optional,
                 "Ice given by temperature and salinity: sets youngs_modulus, flexural_strength where no other criterion is given, and with a strain rate the "
                 "compressive strength of plasticity.");
    walk.section("plasticity", material.plasticity, fccda::Presence::optional,
                 "Yields under pressure: a pressure-dependent yield surface with associated flow, for bond-based and ordinary state-based materials. {} takes "
                 "every default.");
  }

  // A material that differs hides these.
  static constexpr bool may_yield = false;                          ///< supports plasticity
  double poissons_ratio_in(Plane) const { return poissons_ratio; }  ///< of a 3-D or 2-D body
  void check(BodyContext& deck);                                    ///< sets what follows from ice; throws SetupError for values that exclude each other

  bool may_fail() const { return critical_stretch || fracture_energy || flexural_strength; }
};

inline constexpr std::string_view poissons_ratio_sentence =
    "Poisson's ratio ν: an isotropic solid needs -1 < ν < 0.5. Ice is usually 0.25 to 0.35. 0.25 is the fastest.";

/// Poisson's ratio of a material that has one.
template <class S>
Field<S> poissons_ratio_field(std::string_view sentence = poissons_ratio_sentence) {
  return {"poissons_ratio", &S::poissons_ratio, "1", fccda::strictly_between(-1, 0.5), fccda::Presence::optional, sentence};
}

template <class S>
Field<S> influence_field() {
  return {"influence",
          &S::influence,
          "",
          {},
          fccda::Presence::optional,
          "Influence function of the bond length r = |ξ|/δ: constant, inverse (1/r), inverse-square, parabolic (1 up to 1/2, then 4 r (1 - r)) or gaussian "
          "(exp(-(r/0.4)²))."};
}

/// The table of a material: the fields that every material has, then its own.
template <class S>
std::vector<Field<S>> with_elastic_fields(const std::vector<Field<S>>& own = {}) {
  std::vector<Field<S>> all;
  for (const Field<ElasticSetup>& field : ElasticSetup::fields())
    std::visit([&](auto member) { all.push_back({field.name, member, field.unit, field.range, field.presence, field.sentence}); }, field.member);
  for (const Field<S>& field : own) all.insert(field.name == "poissons_ratio" ? all.begin() + 1 : all.end(), field);  // beside Young's modulus
  return all;
}

}  // namespace perimpact
