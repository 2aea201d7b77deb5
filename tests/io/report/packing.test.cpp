#include "io/report/packing.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "fixtures/tolerance.hpp"
#include "mesh_io/file/inflate.hpp"

using namespace perimpact::report;

namespace {

/// The inverse of ArrayPacker from its definition, in wide integers that cannot overflow.
std::vector<std::uint32_t> unpacked(const std::string& bytes, std::size_t count, int width, const std::vector<std::vector<std::uint32_t>>& before) {
  REQUIRE(bytes.size() == 1 + count * static_cast<std::size_t>(width));
  const int prediction = bytes[0];
  const std::int64_t modulus = std::int64_t{1} << (8 * width);
  std::vector<std::uint32_t> out;
  std::int64_t off = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::int64_t folded = 0;
    for (int plane = width - 1; plane >= 0; --plane) folded = 256 * folded + static_cast<unsigned char>(bytes[1 + static_cast<std::size_t>(plane) * count + i]);
    const std::int64_t left = folded % 2 == 0 ? folded / 2 : -(folded + 1) / 2;
    off = prediction >= 3 ? off + left : left;
    const std::size_t frames = before.size();
    std::int64_t predicted = 0;
    if (prediction % 3 == 1) predicted = before[frames - 1][i];
    if (prediction % 3 == 2) predicted = 2 * std::int64_t{before[frames - 1][i]} - std::int64_t{before[frames - 2][i]};
    out.push_back(static_cast<std::uint32_t>(((predicted + off) % modulus + modulus) % modulus));
  }
  return out;
}

}  // namespace

TEST_CASE("packing: numbers of any size, with wrap-around, are decoded in every frame") {
  std::mt19937 chance(11);
  for (const int width : {1, 2, 4}) {
    CAPTURE(width);
    const std::uint32_t highest = width == 4 ? 0xffffffffU : (1U << (8 * width)) - 1;
    std::uniform_int_distribution<std::uint32_t> any(0, highest);
    ArrayPacker packer(width);
    std::vector<std::vector<std::uint32_t>> before;
    for (int frame = 0; frame < 6; ++frame) {
      std::vector<std::uint32_t> numbers(257);
      for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = frame % 2 == 0 ? any(chance) : frame == 1 ? (i % 2 == 0 ? 0 : highest) : (before.back()[i] + 3) & highest;
      std::string bytes;
      packer.append(numbers, bytes);
      CHECK(unpacked(bytes, numbers.size(), width, before) == numbers);
      before.push_back(numbers);
    }
  }
}

TEST_CASE("packing: each prediction is selected where its residuals vanish") {
  const std::size_t count = 500;
  std::mt19937 chance(12);
  std::vector<std::uint32_t> random(count), ramp(count), speed(count), constant(count, 7);
  for (std::size_t i = 0; i < count; ++i) random[i] = chance() & 0xffff, ramp[i] = static_cast<std::uint32_t>(40 * i), speed[i] = chance() & 0xff;
  const auto plus = [](std::vector<std::uint32_t> a, const std::vector<std::uint32_t>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = (a[i] + b[i]) & 0xffff;
    return a;
  };
  const auto choice = [](const std::vector<std::vector<std::uint32_t>>& frames) {
    ArrayPacker packer(2);
    std::string bytes;
    for (const auto& frame : frames) bytes.clear(), packer.append(frame, bytes);
    return static_cast<int>(bytes[0]);
  };
  CHECK(choice({constant}) == 0);
  CHECK(choice({random, random}) == 1);                                                 // nothing moves
  CHECK(choice({random, plus(random, speed), plus(plus(random, speed), speed)}) == 2);  // each at a different constant velocity
  CHECK(choice({ramp}) == 3);
  CHECK(choice({random, plus(random, ramp)}) == 4);  // displacement grows along the array
}

TEST_CASE("packing: reals are recovered within half a step, and the range is preserved") {
  std::mt19937 chance(13);
  std::uniform_real_distribution<double> any(-3.5, 12.25);
  const Scale scale(-3.5, 12.25, 4095);
  CHECK(scale.step() == fixtures::relative(15.75 / 4095, 1e-15));
  for (int k = 0; k < 1000; ++k) {
    const double value = any(chance);
    CHECK(std::fabs(scale.low() + scale.step() * scale.number_of(value) - value) <= scale.step() / 2 * (1 + 1e-9));  // rounding of the sum
  }
  CHECK(scale.number_of(-3.5) == 0);
  CHECK(scale.number_of(12.25) == 4095);
  CHECK(scale.number_of(1e300) == 4095);  // never out of range
  const Scale flat(2, 2, 65535);
  CHECK(flat.step() == 0);
  CHECK(flat.number_of(2) == 0);
}

TEST_CASE("packing: gzip output is decompressed by gunzip, and deterministic") {
  std::mt19937 chance(14);
  for (const std::size_t size : {1U, 100U, 70'000U}) {
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(chance() & 15);
    CHECK(fccda::gunzip(gzip(bytes), "test") == bytes);
    CHECK(gzip(bytes) == gzip(bytes));
  }
}

TEST_CASE("packing: base64 reproduces the examples of RFC 4648, section 10") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\xfb") == "//77");
}
