/// Memory estimate of a set-up before allocation, because the operating system overcommits memory and ends the program without a message.
#pragma once

#include <span>
#include <vector>

#include "mesh/surface.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/discretisation/discretise.hpp"
#include "perimpact/particles/partition.hpp"
#include "perimpact/ranks/ranks.hpp"
#include "perimpact/simulation/available_memory.hpp"

namespace perimpact {

/// [bytes] Peak memory of a run, summed over arrays, without the report, which is written after the rest is released.
struct Memory {
  double at_rest = 0;     ///< during steps
  double setting_up = 0;  ///< largest addition during the set-up
  double pictures = 0;    ///< largest addition while an output frame is written
  double moves = 0;       ///< largest addition while a moving window moves
  double rubble = 0;      ///< addition with `contact.fragments` if all bonds have broken, in rubble as dense as the solid
  double decks = 0;       ///< of at_rest: points of clouds in the deck, which every rank has

  std::vector<double> particles;  ///< of each body, their number
  std::vector<double> of_bodies;  ///< of each body, for its own arrays

  /// Surface of an impactor with its search trees and the loads of its panels.
  struct OfSurface {
    double bytes;
    std::size_t panels;
  };
  std::vector<OfSurface> of_surfaces;  ///< in the order of the impactors, of those that have been added

  /// Adds the surface of the next impactor.
  void add(const fccda::Surface& surface);

  double peak() const;  ///< without rubble

  /// Reduces what the particles of the bodies need to this share; surfaces are on every rank. Frames are gathered by one rank.
  void reduce_to(double share);
};

/// `bodies`: discretisation of each. The bonds of a point cloud are estimated from a sample of its particles. Surfaces are to be added when they are known.
Memory memory_of(const Setup& setup, std::span<const Discretisation> bodies);

/// Slots of a lattice of these cells over those of the whole.
double share_of_slots(const Lattice& whole, const CellBox& cells);

/// Share of the memory of the bodies that this rank needs: of the largest share of slots in any of them, with ghosts. `loads`: of each, or none.
double share_of_memory(const Setup& setup, std::span<const Discretisation> bodies, const Ranks& ranks, std::span<const MeasuredLoad> loads = {});

/// Throws SetupError, with the key of the largest body or surface, if the peak exceeds what is available. `memory`: memory_of these bodies.
void expect_to_fit(const Setup& setup, std::span<const Discretisation> bodies, const Memory& memory, const AvailableMemory& available);

}  // namespace perimpact
