#include "fccda/respond/gauge.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/no_such_part.hpp"

namespace fccda {

Gauge::Gauge(const Mounting& mounting, const Surface& surface) : point_(mounting.point), axis_(mounting.axis) {
  if (mounting.parts.empty()) return;
  const auto known = surface.part_names();
  std::vector<bool> feels_part(known.size(), false);
  for (const std::string& part : mounting.parts) {
    if (std::find(known.begin(), known.end(), part) == known.end()) throw InputError(no_such_part(part, known));
    for (std::size_t k = 0; k < known.size(); ++k)
      if (known[k] == part) feels_part[k] = true;
  }
  for (std::size_t p = 0; p < surface.panels().panels.size(); ++p)
    feels_panel_.push_back(feels_part[static_cast<std::size_t>(surface.part_of_panel(static_cast<int>(p)))]);
}

void Gauge::add(const Contact& contact, const Vec3d& position, const Vec3d& impulse, const Motion& motion) {
  if (!feels(contact.panel)) return;
  const Vec3d moment = cross(position - motion.t1.to_world(point_), impulse);
  reading_.impulse += impulse;
  reading_.angular_impulse += moment;
  if (axis_) reading_.about_axis += dot(motion.t1.turn_to_world(*axis_), moment);
}

}  // namespace fccda
