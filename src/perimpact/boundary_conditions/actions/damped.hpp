/// Implicit velocity damping, and the work of resisting forces, for the boundary conditions `absorbing` and `floating`.
///
///   v_{n+1/2} (1 + α dt/2) = v_{n-1/2} (1 - α dt/2) + F dt/(ρ V)
///
/// For any α the remaining velocity lies between plus and minus the previous one, so that damping does not limit the time step.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/pack_functions.hpp"
#include "base/vec3.hpp"
#include "perimpact/boundary_conditions/actions/listed_eights.hpp"
#include "perimpact/particles/shared_numbers.hpp"

namespace perimpact {

/// The force density [N/m³] that leads to v_{n+1/2}, from that of all other forces, F/V, and v_{n-1/2} [m/s]; `damping`: α [1/s].
template <class Pack>
FCCDA_HD Pack damped(Pack force_density, Pack velocity, double density, Pack damping, double dt) {
  return (force_density - Pack(density) * damping * velocity) / (Pack(1.0) + Pack(0.5) * damping * Pack(dt));
}

/// Resultant of forces on particles at an instant, and their work.
struct Resistance {
  fccda::Vec3d force{};  ///< [N] their sum
  double work = 0;       ///< [J] since the previous instant
};

/// The same of each particle of a pack.
template <class Pack>
struct ResistanceOfPack {
  fccda::Vec3<Pack> force{Pack(0.0), Pack(0.0), Pack(0.0)};
  Pack work = Pack(0.0);
};

/// Trapezoidal work of forces on particles: the mean of the forces at two instants times the displacement in between, including that by
/// contact (reaction_ledger.hpp). Initially the forces are 0.
class ForcesOnTheWay {
 public:
  /// What kernels read and write: the latest forces [N] by place, those of an eight one component after the other.
  class View {
   public:
    explicit View(double* latest) : latest_(latest) {}
    template <class Visit>
    void visit_pointers(const Visit& visit) {
      visit(latest_);
    }
    /// Records the forces [N] on the particles of the bits at an instant, reached by the displacement `way` [m].
    template <class Pack>
    FCCDA_HD ResistanceOfPack<Pack> record_force(std::size_t place, unsigned bits, const fccda::Vec3<Pack>& force, const fccda::Vec3<Pack>& way) const {
      ResistanceOfPack<Pack> noted;
      fccda::Vec3<Pack> sum;
      for (std::size_t c = 0; c < 3; ++c) {
        double* const latest = latest_ + index(place, c);
        const Pack before = fccda::load<Pack>(latest);
        sum[c] = before + force[c];
        fccda::store(latest, fccda::choose(bits, force[c], before));
        noted.force[c] = fccda::select(bits, force[c]);
      }
      noted.work = fccda::select(bits, Pack(0.5) * dot(sum, way));
      return noted;
    }

   private:
    double* latest_;
  };

  explicit ForcesOnTheWay(std::size_t places) : latest_(3 * places, 0.0) {}
  View view() { return View(latest_.data()); }
  std::span<double> latest() { return latest_; }

  /// `slots`: of the particles, whose places those are.
  template <class Visitor>
  void visit_record(const std::string& name, std::span<const std::uint32_t> slots, const ListedEights& eights, Visitor&& visit) {
    if (latest_.empty()) return visit(name + ".latest_forces", ListNumbers(std::span<double>(), slots));
    visit_by_slot(
        eights.place_of(), 3, [&](std::size_t place, std::size_t c) -> double& { return latest_[index(place, c)]; },
        [&](std::span<double> numbers) { visit(name + ".latest_forces", ListNumbers(numbers, slots)); });
  }

 private:
  FCCDA_HD static std::size_t index(std::size_t place, std::size_t component) {
    return place / fccda::byte_lanes * 3 * fccda::byte_lanes + component * fccda::byte_lanes + place % fccda::byte_lanes;
  }

  std::vector<double> latest_;
};

/// The plain sum over an eight of what resist(place) returns for each pack of it.
template <class Pack, class Resist>
Resistance resistance_of_eight(std::size_t eight, const Resist& resist) {
  double force[3][fccda::byte_lanes], work[fccda::byte_lanes];
  for (std::size_t lane = 0; lane < fccda::byte_lanes; lane += fccda::lanes<Pack>) {
    const ResistanceOfPack<Pack> of = resist(eight * fccda::byte_lanes + lane);
    for (std::size_t c = 0; c < 3; ++c) fccda::store(force[c] + lane, of.force[c]);
    fccda::store(work + lane, of.work);
  }
  return {{sum_of_lanes(force[0]), sum_of_lanes(force[1]), sum_of_lanes(force[2])}, sum_of_lanes(work)};
}

}  // namespace perimpact
