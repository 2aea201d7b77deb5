/// Options of a pass over the bonds of a body, and its sums by eight.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <type_traits>
#include <vector>

#include "base/host_device.hpp"
#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "perimpact/particles/particles.hpp"

namespace perimpact {

/// Sums over the particles of each eight, the slots 8 n … 8 n + 7: their totals do not depend on how eights are distributed
/// (particles/sum_over_eights.hpp).
struct SumsOfEights {
  static constexpr std::size_t bytes_of_eight = 2 * sizeof(double) + sizeof(std::uint32_t);

  std::vector<double> energy;              ///< [J] elastic energy, of the last pass with_energy
  std::vector<std::uint32_t> broken_ends;  ///< since construction
  std::vector<double> fracture_energy;     ///< [J] since construction: elastic energy released by bond failure (docs/theory/energy.md)
};

/// Options of a pass.
struct PassOptions {
  bool with_energy = false;
  bool may_break = true;  ///< false: bonds beyond their limit stay intact
  double dt = 0;          ///< [s] last step, which led to these positions at the current velocities; 0: state of equilibrium
};

/// Distributes rows of equal cost among threads.
struct EvenRows {
  template <class Body>
  void operator()(std::ptrdiff_t count, const Body& body) const {
    fccda::parallel_for(count, body);
  }
};

/// Calls f(row, slot) for all packs of owned slots, rows in parallel, by rows(count, body). While ghosts are refreshed packs that read none come first, and the
/// refresh is completed before the others: so messages travel during the computation.
template <class Pack, class F, class Rows = EvenRows>
void for_each_pack_in_rows(const Particles& particles, const F& f, const Rows& rows = {}) {
  using Ranges = std::array<Particles::Range, 2>;
  // f is called in one place: with several the compiler does not inline it, and the force pass takes a quarter longer
  const auto in_rows = [&](const std::function<Ranges(std::size_t row)>& ranges_of) {
    rows(static_cast<std::ptrdiff_t>(particles.rows()), [&](std::ptrdiff_t number) {
      const auto row = static_cast<std::size_t>(number);
      for (const auto& [begin, end] : ranges_of(row))
        for (std::size_t slot = begin; slot < end; slot += fccda::lanes<Pack>) f(row, slot);
    });
  };
  const Share& share = particles.share();
  if (!share.is_refreshing()) return in_rows([&](std::size_t row) { return Ranges{particles.owned_slots(row)}; });
  in_rows([&](std::size_t row) { return Ranges{particles.interior_slots(row)}; });
  share.complete_refresh();
  in_rows([&](std::size_t row) {
    const Particles::Range owned = particles.owned_slots(row), interior = particles.interior_slots(row);
    if (interior.begin == interior.end) return Ranges{owned};
    return Ranges{{{owned.begin, interior.begin}, {interior.end, owned.end}}};
  });
}

/// Calls f(eight, slot) for all packs of a body, rows in parallel.
template <class Pack, class F, class Rows = EvenRows>
void for_each_pack(const Particles& particles, const F& f, const Rows& rows = {}) {
  for_each_pack_in_rows<Pack>(
      particles, [&](std::size_t, std::size_t slot) { f(slot / fccda::byte_lanes, slot); }, rows);
}

/// Energy of a pack [J]: Σ of energy density times volume over its particles. `particles`: Particles or a ParticlesView.
template <class Pack, class ParticlesOrView>
FCCDA_HD double energy_of_pack(Pack density, const ParticlesOrView& particles, std::size_t slot) {
  double values[fccda::lanes<Pack>];
  fccda::store(values, density);
  double sum = 0;
  for (std::size_t lane = 0; lane < fccda::lanes<Pack>; ++lane)
    if (particles.is_occupied(slot + lane)) sum += values[lane] * particles.volume(slot + lane);
  return sum;
}

/// Calls f with std::true_type or std::false_type.
template <class F>
void with_constant(bool value, const F& f) {
  if (value)
    f(std::true_type{});
  else
    f(std::false_type{});
}

}  // namespace perimpact
