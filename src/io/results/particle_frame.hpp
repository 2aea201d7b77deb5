/// An output frame of a body: positions and fields of its particles.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/frames/series.hpp"
#include "io/results/frame_particles.hpp"
#include "perimpact/body/body.hpp"
#include "perimpact/fragments/fragments.hpp"

namespace perimpact {

class ParticleFrame {
 public:
  /// The current state of a body, which must outlive the frame, as its fragments; these are absent if its bonds cannot break. `fields`: of frame_field_words;
  /// those that the body has are written. `particles`: of this rank. `varies`: the numbers of the particles change from frame to frame.
  ParticleFrame(const Body& body, const Fragments* fragments, std::span<const std::string> fields, ParticleNumbers particles, bool varies);

  /// Passes the frame to the sink, on the root that of all ranks. A thinned one has the number of each particle in its body as the field `particle`.
  /// Collective.
  void write(const frames::Sink& sink) const;

 private:
  std::size_t size() const;  // of this rank
  std::size_t number(std::size_t index) const { return particles_ ? static_cast<std::size_t>((*particles_)[index]) : index; }
  template <class Value>
  output::MadeFloats floats(const Value& value) const;
  template <class Number>
  output::Numbers selected(std::span<const Number> all, std::vector<Number>& store) const;
  template <class Number, class Value>
  std::vector<Number> gathered(const Value& value) const;
  std::vector<std::uint32_t> slots() const;
  std::vector<std::int32_t> numbers_in_body() const;

  const Body& body_;
  const Fragments* fragments_;
  std::span<const std::string> fields_;
  ParticleNumbers particles_;
  bool varies_;
};

/// Writes all particles of a body with their fields but the fragments to a VTP file, for ParaView.
void write_particles(const std::filesystem::path& path, const Body& body);

}  // namespace perimpact
