/// The fragments that a body has fallen into: particles that hang together by intact bonds, directly or through others (the connected components
/// of the graph of bonds). A particle that has lost all bonds is a fragment of its own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "perimpact/family/family.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

struct Fragment {
  std::size_t particles;
  double mass;               ///< [kg]
  std::uint32_t first_slot;  ///< the smallest of its particles
};

/// What one row of a table says of them. A fragment here has two particles or more, but where masses are compared, single particles take part.
struct FragmentCount {
  std::size_t fragments = 0;          ///< of two and more particles
  std::size_t single_particles = 0;   ///< that have no bond
  double largest = 0;                 ///< [kg]
  double second_largest = 0;          ///< [kg] 0 where there is one
  std::size_t above_one_percent = 0;  ///< fragments heavier than 1 % of the body
  double outside_largest = 0;         ///< [kg] of all but the largest
};

class Fragments {
 public:
  /// Union of the ends of all intact bonds (Tarjan, J. ACM 22 (1975) 215), on one thread. Measured with 300 000 particles and 25 million bonds: 0.16 s
  /// where all are intact, 0.04 to 0.09 s where more than nine of ten are broken.
  Fragments(const Particles& particles, const Family& family);

  /// The heaviest first; of equally heavy ones that with the smallest slot.
  std::span<const Fragment> all() const { return fragments_; }
  /// Number in all() of the fragment of each particle, in the order of Particles::slot_of().
  std::span<const std::int32_t> of_particles() const { return of_particles_; }

  FragmentCount count() const;

 private:
  std::vector<Fragment> fragments_;
  std::vector<std::int32_t> of_particles_;
};

/// Where a fragment is, how large and how fast.
struct FragmentState {
  Vec3d centre{};    ///< [m] of mass
  Vec3d extent{};    ///< [m] edges of the box around its particles, each with its own size (in a plane body, in z, with the thickness)
  Vec3d velocity{};  ///< [m/s] of the centre of mass
};

/// Of the first `count` fragments.
std::vector<FragmentState> states_of(const Fragments& fragments, const Particles& particles, std::size_t count);

}  // namespace perimpact
