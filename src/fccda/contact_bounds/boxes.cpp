#include "fccda/contact_bounds/boxes.hpp"

#include <vector>

namespace fccda {

namespace {

/// Sweeps along `axis` from one box end to the next: between two, the set of intersected boxes is constant.
double measure(const std::vector<const Box*>& boxes, std::size_t axis) {
  std::vector<double> ends;
  for (const Box* box : boxes) ends.push_back(box->low[axis]), ends.push_back(box->high[axis]);
  std::sort(ends.begin(), ends.end());
  double sum = 0;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double low = ends[k], high = ends[k + 1];
    if (!(high > low)) continue;
    std::vector<const Box*> met;
    for (const Box* box : boxes)
      if (box->low[axis] <= low && box->high[axis] >= high) met.push_back(box);
    if (met.empty()) continue;
    sum += (high - low) * (axis == 2 ? 1.0 : measure(met, axis + 1));
  }
  return sum;
}

}  // namespace

double volume_of(std::span<const Box> boxes) {
  std::vector<const Box*> all;
  for (const Box& box : boxes) all.push_back(&box);
  return measure(all, 0);
}

}  // namespace fccda
