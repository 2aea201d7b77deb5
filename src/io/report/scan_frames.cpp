#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "io/frames/frame.hpp"
#include "io/output/pvd.hpp"
#include "io/output/results_folder.hpp"
#include "io/report/frames.hpp"

namespace perimpact::report {

namespace {

using fccda::InputError;
using fccda::Vec3d;

/// The array with that number of components, or nullptr.
const frames::FrameArray* array_of(const frames::Frame& frame, std::string_view name, int components) {
  const frames::FrameArray* found = frame.find(name);
  return found != nullptr && found->components == components ? found : nullptr;
}

const frames::FrameArray& needed(const frames::Frame& frame, const output::FrameFile& entry, std::string_view name, int components) {
  if (const frames::FrameArray* found = array_of(frame, name, components)) return *found;
  throw InputError(
      fmt::format("{}: the frame has no array {} of {} numbers per particle; use the file as written by the run.", entry.name(), name, components));
}

/// The most frequent distance between successive particles [m]: the lattice spacing.
double default_distance(const std::vector<Vec3d>& points) {
  std::vector<double> distances;
  for (std::size_t i = 1; i < points.size(); ++i) distances.push_back(fccda::norm(points[i] - points[i - 1]));
  if (distances.empty()) return 1;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle > 0 ? *middle : 1;
}

void add_particles(BodyFrames& body, const frames::Frame& frame, const output::FrameFile& entry) {
  const frames::FrameArray& displacement = needed(frame, entry, "displacement", 3);
  const frames::FrameArray& velocity = needed(frame, entry, "velocity", 3);
  const frames::FrameArray& damage = needed(frame, entry, "damage", 1);
  const frames::FrameArray* fragment = array_of(frame, "fragment", 1);
  const frames::FrameArray* plastic_strain = array_of(frame, "plastic_strain", 1);
  const std::size_t count = frame.points.size();
  const bool is_first = body.frames.empty();
  if (!is_first && count != body.undeformed.size())
    throw InputError(
        fmt::format("{} has {} particles, but the earlier frames have {}; use the files of one run.", entry.name(), count, body.undeformed.size()));
  if (!is_first && (fragment != nullptr) != body.has_fragments)
    throw InputError(fmt::format("{} and the earlier frames are not of one run: only {} fragments; use the files of one run.", entry.name(),
                                 fragment ? "it lists" : "those list"));
  if (!is_first && (plastic_strain != nullptr) != body.has_plastic_strain)
    throw InputError(fmt::format("{} and the earlier frames are not of one run: only {} plastic strains; use the files of one run.", entry.name(),
                                 plastic_strain ? "it lists" : "those list"));
  if (is_first) {
    body.has_fragments = fragment != nullptr;
    body.has_plastic_strain = plastic_strain != nullptr;
    for (std::size_t i = 0; i < count; ++i) {
      const double* u = &displacement.numbers[3 * i];
      body.undeformed.push_back(frame.points[i] - Vec3d{u[0], u[1], u[2]});
      for (std::size_t axis = 0; axis < 3; ++axis) body.place[axis].include(body.undeformed.back()[axis]);
    }
    body.spacing = default_distance(body.undeformed);
  }
  body.is_damaged.assign(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) body.displacement[axis].include(displacement.numbers[3 * i + axis]);
    body.speed.include(velocity.scalar(i));
    body.is_damaged[i] = damage.numbers[i] > 0;
    if (plastic_strain) body.plastic_strain.include(plastic_strain->numbers[i]);
    if (fragment) body.highest_fragment = std::max(body.highest_fragment, static_cast<std::uint32_t>(std::max(0.0, fragment->numbers[i])));
  }
  body.frames.push_back(entry);
}

/// The displacements of the vertices [m], in global axes; nullptr for a rigid surface.
const frames::FrameArray* displacement_of(const frames::Frame& frame) {
  const frames::FrameArray* found = frame.find_of_vertices("displacement");
  return found != nullptr && found->components == 3 ? found : nullptr;
}

std::vector<Vec3d> undeformed(const frames::Frame& frame) {
  std::vector<Vec3d> places = frame.points;
  if (const frames::FrameArray* u = displacement_of(frame))
    for (std::size_t v = 0; v < places.size(); ++v) places[v] -= Vec3d{u->numbers[3 * v], u->numbers[3 * v + 1], u->numbers[3 * v + 2]};
  return places;
}

void add_panels(ImpactorFrames& impactor, const frames::Frame& frame, const output::FrameFile& entry) {
  const std::vector<frames::FrameArray> arrays = panel_arrays(frame);
  const std::vector<Vec3d> places = undeformed(frame);
  if (impactor.frames.empty()) {
    impactor.vertices = places;
    impactor.panels = frame.panels;
    impactor.is_deformed = displacement_of(frame) != nullptr;
    for (const frames::FrameArray& array : arrays) impactor.arrays.push_back(array.name);
    impactor.ranges.resize(impactor.arrays.size());
  }
  fccda::Box box;
  for (const Vec3d& point : frame.points) box.include(point);
  constexpr double rounding = 1e-9;  // relative to coordinates; the run moves its surfaces in double precision
  const auto motion = rigid_motion(impactor.vertices, places, rounding * (fccda::largest_magnitude(box.low) + fccda::largest_magnitude(box.high)));
  if (!motion || frame.panels.size() != impactor.panels.size() || impactor.is_deformed != (displacement_of(frame) != nullptr))
    throw InputError(fmt::format("{} has a different surface from the earlier frames; use the files of one run.", entry.name()));
  for (std::size_t a = 0; a < impactor.arrays.size(); ++a) {
    const auto array = std::find_if(arrays.begin(), arrays.end(), [&](const frames::FrameArray& one) { return one.name == impactor.arrays[a]; });
    if (array == arrays.end())
      throw InputError(fmt::format("{} lacks the array {} of the earlier frames; use the files of one run.", entry.name(), impactor.arrays[a]));
    for (std::size_t i = 0; i < array->count(); ++i) impactor.ranges[a].include(array->scalar(i));
  }
  for (const Vec3d& u : displacements(frame, *motion))
    for (std::size_t axis = 0; axis < 3; ++axis) impactor.displacement[axis].include(u[axis]);
  impactor.motions.push_back(*motion);
  impactor.frames.push_back(entry);
}

void scan_series(const std::filesystem::path& list, Frames& frames, std::vector<std::string>& notes) {
  BodyFrames body{.name = list.stem().string()};
  ImpactorFrames impactor{.name = list.stem().string()};
  for (const output::FrameFile& entry : frames::frames_of(list)) try {
      const frames::Frame frame = frames::read_frame(entry);
      frame.panels.empty() ? add_particles(body, frame, entry) : add_panels(impactor, frame, entry);
    } catch (const InputError& error) {
      notes.emplace_back(error.what());
    }
  if (!body.frames.empty()) frames.bodies.push_back(std::move(body));
  if (!impactor.frames.empty()) frames.impactors.push_back(std::move(impactor));
}

}  // namespace

void Range::include(double value) {
  low = is_empty ? value : std::min(low, value);
  high = is_empty ? value : std::max(high, value);
  is_empty = false;
}

std::vector<frames::FrameArray> panel_arrays(const frames::Frame& frame) {
  std::vector<frames::FrameArray> arrays = frame.arrays;
  for (const frames::FrameArray& array : frame.vertex_arrays) {
    if (array.components != 1 && array.components != 3) continue;
    frames::FrameArray& means = arrays.emplace_back(frames::FrameArray{.name = array.name});
    for (const std::array<int, 4>& panel : frame.panels) {
      const std::size_t corners = panel[3] < 0 ? 3 : 4;
      double sum = 0;
      for (std::size_t corner = 0; corner < corners; ++corner) sum += array.scalar(static_cast<std::size_t>(panel[corner]));
      means.numbers.push_back(sum / static_cast<double>(corners));
    }
  }
  return arrays;
}

std::vector<Vec3d> displacements(const frames::Frame& frame, const RigidMotion& motion) {
  std::vector<Vec3d> out;
  const frames::FrameArray* u = displacement_of(frame);
  if (u == nullptr) return out;
  const fccda::Mat3 turn_back = fccda::transpose(motion.turn);
  for (std::size_t v = 0; v < frame.points.size(); ++v) out.push_back(turn_back * Vec3d{u->numbers[3 * v], u->numbers[3 * v + 1], u->numbers[3 * v + 2]});
  return out;
}

std::vector<double> Frames::times() const {
  std::vector<double> times;
  const auto add = [&](const std::vector<output::FrameFile>& frames) {
    for (const output::FrameFile& frame : frames) times.push_back(frame.time);
  };
  for (const BodyFrames& body : bodies) add(body.frames);
  for (const ImpactorFrames& impactor : impactors) add(impactor.frames);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

Frames scan_frames(const std::filesystem::path& folder, std::vector<std::string>& notes) {
  const std::filesystem::path folder_of_frames = output::ResultsFolder::frames_in(folder);
  std::vector<std::filesystem::path> lists;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(folder_of_frames, missing))
    if (entry.path().extension() == ".pvd" || entry.path().extension() == ".vtkhdf") lists.push_back(entry.path());
  std::sort(lists.begin(), lists.end());

  Frames frames;
  if (lists.empty())
    notes.push_back(fmt::format("{} contains no frame series (.pvd or .vtkhdf), so there is no 3-D view; set `output.frames` in the deck to write frames.",
                                folder_of_frames.string()));
  for (const std::filesystem::path& list : lists) try {
      scan_series(list, frames, notes);
    } catch (const InputError& error) {
      notes.emplace_back(error.what());
    }
  return frames;
}

}  // namespace perimpact::report
