#include "io/results/particle_frame.hpp"

#include <algorithm>
#include <bit>
#include <memory>
#include <type_traits>
#include <utility>

#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "io/output/vtp.hpp"

namespace perimpact {

namespace {

template <class Of>
constexpr std::size_t components_of = std::is_same_v<Of, Vec3d> ? 3 : 1;

template <class Number, class Of>
void put(const Of& value, Number* to) {
  if constexpr (components_of<Of> == 3)
    for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<Number>(value[c]);
  else
    *to = static_cast<Number>(value);
}

}  // namespace

ParticleFrame::ParticleFrame(const Body& body, const Fragments* fragments, std::span<const std::string> fields, ParticleNumbers particles, bool varies)
    : body_(body), fragments_(fragments), fields_(fields), particles_(std::move(particles)), varies_(varies) {}

std::size_t ParticleFrame::size() const { return particles_ ? particles_->size() : body_.particles.size(); }

/// value(particle), a number or a vector, of the particles of this frame on all ranks; on the root, elsewhere empty. Collective.
template <class Number, class Value>
std::vector<Number> ParticleFrame::gathered(const Value& value) const {
  constexpr std::size_t components = components_of<std::invoke_result_t<const Value&, std::size_t>>;
  const Particles& particles = body_.particles;
  if (particles_) {
    std::vector<Number> own(components * size());
    for (std::size_t index = 0; index < size(); ++index) put(value(number(index)), own.data() + components * index);
    return particles.share().gather_listed(std::span<const Number>(own), slots());
  }
  std::vector<Number> of_slots(components * particles.slots());
  for (std::size_t particle = 0; particle < size(); ++particle) put(value(particle), of_slots.data() + components * particles.slot_of()[particle]);
  return particles.gather(std::span<const Number>(of_slots), components);
}

/// value(particle) of each, a number or a vector.
template <class Value>
output::MadeFloats ParticleFrame::floats(const Value& value) const {
  if (!body_.particles.share().is_whole()) {  // all ranks take part, whether the sink asks for the numbers or not
    const auto all = std::make_shared<std::vector<float>>(gathered<float>(value));
    return {all->size(), [all] { return std::move(*all); }};
  }
  constexpr std::size_t components = components_of<std::invoke_result_t<const Value&, std::size_t>>;
  return {components * size(), [this, value] {
            std::vector<float> numbers(components * size());
            fccda::parallel_for(static_cast<std::ptrdiff_t>(size()), [&](std::ptrdiff_t at) {
              const auto index = static_cast<std::size_t>(at);
              put(value(number(index)), numbers.data() + components * index);
            });
            return numbers;
          }};
}

/// Those of the particles of this frame, of a number for each particle of the body.
template <class Number>
output::Numbers ParticleFrame::selected(std::span<const Number> all, std::vector<Number>& store) const {
  if (!body_.particles.share().is_whole()) {
    store = gathered<Number>([&](std::size_t particle) { return all[particle]; });
  } else {
    if (!particles_) return all;
    store.reserve(size());
    for (const std::int32_t particle : *particles_) store.push_back(all[static_cast<std::size_t>(particle)]);
  }
  return std::span<const Number>(store);
}

/// Slots of the particles of a thinned frame.
std::vector<std::uint32_t> ParticleFrame::slots() const {
  std::vector<std::uint32_t> slots(size());
  for (std::size_t index = 0; index < slots.size(); ++index) slots[index] = body_.particles.slot_of()[number(index)];
  return slots;
}

/// Numbers of the particles of a thinned frame among those of the body, of all ranks; on the root, elsewhere empty. Collective.
std::vector<std::int32_t> ParticleFrame::numbers_in_body() const {
  const Particles& particles = body_.particles;
  const Share& share = particles.share();
  if (share.is_whole()) return *particles_;
  std::vector<std::uint8_t> occupied(particles.slots() / fccda::byte_lanes);
  for (std::size_t eight = 0; eight < occupied.size(); ++eight) occupied[eight] = particles.occupied(eight);
  occupied = share.gather(std::span<const std::uint8_t>(occupied), {.each = 1});
  std::vector<std::int32_t> numbers;
  std::size_t eight = 0, before = 0;  // before: number of particles in the eights before this one
  for (const std::uint64_t slot : gathered<std::uint64_t>([&](std::size_t particle) { return share.whole_slot(particles.slot_of()[particle]); })) {
    for (; eight < slot / fccda::byte_lanes; ++eight) before += static_cast<std::size_t>(std::popcount(occupied[eight]));
    const std::uint8_t lower = static_cast<std::uint8_t>(occupied[eight] & ((1u << (slot % fccda::byte_lanes)) - 1));
    numbers.push_back(static_cast<std::int32_t>(before + static_cast<std::size_t>(std::popcount(lower))));
  }
  return numbers;
}

void ParticleFrame::write(const frames::Sink& sink) const {
  const Particles& particles = body_.particles;
  const auto slots = particles.slot_of();
  std::vector<output::VtpArray> arrays;
  const auto is_wanted = [&](std::string_view field) { return std::find(fields_.begin(), fields_.end(), field) != fields_.end(); };
  const auto add = [&](const char* field, int components, const auto& value) {
    if (is_wanted(field)) arrays.push_back({field, components, floats(value)});
  };
  add("displacement", 3, [&particles, slots](std::size_t particle) { return particles.displacement(slots[particle]); });
  add("velocity", 3, [&particles, slots](std::size_t particle) { return particles.velocity.at(slots[particle]); });
  add("damage", 1, [this, slots](std::size_t particle) { return body_.family.damage(slots[particle]); });
  if (const PlasticForce* plastic = body_.internal.plastic())
    add("plastic_strain", 1, [plastic, slots](std::size_t particle) { return plastic->equivalent_strain(slots[particle]); });
  std::vector<std::int32_t> fragments, originals, numbers;
  if (fragments_ && is_wanted("fragment")) arrays.push_back({"fragment", 1, selected(fragments_->of_particles(), fragments)});
  if (!particles.numbers().empty() && is_wanted("original")) {
    originals = gathered<std::int32_t>([&](std::size_t particle) { return particles.numbers()[slots[particle]]; });
    arrays.push_back({"original", 1, std::span<const std::int32_t>(originals), !varies_});
  }
  if (particles_) {
    numbers = numbers_in_body();
    arrays.push_back({"particle", 1, std::span<const std::int32_t>(numbers), !varies_});
  }
  sink({.points = floats([&particles, slots](std::size_t particle) { return particles.position.at(slots[particle]); }),
        .point_arrays = std::move(arrays),
        .varies = varies_});
}

void write_particles(const std::filesystem::path& path, const Body& body) {
  const std::vector<std::string> fields(std::begin(frame_field_words), std::end(frame_field_words));
  ParticleFrame(body, nullptr, fields, {}, false).write([&](const output::PolyData& frame) { output::write_vtp(path, frame, output::Compression::zlib); });
}

}  // namespace perimpact
