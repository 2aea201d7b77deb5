#include "base/pack.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

using namespace fccda;

namespace {
constexpr std::size_t width = lanes<NativePack>;
using Lanes = std::array<double, width>;

Lanes unpack(NativePack pack) {
  Lanes out;
  store(out.data(), pack);
  return out;
}
}  // namespace

TEST_CASE("pack: the inverse square root is accurate to two units in the last place over sixty orders of magnitude") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-30, 30);
  for (int trial = 0; trial < 20'000; ++trial) {
    Lanes a;
    for (double& value : a) value = std::pow(10.0, exponent(random));
    const Lanes q = unpack(inverse_square_root(load<NativePack>(a.data())));
    for (std::size_t l = 0; l < width; ++l) {
      const long double exact = 1 / std::sqrt(static_cast<long double>(a[l]));
      // the series' remainder (35/128) e⁴ with e <= 2⁻¹³ is 2⁻⁵⁴; each rounding adds half a unit of 2⁻⁵²
      CHECK(std::fabs(static_cast<double>((q[l] - exact) / exact)) <= 2 * 2.22e-16);
    }
  }
}

TEST_CASE("pack: bits select their lanes, even if the others are not-a-number") {
  for (unsigned bits = 0; bits < (1u << width); ++bits) {
    Lanes a;
    for (std::size_t l = 0; l < width; ++l) a[l] = (bits >> l) & 1u ? 3.5 + static_cast<double>(l) : std::nan("");
    const Lanes kept = unpack(select(bits, load<NativePack>(a.data())));
    for (std::size_t l = 0; l < width; ++l) CHECK(kept[l] == ((bits >> l) & 1u ? a[l] : 0.0));
    CHECK(bits_where_greater(load<NativePack>(kept.data()), NativePack(0.0)) == bits);
  }
}

TEST_CASE("pack: rows of four gathered by their indices are their components, lane by lane") {
  std::array<double, 4 * 32> rows;
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = 0.5 + static_cast<double>(k * k);
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    std::array<std::int32_t, width> index;
    for (std::int32_t& each : index) each = static_cast<std::int32_t>(random() % 32);
    const std::array<NativePack, 4> gathered = gather_rows<NativePack>(rows.data(), index.data());
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t l = 0; l < width; ++l) CHECK(unpack(gathered[c])[l] == rows[4 * static_cast<std::size_t>(index[l]) + c]);
  }
}

TEST_CASE("pack: a byte of eight lanes splits into the bits of each pack") {
  for (unsigned byte = 0; byte < 256; ++byte) {
    unsigned joined = 0;
    for (std::size_t first = 0; first < byte_lanes; first += width) joined |= pack_bits<NativePack>(byte, first) << first;
    CHECK(joined == byte);
  }
}
