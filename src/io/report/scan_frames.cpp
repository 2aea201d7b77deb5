#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/error.hpp"
#include "io/frames/frame.hpp"
#include "io/output/pvd.hpp"
#include "io/output/results_folder.hpp"
#include "io/report/frames.hpp"

namespace perimpact::report {

namespace {

using fccda::InputError;
using fccda::Vec3d;

/// Fields of particles with the numbers each has.
constexpr std::pair<std::string_view, int> known_fields[] = {{"displacement", 3},   {"velocity", 3}, {"damage", 1},
                                                             {"plastic_strain", 1}, {"fragment", 1}, {"particle", 1}};

/// The fields of a frame, as the run writes them.
std::set<std::string> fields_of(const frames::Frame& frame, const output::FrameFile& entry) {
  std::set<std::string> fields;
  for (const auto& [name, components] : known_fields) {
    const frames::FrameArray* found = frame.find(name);
    if (found != nullptr && found->components != components)
      throw InputError(fmt::format("{}: the array {} has {} numbers per particle instead of {}; use the file as written by the run.", entry.name(), name,
                                   found->components, components));
    if (found != nullptr) fields.emplace(name);
  }
  return fields;
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

void expect_same_run(const BodyFrames& body, const std::set<std::string>& fields, std::size_t count, const output::FrameFile& entry) {
  if (body.frames.empty()) return;
  if (!body.is_thinned() && count != body.undeformed.size())
    throw InputError(
        fmt::format("{} has {} particles, but the earlier frames have {}; use the files of one run.", entry.name(), count, body.undeformed.size()));
  std::vector<std::string> others;
  std::ranges::set_symmetric_difference(fields, body.fields, std::back_inserter(others));
  if (!others.empty())
    throw InputError(fmt::format("{} and the earlier frames are not of one run: only {} the field {}; use the files of one run.", entry.name(),
                                 fields.contains(others.front()) ? "it has" : "those have", others.front()));
}

/// Adds the particles that no earlier frame has. The displacement of a particle without the field is reckoned from here.
void add_new_particles(BodyFrames& body, const frames::Frame& frame) {
  const frames::FrameArray *displacement = frame.find("displacement"), *number = frame.find("particle");
  for (std::size_t row = 0; row < frame.points.size(); ++row) {
    const auto index = static_cast<std::uint32_t>(body.undeformed.size());
    if (number ? !body.indices.emplace(static_cast<std::int32_t>(number->numbers[row]), index).second : index > row) continue;
    const Vec3d u = displacement ? Vec3d{displacement->numbers[3 * row], displacement->numbers[3 * row + 1], displacement->numbers[3 * row + 2]} : Vec3d{};
    body.undeformed.push_back(frame.points[row] - u);
    for (std::size_t axis = 0; axis < 3; ++axis) body.place[axis].include(body.undeformed.back()[axis]);
  }
  body.is_damaged.resize(body.undeformed.size(), false);
}

/// A moving window moves its lattice by whole spacings, so any particle has the offset of all.
Vec3d offset_of(const BodyFrames& body, const frames::Frame& frame) {
  const frames::FrameArray* u = frame.find("displacement");
  if (u == nullptr || body.is_thinned() || frame.points.empty()) return {};
  return frame.points.front() - Vec3d{u->numbers[0], u->numbers[1], u->numbers[2]} - body.undeformed.front();
}

void add_particles(BodyFrames& body, const frames::Frame& frame, const output::FrameFile& entry) {
  const std::set<std::string> fields = fields_of(frame, entry);
  expect_same_run(body, fields, frame.points.size(), entry);
  body.fields = fields;
  const std::size_t before = body.undeformed.size();
  add_new_particles(body, frame);
  body.varies = body.varies || (!body.frames.empty() && body.undeformed.size() > before) || frame.points.size() < body.undeformed.size();
  const frames::FrameArray *velocity = frame.find("velocity"), *damage = frame.find("damage"), *plastic_strain = frame.find("plastic_strain"),
                           *fragment = frame.find("fragment");
  const std::vector<std::optional<std::uint32_t>> rows = body.rows_in(frame);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i]) continue;
    const std::size_t row = *rows[i];
    const Vec3d u = body.displacement_in(frame, i, row);
    for (std::size_t axis = 0; axis < 3; ++axis) body.displacement[axis].include(u[axis]);
    if (velocity) body.speed.include(velocity->scalar(row));
    if (damage && damage->numbers[row] > 0) body.is_damaged[i] = true;
    if (plastic_strain) body.plastic_strain.include(plastic_strain->numbers[row]);
    if (fragment) body.highest_fragment = std::max(body.highest_fragment, static_cast<std::uint32_t>(std::max(0.0, fragment->numbers[row])));
  }
  body.offsets.push_back(offset_of(body, frame));
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
  if (!body.frames.empty()) {
    body.spacing = default_distance(body.undeformed);
    for (Vec3d& offset : body.offsets)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (std::abs(offset[axis]) < body.spacing / 2) offset[axis] = 0;  // rounding
    frames.bodies.push_back(std::move(body));
  }
  if (!impactor.frames.empty()) frames.impactors.push_back(std::move(impactor));
}

}  // namespace

void Range::include(double value) {
  low = is_empty ? value : std::min(low, value);
  high = is_empty ? value : std::max(high, value);
  is_empty = false;
}

std::vector<std::optional<std::uint32_t>> BodyFrames::rows_in(const frames::Frame& frame) const {
  std::vector<std::optional<std::uint32_t>> rows(undeformed.size());
  const frames::FrameArray* number = is_thinned() ? frame.find("particle") : nullptr;
  for (std::uint32_t row = 0; row < frame.points.size(); ++row) rows[number ? indices.at(static_cast<std::int32_t>(number->numbers[row])) : row] = row;
  return rows;
}

Vec3d BodyFrames::displacement_in(const frames::Frame& frame, std::size_t particle, std::size_t row) const {
  const frames::FrameArray* u = has("displacement") ? frame.find("displacement") : nullptr;
  return u ? Vec3d{u->numbers[3 * row], u->numbers[3 * row + 1], u->numbers[3 * row + 2]} : frame.points[row] - undeformed[particle];
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
