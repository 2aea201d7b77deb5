/// Cost of the submerged volume of a surface: one CSV row per number of panels and water level on standard output.
///
/// A heeled sphere of 2 m, with the level through its centre, near its lowest point, and just below its highest. Process time on one thread, the
/// minimum of several rounds.

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "base/parallel.hpp"
#include "mesh/shapes/sphere.hpp"
#include "mesh/submerged.hpp"

int main() {
  using namespace fccda;
  use_threads(1);
  fmt::print("panels,depth [m],ns a panel,ms\n");
  for (const double panel : {0.1, 0.03, 0.013}) {
    const Surface ball(make_sphere({.diameter = 2, .edge_length = panel}));
    const auto panels = static_cast<double>(ball.triangles().size());
    for (const double depth : {0.1, 1.1, 1.9}) {
      double least = 1e300, volume = 0;
      const int asks = std::max(1, static_cast<int>(1e6 / panels));
      for (int round = 0; round < 9; ++round) {
        const std::clock_t begin = std::clock();
        for (int ask = 0; ask < asks; ++ask) volume += submerged(ball, {.up = {0.6, 0, 0.8}, .height = depth - 1 + 1e-6 * ask}).volume;
        least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / asks);
      }
      if (!(volume > 0)) return 1;  // keeps the result in use
      fmt::print("{},{},{:.1f},{:.3f}\n", panels, depth, 1e9 * least / panels, 1e3 * least);
    }
  }
}
