#include "fccda/contact_bounds/fit_contact_bounds.hpp"

#include <array>
#include <iomanip>
#include <sstream>

#include "fccda/contact_bounds/boxes.hpp"
#include "fccda/contact_bounds/fit_boxes.hpp"
#include "fccda/contact_bounds/fit_sectors.hpp"

namespace fccda {

namespace {

// Measured in nanoseconds, see fit_contact_bounds.hpp: including the distance that follows the test. Only their ratios matter.
constexpr double query_of_surface = 1000;
constexpr double test_of_box = 3;
constexpr double test_of_fan = 35;

}  // namespace

FittedBounds fit_contact_bounds(const Surface& surface) {
  const double whole = volume_of(surface.report().bounds);
  const auto filled = [&](double volume) { return whole > 0 ? volume / whole : 1; };

  const std::vector<Box> one = fit_boxes(surface, {.most = 1});
  const std::vector<Box> several = fit_boxes(surface, {.gain = test_of_box / query_of_surface});
  const CylinderSectors fan(fit_sectors(surface, {}), surface, Beyond::error);
  const double of_several = filled(volume_of(several)), of_fan = filled(fan.volume());
  const double cost_of_one = test_of_box + query_of_surface;
  const double cost_of_several = test_of_box * static_cast<double>(several.size()) + of_several * query_of_surface;
  const double cost_of_fan = test_of_fan + of_fan * query_of_surface;

  std::ostringstream choice;
  choice << std::fixed << std::setprecision(0) << "of the bounding box, " << several.size() << (several.size() == 1 ? " box fills " : " boxes fill ")
         << 100 * of_several << " % and a cylinder with sectors " << 100 * of_fan << " %; chosen: ";
  if (cost_of_fan < cost_of_several && cost_of_fan < cost_of_one) return {fan, choice.str() + "the cylinder with sectors"};
  if (several.size() == 1 || cost_of_one <= cost_of_several) return {BoxUnion(one), choice.str() + "the bounding box"};
  return {BoxUnion(several), choice.str() + "the boxes"};
}

}  // namespace fccda
