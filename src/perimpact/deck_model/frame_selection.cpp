#include "perimpact/deck_model/frame_selection.hpp"

namespace perimpact {

using fccda::any_number;
using fccda::between;
using fccda::Presence;

std::span<const Field<FrameBoxSetup>> FrameBoxSetup::fields() {
  using S = FrameBoxSetup;
  static const Field<S> all[] = {{"lower", &S::lower, "m", any_number(), Presence::required, "Corner with the smallest coordinates."},
                                 {"upper", &S::upper, "m", any_number(), Presence::required, "Corner with the largest coordinates."}};
  return all;
}

bool FrameBoxSetup::contains(const Vec3d& reference) const {
  bool is_inside = true;
  for (std::size_t axis = 0; axis < 3; ++axis) is_inside = is_inside && reference[axis] >= lower[axis] && reference[axis] <= upper[axis];
  return is_inside;
}

std::span<const Field<FrameParticlesSetup>> FrameParticlesSetup::fields() {
  using S = FrameParticlesSetup;
  static const Field<S> all[] = {
      {"surface",
       &S::surface,
       "",
       {},
       Presence::optional,
       "Particles at the surface in the reference configuration: those without a neighbour in one of the lattice directions. In a point cloud every particle "
       "counts."},
      {"stride", &S::stride, "1", between(2, 1000), Presence::optional,
       "Every n-th particle in each direction of the lattice. Of a point cloud as large a share, in the order of its storage."},
      {"damage_above",
       &S::damage_above,
       "1",
       {.low = 0, .high = 1, .high_included = false},
       Presence::optional,
       "Particles whose damage, the share of broken bonds, exceeds this."},
      {"detached", &S::detached, "", {}, Presence::optional, "Particles outside the largest fragment of their body."}};
  return all;
}

}  // namespace perimpact
