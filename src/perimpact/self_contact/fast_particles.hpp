/// The fastest particles of a neighbour list. They may move farther than others while the list is valid, since otherwise a few fragments that fly, mostly far
/// from others, would determine how often it is rebuilt.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

class FastParticles {
 public:
  struct Particle {
    std::uint32_t particle;
    double margin;  ///< [m] how far it may move
  };

  FastParticles() = default;
  /// `margin`, `most` [m]: how far all other particles may move, and fast ones at most.
  FastParticles(double margin, double most) : margin_(margin), most_(most) {}

  /// Chooses among `count` particles the hundredth that is fastest relative to the mean velocity, with margins in the ratio of their speeds to that of the
  /// others; none if the list would not remain valid for twice as long. `velocity_of(particle)` [m/s].
  template <class VelocityOf>
  void choose(std::size_t count, const VelocityOf& velocity_of);
  void clear() { all_.clear(); }

  std::span<const Particle> all() const { return all_; }  ///< ascending
  double margin_of(std::uint32_t particle) const;         ///< [m] of any particle
  double most() const { return most_; }                   ///< [m] bound of the margins
  bool contains(std::uint32_t particle) const { return margin_of(particle) > margin_; }

 private:
  void choose_among(std::span<const double> squared_speeds);

  double margin_ = 0, most_ = 0;
  std::vector<Particle> all_;
};

template <class VelocityOf>
void FastParticles::choose(std::size_t count, const VelocityOf& velocity_of) {
  Vec3d sum{};
  for (std::size_t p = 0; p < count; ++p) sum += velocity_of(p);
  const Vec3d mean = sum / static_cast<double>(count);
  std::vector<double> squared_speeds(count);
  fccda::parallel_for(static_cast<std::ptrdiff_t>(count), [&](std::ptrdiff_t particle) {
    const auto p = static_cast<std::size_t>(particle);
    squared_speeds[p] = squared_norm(velocity_of(p) - mean);
  });
  choose_among(squared_speeds);
}

}  // namespace perimpact
