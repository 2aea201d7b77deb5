#include "io/report/kept_particles.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "fixtures/larger.hpp"

using namespace perimpact::report;
using fccda::Vec3d;

namespace {

constexpr double spacing = 0.1;
constexpr int edge = 10;  // a cube of 10 x 10 x 10 particles, of which 488 are on the surface

std::vector<Vec3d> cube() {
  std::vector<Vec3d> points;
  for (int k = 0; k < edge; ++k)
    for (int j = 0; j < edge; ++j)
      for (int i = 0; i < edge; ++i) points.push_back({7 + spacing * i, spacing * j, -3 + spacing * k});
  return points;
}

bool on_surface(std::uint32_t number) {
  const int at[] = {static_cast<int>(number) % edge, static_cast<int>(number) / edge % edge, static_cast<int>(number) / (edge * edge)};
  return std::any_of(std::begin(at), std::end(at), [](int cell) { return cell == 0 || cell == edge - 1; });
}

}  // namespace

TEST_CASE("kept particles: a share of 1 keeps all, in order") {
  const std::vector<std::uint32_t> kept = kept_particles(cube(), spacing, std::vector<bool>(1000, false), 1);
  REQUIRE(kept.size() == 1000);
  for (std::uint32_t k = 0; k < 1000; ++k) CHECK(kept[k] == k);
}

TEST_CASE("kept particles: surface and damaged particles are kept, the others are thinned evenly to the share") {
  std::vector<bool> damaged(1000, false);
  damaged[555] = damaged[444] = true;
  REQUIRE_FALSE(on_surface(555));
  const std::vector<std::uint32_t> kept = kept_particles(cube(), spacing, damaged, 0.6);
  CHECK(kept.size() == 600);
  const auto is_kept = [&](std::uint32_t number) { return std::binary_search(kept.begin(), kept.end(), number); };
  int widest = 0, gap = 0;
  for (std::uint32_t number = 0; number < 1000; ++number) {
    if (on_surface(number) || damaged[number]) {
      CHECK(is_kept(number));
    } else if (is_kept(number)) {
      gap = 0;
    } else {
      widest = fixtures::larger(widest, ++gap);
    }
  }
  CHECK(widest == 4);  // 110 of the 510 others are kept: 3 or 4 are dropped between two of them
}

TEST_CASE("kept particles: where the surface alone exceeds the share, it is thinned evenly, and at least one particle remains") {
  const std::vector<std::uint32_t> kept = kept_particles(cube(), spacing, std::vector<bool>(1000, false), 0.244);
  CHECK(kept.size() == 244);
  CHECK(std::all_of(kept.begin(), kept.end(), on_surface));
  CHECK(kept_particles(cube(), spacing, std::vector<bool>(1000, false), 1e-9).size() == 1);
  CHECK(kept_particles({}, spacing, {}, 0.5).empty());
}
