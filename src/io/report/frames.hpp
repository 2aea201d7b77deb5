/// The pictures of a results folder as a report holds them.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/vec3.hpp"
#include "io/output/json.hpp"
#include "io/output/pvd.hpp"
#include "io/report/packing.hpp"
#include "io/report/rigid_motion.hpp"

namespace perimpact::report {

/// Smallest and largest of numbers.
struct Range {
  double low = 0, high = 0;
  bool is_empty = true;

  void include(double value);
};

/// The particles of a body over the run.
struct BodyFrames {
  std::string name;
  double spacing = 0;                      ///< [m]
  std::vector<output::FrameFile> frames;   ///< that can be read
  std::vector<fccda::Vec3d> undeformed;    ///< [m] of all particles
  Range place[3], displacement[3], speed;  ///< over all pictures [m] [m] [m/s]
  std::uint32_t highest_fragment = 0;
  bool has_fragments = false;
  Range plastic_strain;  ///< [-] over all pictures
  bool has_plastic_strain = false;
  std::vector<bool> is_damaged;  ///< in the last picture
};

/// The panels of an impactor over the run.
struct ImpactorFrames {
  std::string name;
  std::vector<output::FrameFile> frames;  ///< that can be read
  std::vector<RigidMotion> motions;       ///< of each picture
  std::vector<fccda::Vec3d> vertices;     ///< [m] in the first picture
  std::vector<std::array<int, 4>> panels;
  std::vector<std::string> arrays;  ///< names; vectors are told by their length
  std::vector<Range> ranges;        ///< of each array
};

struct Frames {
  std::vector<BodyFrames> bodies;
  std::vector<ImpactorFrames> impactors;

  /// [s] of all pictures of all of them, each time once.
  std::vector<double> times() const;
};

/// Reads every picture of the folder once. What is missing or damaged is left out, and told in a sentence of `notes`.
Frames scan_frames(const std::filesystem::path& folder, std::vector<std::string>& notes);

/// What of it all a report holds.
struct Choice {
  std::vector<double> times;                          ///< [s] pictures at other times are left out
  std::vector<std::vector<std::uint32_t>> particles;  ///< of each body, by number
};

/// A part of the report that the browser unpacks by itself.
struct Blob {
  std::string id, text;  ///< base64
};

/// How the blobs are to be read: the entries `bodies` and `impactors` of the report's description.
struct PackedFrames {
  output::Json bodies = output::Json::array(), impactors = output::Json::array();
  std::vector<Blob> blobs;                     ///< in the order of time
  std::size_t bytes = 0, bytes_of_bodies = 0;  ///< of all texts, and of those of bodies alone
};

/// Reads the chosen pictures again and packs them.
PackedFrames pack_frames(const Frames& frames, const Choice& choice);

}  // namespace perimpact::report
