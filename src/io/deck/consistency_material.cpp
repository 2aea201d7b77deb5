#include "io/deck/consistency_material.hpp"

#include <fmt/format.h>

#include <string>

#include "io/deck/yaml_node.hpp"
#include "perimpact/deck_model/deck_context.hpp"
#include "perimpact/deck_model/distinct_words.hpp"

namespace perimpact::deck {

namespace {

void check_bending(const BodySetup& body, const std::string& path, const Places& places) {
  const ThinAxis axis = body.bending_calibration.as<ThinAxis>();
  if (axis == ThinAxis::none) return;
  const auto at = places.of(path + ".bending_calibration");
  if (!body.spacing) refuse(at, "bending_calibration needs layers of a lattice, but a body from a file has none; remove it.");
  if (body.is_plane() && axis == ThinAxis::z)
    refuse(at, "bending_calibration is z, but a plane body bends in x and y only; use x or y, the axis across the thin direction.");
}

void check_failure(const BodySetup& body, const std::string& path, const Places& places) {
  if (!body.failure) return;
  if (!body.elastic().may_fail())
    refuse(places.of(path + ".failure"),
           "failure is given, but the material never fails; give it a critical_stretch, fracture_energy or flexural_strength, or remove failure.");
  const auto exists_or_not = [](const std::string&) {};  // known once the body is made
  check_distinct("no_fail", body.failure->no_fail, exists_or_not, [&](const std::string& sentence) { refuse(places.of(path + ".failure.no_fail"), sentence); });
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

}  // namespace

void make_material_consistent(BodySetup& body, bool is_quasi_static, const Places& places) {
  const std::string path = "bodies." + body.name;
  BodyContext deck{{path + ".material", places}, body, path, is_quasi_static, {}};
  std::visit([&](auto& material) { material.check(deck); }, body.material);
  check_bending(body, path, places);
  check_failure(body, path, places);
}

}  // namespace perimpact::deck
