/// The frames of a results folder in a report.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/vec3.hpp"
#include "io/frames/frame.hpp"
#include "io/output/json.hpp"
#include "io/output/pvd.hpp"
#include "io/report/packing.hpp"
#include "io/report/rigid_motion.hpp"

namespace perimpact::report {

/// Minimum and maximum of a set of numbers.
struct Range {
  double low = 0, high = 0;
  bool is_empty = true;

  void include(double value);
};

/// The particles of a body over the run.
struct BodyFrames {
  std::string name;
  double spacing = 0;                      ///< [m]
  std::vector<output::FrameFile> frames;   ///< readable frames
  std::set<std::string> fields;            ///< of the frames, by their names there
  std::vector<fccda::Vec3d> undeformed;    ///< reference positions of all particles that are in a frame [m]
  std::vector<fccda::Vec3d> offsets;       ///< [m] per frame, of its reference positions from `undeformed`; zero without a moving window
  Range place[3], displacement[3], speed;  ///< over all frames [m] [m] [m/s]
  std::uint32_t highest_fragment = 0;
  Range plastic_strain;                                     ///< [-] over all frames
  std::vector<bool> is_damaged;                             ///< in any frame
  std::unordered_map<std::int32_t, std::uint32_t> indices;  ///< of thinned frames: the index in `undeformed` by the number of the particle in its body
  bool varies = false;                                      ///< not all particles are in all frames

  bool has(std::string_view field) const { return fields.contains(std::string(field)); }
  bool is_thinned() const { return has("particle"); }
  /// The row of each particle in a frame; none where it is not in the frame.
  std::vector<std::optional<std::uint32_t>> rows_in(const frames::Frame& frame) const;
  /// [m] of a particle, by its row in a frame. Without the field displacement, from its positions in the frame and in the first frame that has it.
  fccda::Vec3d displacement_in(const frames::Frame& frame, std::size_t particle, std::size_t row) const;
};

/// The panels of an impactor over the run.
struct ImpactorFrames {
  std::string name;
  std::vector<output::FrameFile> frames;  ///< readable frames
  std::vector<RigidMotion> motions;       ///< per frame, of the undeformed surface
  std::vector<fccda::Vec3d> vertices;     ///< [m] undeformed, in the first frame
  bool is_deformed = false;               ///< the frames have displacements
  Range displacement[3];                  ///< [m] over all frames, along the axes that move with the surface
  std::vector<std::array<int, 4>> panels;
  std::vector<std::string> arrays;  ///< names; of vectors the magnitude is used
  std::vector<Range> ranges;        ///< per array
};

struct Frames {
  std::vector<BodyFrames> bodies;
  std::vector<ImpactorFrames> impactors;

  /// The distinct times of all frames [s].
  std::vector<double> times() const;
};

/// Arrays of a frame with a number or vector for each panel: its own, and the means of those of its vertices over the corners (of vectors, of their
/// magnitudes).
std::vector<frames::FrameArray> panel_arrays(const frames::Frame& frame);

/// Displacements of the vertices of a frame [m] along the axes that move with the surface; empty for a rigid one.
std::vector<fccda::Vec3d> displacements(const frames::Frame& frame, const RigidMotion& motion);

/// Reads every frame of the folder once, of either format. Missing or damaged frames are omitted and reported in `notes`.
Frames scan_frames(const std::filesystem::path& folder, std::vector<std::string>& notes);

/// Selection of times and particles for a report.
struct Choice {
  std::vector<double> times;                          ///< [s] frames at other times are omitted
  std::vector<std::vector<std::uint32_t>> particles;  ///< particle numbers, per body
};

/// A part of the report that the browser decodes separately.
struct Blob {
  std::string id, text;  ///< base64
};

/// Encoded frames with their decoding instructions: the entries `bodies` and `impactors` of the report's description.
struct PackedFrames {
  output::Json bodies = output::Json::array(), impactors = output::Json::array();
  std::vector<Blob> blobs;                     ///< in chronological order
  std::size_t bytes = 0, bytes_of_bodies = 0;  ///< total size of the texts, and of those of bodies only
};

/// Reads the selected frames again and encodes them.
PackedFrames pack_frames(const Frames& frames, const Choice& choice);

}  // namespace perimpact::report
