#include "perimpact/device/eights_in_transit.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "perimpact/device/emulated_device.hpp"

using namespace perimpact;
using namespace perimpact::device;

namespace {

constexpr std::size_t slots = 160, eights = slots / fccda::byte_lanes;

/// Arrays of the host with different numbers everywhere, of which a device has copies.
template <std::size_t arrays>
struct Copied {
  std::array<std::vector<double>, arrays> of_host;
  EmulatedDevice device;
  Mirrors mirrors{device};
  EightsInTransit transit{device, mirrors, slots};

  Copied() {
    for (std::size_t a = 0; a < arrays; ++a) {
      of_host[a].resize(slots);
      std::iota(of_host[a].begin(), of_host[a].end(), 1000.0 * static_cast<double>(a));
      mirrors.add(std::span<const double>(of_host[a]));
    }
  }
  std::array<double*, arrays> pointers() {
    std::array<double*, arrays> all;
    for (std::size_t a = 0; a < arrays; ++a) all[a] = of_host[a].data();
    return all;
  }
  void to_device(const std::vector<std::uint32_t>& list) {
    std::array<const double*, arrays> all;
    for (std::size_t a = 0; a < arrays; ++a) all[a] = of_host[a].data();
    transit.to_device(list, all);
  }
  std::vector<double> on_device(std::size_t a) {
    std::vector<double> numbers(slots);
    device.download(numbers.data(), mirrors.at(of_host[a].data()), slots * sizeof(double));
    return numbers;
  }
};

std::vector<std::uint32_t> list_of(std::size_t count) {
  std::vector<std::uint32_t> list;
  for (std::uint32_t n = 0; n < count; ++n) list.push_back(n * 7 % eights);  // 7 and 20 have no common divisor: each once, in any order
  return list;
}

bool is_listed(const std::vector<std::uint32_t>& list, std::size_t slot) {
  return std::ranges::find(list, static_cast<std::uint32_t>(slot / fccda::byte_lanes)) != list.end();
}

}  // namespace

TEST_CASE("numbers of listed eights travel to the device, and no others, or all of them where most are listed") {
  for (const std::size_t count : {std::size_t{1}, std::size_t{3}, std::size_t{10}, std::size_t{15}}) {
    CAPTURE(count);
    Copied<14> copied;
    const std::vector<std::uint32_t> list = list_of(count);
    const std::array before{copied.on_device(0), copied.on_device(13)};
    for (std::vector<double>& array : copied.of_host)
      for (double& number : array) number = -number - 0.5;
    const std::size_t uploaded = copied.device.copied().uploaded;
    copied.to_device(list);
    const bool all = count > eights / 2;
    CHECK(copied.device.copied().uploaded - uploaded == (all ? 14 * slots * sizeof(double) : count * (sizeof(std::uint32_t) + 14 * 8 * sizeof(double))));
    for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t a = which * 13;
      const std::vector<double> now = copied.on_device(a);
      for (std::size_t slot = 0; slot < slots; ++slot) CHECK(now[slot] == (all || is_listed(list, slot) ? copied.of_host[a][slot] : before[which][slot]));
    }
  }
}

TEST_CASE("numbers of listed eights travel to the host, and no others, where fewer than half are listed") {
  Copied<6> copied;
  for (const std::size_t count : {std::size_t{9}, std::size_t{2}}) {  // the buffers are those of the longer list
    CAPTURE(count);
    const std::vector<std::uint32_t> list = list_of(count);
    for (std::vector<double>& array : copied.of_host) std::ranges::fill(array, -1.0);
    const std::size_t downloaded = copied.device.copied().downloaded;
    copied.transit.to_host(list, copied.pointers());
    CHECK(copied.device.copied().downloaded - downloaded == count * 6 * 8 * sizeof(double));
    for (std::size_t a = 0; a < 6; ++a)
      for (std::size_t slot = 0; slot < slots; ++slot)
        CHECK(copied.of_host[a][slot] == (is_listed(list, slot) ? 1000.0 * static_cast<double>(a) + static_cast<double>(slot) : -1.0));
  }
}

TEST_CASE("without eights in the list nothing travels") {
  Copied<6> copied;
  const EmulatedDevice::Copied before = copied.device.copied();
  copied.transit.to_host({}, copied.pointers());
  CHECK(copied.device.copied().uploaded == before.uploaded);
  CHECK(copied.device.copied().downloaded == before.downloaded);
}
