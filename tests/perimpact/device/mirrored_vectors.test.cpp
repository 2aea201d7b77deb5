#include "perimpact/device/mirrored_vectors.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "perimpact/device/emulated_device.hpp"

using namespace perimpact;
using namespace perimpact::device;

namespace {

constexpr std::size_t slots = 200, slack = 24;

/// Positions and velocities on a device, beside the same in one place.
struct TwoSides {
  VectorArray position{slots, slack}, velocity{slots, slack}, force{slots, slack};
  VectorArray true_position = position, true_velocity = velocity;
  EmulatedDevice device;
  Mirrors mirrors{device};
  MirroredVectors motion{device, mirrors, {&position, &velocity}};

  TwoSides() {
    for (const VectorArray* array : {&position, &velocity, &force}) mirrors.add(array->with_slack());
  }

  static Motion motion_of(VectorArray& x, VectorArray& v, const VectorArray& f) {
    return {x.writable_pointers(), v.writable_pointers(), f.pointers(), 0.0, 0.5};
  }
  void advance_on_device() {
    motion.to_device();
    device.launch(AdvanceKernel{mirrors.on_device(motion_of(position, velocity, force))}, slots);
    motion.changed_on_device();
    for (std::size_t slot = 0; slot < slots; ++slot) advance_pack<double>(motion_of(true_position, true_velocity, force), slot);
  }
  void change_on_host(std::uint32_t slot, const Vec3d& x, const Vec3d& v) {
    for (VectorArray* array : {&position, &true_position}) array->set(slot, x);
    for (VectorArray* array : {&velocity, &true_velocity}) array->set(slot, v);
  }
  bool is_true_on_host(std::uint32_t slot) const { return position.at(slot) == true_position.at(slot) && velocity.at(slot) == true_velocity.at(slot); }
  bool is_true_on_device() {
    motion.to_device();
    std::vector<double> copy(slots);
    for (const auto& [array, truth] : {std::pair(&position, &true_position), std::pair(&velocity, &true_velocity)})
      for (std::size_t c = 0; c < 3; ++c) {
        device.download(copy.data(), mirrors.at(std::as_const(*array).component(c)), slots * sizeof(double));
        if (!std::equal(copy.begin(), copy.end(), std::as_const(*truth).component(c))) return false;
      }
    return true;
  }
  std::size_t copied() const { return device.copied().uploaded + device.copied().downloaded; }
};

}  // namespace

TEST_CASE("mirrored vectors: whatever the host and the device change in turn, both read the latest values") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Vec3d{number(random), number(random), number(random)}; };
  const auto listed = [&] {  // a few slots, or more than half of them, in any order
    std::vector<std::uint32_t> list(slots);
    for (std::uint32_t slot = 0; slot < slots; ++slot) list[slot] = slot;
    std::shuffle(list.begin(), list.end(), random);
    list.resize(random() % 4 == 0 ? slots / 2 + random() % (slots / 2) : random() % (slots / 8));
    return list;
  };
  TwoSides sides;
  std::array<int, 6> done{};
  for (int change = 0; change < 2000; ++change) {
    const std::size_t what = random() % done.size();
    ++done[what];
    if (what == 0) sides.advance_on_device();
    if (what == 1) {
      const std::vector<std::uint32_t> list = listed();
      sides.motion.to_host(list);
      for (const std::uint32_t slot : list) REQUIRE(sides.is_true_on_host(slot));
      for (const std::uint32_t slot : list) sides.change_on_host(slot, vector(), vector());
      sides.motion.changed_on_host(list);
    }
    if (what == 2) {
      sides.motion.to_host();
      for (const std::uint32_t slot : listed()) sides.change_on_host(slot, vector(), vector());
      sides.motion.changed_on_host();
    }
    if (what == 3) {
      const std::vector<std::uint32_t> list = listed();
      sides.motion.to_host(list);
      for (const std::uint32_t slot : list) REQUIRE(sides.is_true_on_host(slot));
    }
    if (what == 4) {
      sides.motion.to_host();
      for (std::uint32_t slot = 0; slot < slots; ++slot) REQUIRE(sides.is_true_on_host(slot));
    }
    if (what == 5) REQUIRE(sides.is_true_on_device());
  }
  for (const int times : done) CHECK(times > 100);
}

TEST_CASE("mirrored vectors: what the host reads without having fetched it is not a number, and what is current does not travel again") {
  TwoSides sides;
  for (std::uint32_t slot = 0; slot < slots; ++slot) sides.change_on_host(slot, {1, 2, 3}, {2, 4, 6});
  sides.advance_on_device();
  const std::vector<std::uint32_t> list{7, 190, 3};
  std::size_t before = sides.copied();
  sides.motion.to_host(list);
  CHECK(sides.copied() - before == list.size() * (sizeof(std::uint32_t) + 6 * sizeof(double)));
  for (std::uint32_t slot = 0; slot < slots; ++slot) {
    const bool is_listed = std::find(list.begin(), list.end(), slot) != list.end();
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(std::isnan(sides.position.at(slot)[c]) != is_listed);
      CHECK(std::isnan(sides.velocity.at(slot)[c]) != is_listed);
    }
  }
  sides.change_on_host(190, {5, 5, 5}, {0, 0, 0});  // which fetching it again must not undo
  before = sides.copied();
  sides.motion.to_host(list);
  CHECK(sides.copied() == before);
  CHECK(sides.is_true_on_host(190));
  sides.motion.changed_on_host(std::vector<std::uint32_t>{190, 190});
  sides.motion.to_device();
  CHECK(sides.copied() - before == sizeof(std::uint32_t) + 6 * sizeof(double));
  sides.motion.to_host();
  before = sides.copied();
  sides.motion.to_host();
  sides.motion.to_host(list);
  sides.motion.to_device();
  CHECK(sides.copied() == before);
}
