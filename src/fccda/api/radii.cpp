#include "fccda/api/radii.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "fccda/api/array_points.hpp"

namespace fccda {

namespace {

bool is_radius(double radius) { return radius >= 0 && std::isfinite(radius); }

bool is_too_small(double radius, double offset) { return radius > 0 && offset > largest_offset * radius; }

[[noreturn]] void refuse_offset(double offset, const std::string& than) {
  throw InputError("contact: positions in single precision need an offset of " + in_words(offset) +
                   " m from the surface, which grows with its distance from the origin and must be at most a tenth of " + than +
                   "; pass positions in double precision, or place the origin nearer to the surface.");
}

}  // namespace

double checked_radius(double radius) {
  if (is_radius(radius)) return radius;
  throw InputError("contact: the contact radius is " + in_words(radius) + " m, but it must be a number of at least 0; 0 is for points without extent.");
}

void expect_small_offset(double offset, double radius, double size) {
  if (is_too_small(radius, offset)) refuse_offset(offset, "the contact radius, " + in_words(radius) + " m");
  if (offset > largest_offset * size) refuse_offset(offset, "the surface's size, " + in_words(size) + " m");
}

void expect_radii(const Numbers& radius, std::size_t points) {
  if (!radius.are_for(points))
    throw InputError("contact: the number of radii differs from the " + std::to_string(points) + " points; give one for each, or one number for all.");
}

void Radii::note_common(double radius, std::size_t points) {
  grown_.clear();
  for (std::size_t i = 0; i < std::min(points, radius_.size()); ++i)
    if (radius > radius_[i]) grown_.push_back(i);
  radius_.clear();
  common_ = radius, common_points_ = points;
}

void Radii::forget() {
  radius_.clear(), grown_.clear();
  common_points_ = 0;
}

double Radii::note(const Numbers& radius, std::size_t points, double offset) {
  expect_radii(radius, points);
  std::vector<double> largest(blocks_of(points));
  std::vector<std::uint8_t> differs(largest.size()), is_invalid(largest.size());
  const auto scan = [&](std::ptrdiff_t block) {
    const auto b = static_cast<std::size_t>(block);
    for (std::size_t i = b * block_size; i < std::min((b + 1) * block_size, points); ++i) {
      const double now = radius[i];
      if (!is_radius(now) || is_too_small(now, offset)) is_invalid[b] = 1;
      if (i >= radius_.size() || now != radius_[i]) differs[b] = 1;
      largest[b] = std::max(largest[b], now);
    }
  };
  for_blocks(largest.size(), scan);
  if (const auto invalid = std::ranges::find(is_invalid, 1); invalid != is_invalid.end())
    for (std::size_t i = static_cast<std::size_t>(invalid - is_invalid.begin()) * block_size;; ++i) {
      if (is_too_small(radius[i], offset)) refuse_offset(offset, "the radius of point " + std::to_string(i) + ", " + in_words(radius[i]) + " m");
      if (!is_radius(radius[i]))
        throw InputError("contact: the radius of point " + std::to_string(i) + " is " + in_words(radius[i]) + " m, but it must be a number of at least 0.");
    }
  const std::size_t known = radius_.size();
  radius_.resize(points);
  grown_.clear();
  const auto has_grown = [&](std::size_t i, double now) { return i < known ? now > radius_[i] : i < common_points_ && now > common_; };
  for (std::size_t b = 0; b < differs.size(); ++b) {
    if (differs[b] == 0) continue;
    for (std::size_t i = b * block_size; i < std::min((b + 1) * block_size, points); ++i) {
      const double now = radius[i];
      if (has_grown(i, now)) grown_.push_back(i);
      radius_[i] = now;
    }
  }
  common_points_ = 0;
  return points == 0 ? 0 : *std::ranges::max_element(largest);
}

}  // namespace fccda
