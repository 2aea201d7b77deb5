#include "io/results/particle_frame.hpp"

#include <algorithm>
#include <memory>
#include <type_traits>
#include <utility>

#include "base/parallel.hpp"
#include "io/output/vtp.hpp"

namespace perimpact {

ParticleFrame::ParticleFrame(const Body& body, const Fragments* fragments, std::span<const std::string> fields, ParticleNumbers particles, bool varies)
    : body_(body), fragments_(fragments), fields_(fields), particles_(std::move(particles)), varies_(varies) {}

std::size_t ParticleFrame::size() const { return particles_ ? particles_->size() : body_.particles.size(); }

/// value(slot) of each particle, a number or a vector.
template <class Value>
output::MadeFloats ParticleFrame::floats(const Value& value) const {
  using Of = std::invoke_result_t<const Value&, std::uint32_t>;
  constexpr std::size_t components = std::is_same_v<Of, Vec3d> ? 3 : 1;
  const auto put = [](const Of& v, float* to) {
    if constexpr (components == 3)
      for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<float>(v[c]);
    else
      *to = static_cast<float>(v);
  };
  if (!body_.particles.share().is_whole()) {  // all ranks take part, whether the sink asks for the numbers or not
    std::vector<float> of_slots(components * body_.particles.slots());
    for (const std::uint32_t slot : body_.particles.slot_of()) put(value(slot), of_slots.data() + components * slot);
    const auto gathered = std::make_shared<std::vector<float>>(body_.particles.gather(std::span<const float>(of_slots), components));
    return {gathered->size(), [gathered] { return std::move(*gathered); }};
  }
  return {components * size(), [this, value, put] {
            std::vector<float> numbers(components * size());
            fccda::parallel_for(static_cast<std::ptrdiff_t>(size()), [&](std::ptrdiff_t at) {
              const auto index = static_cast<std::size_t>(at);
              put(value(body_.particles.slot_of()[number(index)]), numbers.data() + components * index);
            });
            return numbers;
          }};
}

/// Those of the particles of this frame, of a number for each particle of the body.
template <class Number>
output::Numbers ParticleFrame::selected(std::span<const Number> all, std::vector<Number>& store) const {
  if (!particles_) return all;
  store.reserve(size());
  for (const std::int32_t particle : *particles_) store.push_back(all[static_cast<std::size_t>(particle)]);
  return std::span<const Number>(store);
}

void ParticleFrame::write(const frames::Sink& sink) const {
  const Particles& particles = body_.particles;
  std::vector<output::VtpArray> arrays;
  const auto is_wanted = [&](std::string_view field) { return std::find(fields_.begin(), fields_.end(), field) != fields_.end(); };
  const auto add = [&](const char* field, int components, const auto& value) {
    if (is_wanted(field)) arrays.push_back({field, components, floats(value)});
  };
  add("displacement", 3, [&particles](std::uint32_t slot) { return particles.displacement(slot); });
  add("velocity", 3, [&particles](std::uint32_t slot) { return particles.velocity.at(slot); });
  add("damage", 1, [this](std::uint32_t slot) { return body_.family.damage(slot); });
  if (const PlasticForce* plastic = body_.internal.plastic())
    add("plastic_strain", 1, [plastic](std::uint32_t slot) { return plastic->equivalent_strain(slot); });
  std::vector<std::int32_t> fragments, originals;
  if (fragments_ && is_wanted("fragment")) {
    if (particles.share().is_whole()) {
      arrays.push_back({"fragment", 1, selected(fragments_->of_particles(), fragments)});
    } else {
      std::vector<std::int32_t> of_slots(particles.slots());
      for (std::size_t p = 0; p < particles.size(); ++p) of_slots[particles.slot_of()[p]] = fragments_->of_particles()[p];
      fragments = particles.gather(std::span<const std::int32_t>(of_slots), 1);
      arrays.push_back({"fragment", 1, std::span<const std::int32_t>(fragments)});
    }
  }
  if (!particles.numbers().empty() && is_wanted("original")) {
    for (std::size_t index = 0; index < size(); ++index)
      originals.push_back(static_cast<std::int32_t>(particles.numbers()[particles.slot_of()[number(index)]]));
    arrays.push_back({"original", 1, std::span<const std::int32_t>(originals), !varies_});
  }
  if (particles_) arrays.push_back({"particle", 1, std::span<const std::int32_t>(*particles_), !varies_});
  sink({.points = floats([&particles](std::uint32_t slot) { return particles.position.at(slot); }), .point_arrays = std::move(arrays), .varies = varies_});
}

void write_particles(const std::filesystem::path& path, const Body& body) {
  const std::vector<std::string> fields(std::begin(frame_field_words), std::end(frame_field_words));
  ParticleFrame(body, nullptr, fields, {}, false).write([&](const output::PolyData& frame) { output::write_vtp(path, frame, output::Compression::zlib); });
}

}  // namespace perimpact
