#include "fccda/rigid_body/prescribed_motion.hpp"

#include <algorithm>

namespace fccda {

bool PrescribedMotion::is_empty() const {
  return std::none_of(tables_.begin(), tables_.end(), [](const auto& table) { return table.has_value(); });
}

double PrescribedMotion::velocity_at(std::size_t degree, double time, double given) const {
  return tables_[degree] ? tables_[degree]->velocity(time, time) : given;
}

double PrescribedMotion::largest_velocity(std::size_t degree, double given) const { return tables_[degree] ? tables_[degree]->largest_velocity() : given; }

void PrescribedMotion::impose(RigidBody& body, const Step& step) const {
  for (std::size_t degree = 0; degree < tables_.size(); ++degree)
    if (tables_[degree]) body.drive(degree, tables_[degree]->velocity(step.t0, step.t1));
}

}  // namespace fccda
