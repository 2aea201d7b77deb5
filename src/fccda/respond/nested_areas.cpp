#include "fccda/respond/nested_areas.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <tuple>

#include "base/contract.hpp"

namespace fccda {

namespace {

/// All nested areas, in order of growth.
std::vector<NestedArea> all_of(const PanelFaces& faces, std::span<const double> pressure) {
  const auto most = static_cast<std::size_t>(std::max_element(pressure.begin(), pressure.end()) - pressure.begin());
  using Candidate = std::tuple<double, double, int>;  // pressure, -distance, -panel; the largest is added next
  std::priority_queue<Candidate> candidates;
  std::vector<bool> known(faces.size(), false);
  const auto add = [&](std::size_t panel) {
    if (known[panel]) return;
    known[panel] = true;
    candidates.emplace(std::max(0.0, pressure[panel]), -norm(faces[panel].middle - faces[most].middle), -static_cast<int>(panel));
  };
  std::vector<NestedArea> nested;
  std::size_t to_last_loaded = 0;
  double area = 0, force = 0;
  for (add(most); !candidates.empty();) {
    const auto panel = static_cast<std::size_t>(-std::get<int>(candidates.top()));
    candidates.pop();
    area += faces[panel].area;
    force += pressure[panel] * faces[panel].area;
    nested.push_back({area, force / area});
    if (pressure[panel] > 0) to_last_loaded = nested.size();
    for (const int next : faces.neighbours(panel)) add(static_cast<std::size_t>(next));
  }
  nested.resize(to_last_loaded);
  return nested;
}

}  // namespace

std::vector<NestedArea> nested_areas(const PanelFaces& faces, std::span<const double> pressure, std::size_t count) {
  EXPECTS(pressure.size() == faces.size() && count >= 2);
  if (std::none_of(pressure.begin(), pressure.end(), [](double p) { return p > 0; })) return {};
  const std::vector<NestedArea> all = all_of(faces, pressure);
  const double first = all.front().area, ratio = all.back().area / first;
  std::vector<NestedArea> chosen;
  std::size_t next = 0;
  for (std::size_t k = 0; k < count && next < all.size(); ++k) {
    const double wanted = k + 1 == count ? all.back().area : first * std::pow(ratio, static_cast<double>(k) / static_cast<double>(count - 1));
    while (next < all.size() && all[next].area < wanted) ++next;
    if (next == all.size()) break;
    chosen.push_back(all[next++]);
  }
  return chosen;
}

}  // namespace fccda
