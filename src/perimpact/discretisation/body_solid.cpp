#include "perimpact/discretisation/body_solid.hpp"

#include <algorithm>

#include "base/contract.hpp"
#include "base/error.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

namespace {

Solid solid_at(const SolidShape& shape, const Frame& frame, const std::string& key) {
  try {
    return Solid(shape, frame);
  } catch (const fccda::InputError& error) {
    throw SetupError(key + ".shape", error.what());
  }
}

/// The shape of a body if it is a solid, else empty.
std::optional<SolidShape> solid_shape(const BodyShape& shape) {
  return std::visit(
      []<class Shape>(const Shape& given) -> std::optional<SolidShape> {
        if constexpr (std::is_constructible_v<SolidShape, Shape>) return given;
        return std::nullopt;
      },
      shape);
}

}  // namespace

Frame frame_of(const BodySetup& body) { return frame_of(body.position, body.rotate); }

Solid solid_of(const SolidSetup& solid, const BodySetup& body, const std::string& key) {
  return solid_at(solid.shape, frame_of(body) * frame_of(solid.position, solid.rotate), key);
}

BodySolid::BodySolid(const BodySetup& body) {
  const std::string key = "bodies." + body.name;
  const std::optional<SolidShape> shape = solid_shape(body.shape);
  EXPECTS(shape.has_value());
  united_.push_back(solid_at(*shape, frame_of(body), key));
  for (const SolidSetup& part : body.add) united_.push_back(solid_of(part, body, key + ".add." + part.name));
  for (const SolidSetup& hole : body.holes) holes_.push_back(solid_of(hole, body, key + ".holes." + hole.name));
}

bool BodySolid::contains(const Vec3d& point, double margin) const {
  std::uint8_t inside = 0;
  mark({.first = point}, margin, {&inside, 1});
  return inside != 0;
}

void BodySolid::mark(const Row& row, double margin, std::span<std::uint8_t> inside) const {
  std::fill(inside.begin(), inside.end(), std::uint8_t{0});
  for (const Solid& solid : united_) solid.mark(row, margin, inside, 1);
  for (const Solid& hole : holes_) hole.mark(row, margin, inside, 0);
}

fccda::Box BodySolid::bounds() const {
  fccda::Box bounds;
  for (const Solid& solid : united_) bounds.include(solid.bounds().low), bounds.include(solid.bounds().high);
  return bounds;
}

std::optional<double> BodySolid::volume() const {
  if (united_.size() > 1 || !holes_.empty()) return std::nullopt;
  return united_.front().volume();
}

}  // namespace perimpact
