#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "io/frames/frame.hpp"
#include "io/report/frames.hpp"

namespace perimpact::report {

namespace {

using fccda::Vec3d;
using output::Json;

/// An array that is encoded in each frame, with its quantisation.
struct PackedArray {
  std::string name, unit;
  int bytes;
  Scale scale;
  ArrayPacker packer;

  PackedArray(std::string its_name, std::string its_unit, int its_bytes, Scale its_scale)
      : name(std::move(its_name)), unit(std::move(its_unit)), bytes(its_bytes), scale(its_scale), packer(its_bytes) {}

  Json description() const {
    Json json = Json::object();
    json["name"] = name;
    json["unit"] = unit;
    json["bytes"] = bytes;
    json["low"] = scale.low();
    json["high"] = scale.high();
    json["step"] = scale.step();
    return json;
  }
};

constexpr std::uint32_t finest = 65535, coarsest = 4095;  // quantisation steps of 16 and 12 bits

PackedArray reals(std::string name, std::string unit, const Range& range, std::uint32_t steps) {
  return {std::move(name), std::move(unit), 2, Scale(range.low, range.high, steps)};
}

/// Quantisation of displacements: no finer than the reference positions unless displacements are small, since excess precision compresses badly.
std::uint32_t steps_of_displacement(const Range& displacement, const Range& place) {
  const double span = displacement.high - displacement.low, box = place.high - place.low;
  return box > 0 ? static_cast<std::uint32_t>(std::clamp<double>(std::ceil(finest * span / box), coarsest, finest)) : finest;
}

PackedArray whole_numbers(std::string name, std::uint32_t highest) {
  const int bytes = highest < 256 ? 1 : highest < 65536 ? 2 : 4;
  const auto steps = static_cast<std::uint32_t>((std::uint64_t{1} << (8 * bytes)) - 1);
  return {std::move(name), "", bytes, Scale(0, steps, steps)};
}

void add_blob(PackedFrames& out, std::string id, const std::string& bytes) {
  out.blobs.push_back({std::move(id), base64(gzip(bytes))});
  out.bytes += out.blobs.back().text.size();
}

const char* const axis_names[] = {"x", "y", "z"};

/// Encodes the frames of a body sequentially.
class PackedBody {
 public:
  PackedBody(const BodyFrames& body, const std::vector<std::uint32_t>& particles, std::size_t number, PackedFrames& out)
      : body_(body), particles_(particles), id_(fmt::format("body{}", number)) {
    description_["name"] = body.name;
    description_["id"] = id_;
    description_["particles"] = body.undeformed.size();
    description_["shown"] = particles.size();
    description_["spacing [m]"] = body.spacing;
    std::string bytes;
    Json& undeformed = description_["undeformed"];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      PackedArray place = reals(axis_names[axis], "m", body.place[axis], finest);
      place.packer.append(numbers(place.scale, [&](std::uint32_t i) { return body.undeformed[i][axis]; }), bytes);
      undeformed.push_back(place.description());
      arrays_.push_back(reals(fmt::format("displacement_{}", axis_names[axis]), "m", body.displacement[axis],
                              steps_of_displacement(body.displacement[axis], body.place[axis])));
    }
    add_blob(out, id_, bytes);
    if (body.has("velocity")) arrays_.push_back(reals("speed", "m/s", {0, body.speed.high, false}, coarsest));
    if (body.has("damage")) arrays_.emplace_back("damage", "", 1, Scale(0, 1, 255));
    if (body.has("plastic_strain")) arrays_.push_back(reals("plastic_strain", "", {0, body.plastic_strain.high, false}, coarsest));
    if (body.has("fragment")) arrays_.push_back(whole_numbers("fragment", body.highest_fragment));
    if (body.varies) arrays_.push_back(whole_numbers("is_written", 1));
    for (const PackedArray& array : arrays_) description_["arrays"].push_back(array.description());
    description_["pictures"] = Json::array();
    description_["offsets"] = Json::array();
  }

  void add(std::size_t number, std::size_t time_number, PackedFrames& out) {
    const frames::Frame frame = frames::read_frame(body_.frames[number]);
    const std::vector<std::optional<std::uint32_t>> rows = body_.rows_in(frame);
    std::string bytes;
    std::size_t a = 0;
    const auto pack = [&](const auto& value) {  // 0 of a particle that is not in the frame
      arrays_[a].packer.append(numbers(arrays_[a].scale, [&](std::uint32_t i) { return rows[i] ? value(i, *rows[i]) : 0; }), bytes);
      ++a;
    };
    const auto pack_field = [&](std::string_view field) {
      if (const frames::FrameArray* found = body_.has(field) ? frame.find(field) : nullptr)
        pack([&](std::uint32_t, std::uint32_t row) { return found->scalar(row); });
    };
    for (std::size_t axis = 0; axis < 3; ++axis) pack([&, axis](std::uint32_t i, std::uint32_t row) { return body_.displacement_in(frame, i, row)[axis]; });
    for (const std::string_view field : {"velocity", "damage", "plastic_strain", "fragment"}) pack_field(field);
    if (body_.varies) pack([](std::uint32_t, std::uint32_t) { return 1.0; });
    description_["pictures"].push_back(time_number);
    Json offset = Json::array();
    for (std::size_t axis = 0; axis < 3; ++axis) offset.push_back(body_.offsets[number][axis]);
    description_["offsets"].push_back(std::move(offset));
    add_blob(out, fmt::format("{}_{}", id_, time_number), bytes);
  }

  const Json& description() const { return description_; }

 private:
  template <class Value>
  std::vector<std::uint32_t> numbers(const Scale& scale, const Value& value) const {
    std::vector<std::uint32_t> out;
    out.reserve(particles_.size());
    for (const std::uint32_t i : particles_) out.push_back(scale.number_of(value(i)));
    return out;
  }

  const BodyFrames& body_;
  const std::vector<std::uint32_t>& particles_;
  std::string id_;
  Json description_ = Json::object();
  std::vector<PackedArray> arrays_;
};

std::string_view unit_of_panels(std::string_view array) {
  constexpr std::pair<std::string_view, std::string_view> units[] = {
      {"contact_pressure", "Pa"}, {"peak_pressure", "Pa"}, {"contact_impulse", "N s"}, {"displacement", "m"}, {"von_mises_stress", "Pa"}};
  const auto found = std::find_if(std::begin(units), std::end(units), [&](const auto& unit) { return unit.first == array; });
  return found == std::end(units) ? "" : found->second;
}

class PackedImpactor {
 public:
  PackedImpactor(const ImpactorFrames& impactor, std::size_t number, PackedFrames& out) : impactor_(impactor), id_(fmt::format("impactor{}", number)) {
    description_["name"] = impactor.name;
    description_["id"] = id_;
    description_["vertices"] = impactor.vertices.size();
    description_["panels"] = impactor.panels.size();
    std::string bytes;
    for (std::size_t axis = 0; axis < 3; ++axis) {  // as floats, bitwise
      std::vector<std::uint32_t> words;
      for (const Vec3d& vertex : impactor.vertices) words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(vertex[axis])));
      ArrayPacker(4).append(words, bytes);
    }
    for (std::size_t corner = 0; corner < 4; ++corner) {
      std::vector<std::uint32_t> words;
      for (const std::array<int, 4>& panel : impactor.panels) words.push_back(static_cast<std::uint32_t>(panel[corner]));
      ArrayPacker(4).append(words, bytes);
    }
    add_blob(out, id_, bytes);
    for (std::size_t a = 0; a < impactor.arrays.size(); ++a)
      arrays_.push_back(reals(impactor.arrays[a], std::string(unit_of_panels(impactor.arrays[a])), impactor.ranges[a], finest));
    description_["arrays"] = Json::array();
    for (const PackedArray& array : arrays_) description_["arrays"].push_back(array.description());
    description_["deformation"] = Json::array();
    for (std::size_t axis = 0; axis < 3 && impactor.is_deformed; ++axis) {
      deformation_.push_back(reals(axis_names[axis], "m", impactor.displacement[axis], finest));
      description_["deformation"].push_back(deformation_.back().description());
    }
    description_["pictures"] = Json::array();
    description_["motions"] = Json::array();
  }

  void add(std::size_t number, std::size_t time_number, PackedFrames& out) {
    const RigidMotion& motion = impactor_.motions[number];
    Json rows = Json::array();  // a 3 × 4 matrix
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t column = 0; column < 3; ++column) rows.push_back(motion.turn.row[axis][column]);
      rows.push_back(motion.shift[axis]);
    }
    description_["pictures"].push_back(time_number);
    description_["motions"].push_back(std::move(rows));
    if (arrays_.empty() && deformation_.empty()) return;
    const frames::Frame frame = frames::read_frame(impactor_.frames[number]);
    const std::vector<frames::FrameArray> arrays = panel_arrays(frame);
    std::string bytes;
    for (PackedArray& packed : arrays_) {
      const auto array = std::find_if(arrays.begin(), arrays.end(), [&](const frames::FrameArray& one) { return one.name == packed.name; });
      std::vector<std::uint32_t> numbers;
      for (std::size_t i = 0; i < array->count(); ++i) numbers.push_back(packed.scale.number_of(array->scalar(i)));
      packed.packer.append(numbers, bytes);
    }
    const std::vector<Vec3d> moved = displacements(frame, motion);
    for (std::size_t axis = 0; axis < deformation_.size(); ++axis) {
      std::vector<std::uint32_t> numbers;
      for (const Vec3d& u : moved) numbers.push_back(deformation_[axis].scale.number_of(u[axis]));
      deformation_[axis].packer.append(numbers, bytes);
    }
    add_blob(out, fmt::format("{}_{}", id_, time_number), bytes);
  }

  const Json& description() const { return description_; }

 private:
  const ImpactorFrames& impactor_;
  std::string id_;
  Json description_ = Json::object();
  std::vector<PackedArray> arrays_;
  std::vector<PackedArray> deformation_;  // along each axis of the first frame, of each vertex; empty for a rigid surface
};

}  // namespace

PackedFrames pack_frames(const Frames& frames, const Choice& choice) {
  PackedFrames out;
  std::vector<PackedBody> bodies;
  std::vector<PackedImpactor> impactors;
  for (std::size_t b = 0; b < frames.bodies.size(); ++b) bodies.emplace_back(frames.bodies[b], choice.particles[b], b, out);
  out.bytes_of_bodies = out.bytes;
  for (std::size_t i = 0; i < frames.impactors.size(); ++i) impactors.emplace_back(frames.impactors[i], i, out);

  for (std::size_t now = 0; now < choice.times.size(); ++now) {
    const auto add_frame = [&](const std::vector<output::FrameFile>& series, auto& packed) {
      const auto is_now = [&](const output::FrameFile& frame) { return frame.time == choice.times[now]; };
      const auto frame = std::find_if(series.begin(), series.end(), is_now);
      if (frame != series.end()) packed.add(static_cast<std::size_t>(frame - series.begin()), now, out);
    };
    const std::size_t before = out.bytes;
    for (std::size_t b = 0; b < bodies.size(); ++b) add_frame(frames.bodies[b].frames, bodies[b]);
    out.bytes_of_bodies += out.bytes - before;
    for (std::size_t i = 0; i < impactors.size(); ++i) add_frame(frames.impactors[i].frames, impactors[i]);
  }
  for (const PackedBody& body : bodies) out.bodies.push_back(body.description());
  for (const PackedImpactor& impactor : impactors) out.impactors.push_back(impactor.description());
  return out;
}

}  // namespace perimpact::report
