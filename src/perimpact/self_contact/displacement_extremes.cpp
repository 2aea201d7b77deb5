#include "perimpact/self_contact/displacement_extremes.hpp"

#include <array>
#include <vector>

#include "base/pack.hpp"
#include "base/parallel.hpp"

namespace perimpact {

namespace {

/// Includes the displacements of the particles first to last - 1 of a run, whose number is a multiple of the lanes. `position`, `reference`: of the run.
template <class P>
void include_displacements(std::size_t first, std::size_t last, const std::array<const double*, 3>& position, const std::array<const double*, 3>& reference,
                           const Vec3d& drift, DisplacementExtremes& found) {
  const P least(-DisplacementExtremes::infinity);
  std::array<P, 7> most = {least, least, least, least, least, least, P(0.0)};  // of -u, u and the squared distance from the drift
  for (std::size_t n = first; n < last; n += fccda::lanes<P>) {
    P squared(0.0);
    for (std::size_t c = 0; c < 3; ++c) {
      const P by = fccda::load<P>(position[c] + n) - fccda::load<P>(reference[c] + n), apart = by - P(drift[c]);
      most[c] = fccda::larger(most[c], P(0.0) - by), most[3 + c] = fccda::larger(most[3 + c], by);
      squared += apart * apart;
    }
    most[6] = fccda::larger(most[6], squared);
  }
  std::array<std::array<double, fccda::lanes<P>>, 7> of_lanes;
  for (std::size_t k = 0; k < most.size(); ++k) fccda::store(of_lanes[k].data(), most[k]);
  for (std::size_t lane = 0; lane < fccda::lanes<P>; ++lane) {
    const auto at = [&](std::size_t k) { return of_lanes[k][lane]; };
    found.include({{-at(0), -at(1), -at(2)}, {at(3), at(4), at(5)}, at(6)});
  }
}

}  // namespace

DisplacementExtremes displacement_extremes(std::span<const ParticleRun> runs, std::span<const ContactingBody> bodies, const VectorArray& reference,
                                           const Vec3d& drift) {
  using Pack = fccda::NativePack;
  std::vector<DisplacementExtremes> of_runs(runs.size());
  fccda::parallel_for(static_cast<std::ptrdiff_t>(runs.size()), [&](std::ptrdiff_t number) {
    const ParticleRun& run = runs[static_cast<std::size_t>(number)];
    std::array<const double*, 3> now, before;
    for (std::size_t c = 0; c < 3; ++c) {
      now[c] = bodies[run.body].particles.position.component(c) + run.slot;
      before[c] = reference.component(c) + run.particle;
    }
    const std::size_t full = run.count / fccda::lanes<Pack> * fccda::lanes<Pack>;
    DisplacementExtremes& found = of_runs[static_cast<std::size_t>(number)];
    include_displacements<Pack>(0, full, now, before, drift, found);
    include_displacements<double>(full, run.count, now, before, drift, found);
  });
  DisplacementExtremes all;
  for (const DisplacementExtremes& of_run : of_runs) all.include(of_run);
  return all;
}

}  // namespace perimpact
