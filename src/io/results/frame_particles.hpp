/// The particles of a body in output frames (output.frame_particles).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "perimpact/fragments/fragments.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace perimpact {

/// Numbers of particles of this rank in the order of Particles::slot_of(), ascending; all where absent.
using ParticleNumbers = std::optional<std::vector<std::int32_t>>;

class FrameParticles {
 public:
  /// All particles without a setup.
  FrameParticles(const std::optional<FrameParticlesSetup>& setup, const Body& body);

  bool is_thinned() const { return is_thinned_; }
  bool varies() const { return varies_; }                        ///< from frame to frame
  std::size_t in_every_frame() const { return always_.size(); }  ///< number of the particles of this rank that are in every thinned frame

  /// The particles of this rank in a frame of the current state. `fragments`: of the body; absent if its bonds cannot break.
  ParticleNumbers now(const Body& body, const Fragments* fragments) const;

 private:
  bool is_thinned_, varies_;
  std::optional<double> damage_above_;
  bool detached_;
  std::vector<std::int32_t> always_;      // in every frame
  std::vector<std::int32_t> candidates_;  // the others that may come to be written; none unless varies_
};

/// Of each body. Throws SetupError with the key of a box in which there is no particle of any body. Collective.
std::vector<FrameParticles> frame_particles_of(const Simulation& simulation);

}  // namespace perimpact
