#include "perimpact/boundary_conditions/actions/user_force.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "perimpact/boundary_conditions/actions/force_sum.hpp"
#include "perimpact/particles/sum_over_eights.hpp"

namespace perimpact {

namespace {

struct UserForceSums {
  Vec3d force{};                            // [N]
  double work = 0;                          // [J]
  double squared = 0;                       // [N m]
  double not_finite = 0, out_of_plane = 0;  // particles; all members are doubles, for exact_sum_over_eights()
  UserForceSums& operator+=(const UserForceSums& other) {
    force += other.force, work += other.work, squared += other.squared, not_finite += other.not_finite, out_of_plane += other.out_of_plane;
    return *this;
  }
};

}  // namespace

UserForce::UserForce(std::string name, const Particles& particles, Function function)
    : name_(std::move(name)),
      slots_(particles.slot_of().begin(), particles.slot_of().end()),
      function_(std::move(function)),
      density_(particles.slots(), 0),
      before_(particles.slots(), 0) {}

void UserForce::apply_load(Particles& particles, const fccda::Step& next) {
  std::swap(density_, before_);
  density_ = VectorArray(particles.slots(), 0);
  function_(next.t0, density_);
  const double dt = next.t0 > 0 ? next.dt : 0;  // [s] of the step before
  const UserForceSums sums = exact_sum_over_eights(particles.share().ranks(), slots_, [&](std::size_t k) {
    const std::size_t slot = slots_[k];
    const Vec3d f = density_.at(slot);
    const double volume = particles.volume(slot);
    particles.force_density.set(slot, particles.force_density.at(slot) + f);
    return UserForceSums{volume * f, 0.5 * volume * dt * dot(before_.at(slot) + f, particles.velocity.at(slot)), volume * squared_norm(f) / particles.density(),
                         is_finite(f) ? 0.0 : 1.0, particles.is_plane() && f.z != 0 ? 1.0 : 0.0};
  });
  if (sums.not_finite > 0)
    throw fccda::RunError(
        fmt::format("At {:.6g} s the user force {} is not finite on {} particles; check the function that computes it.", next.t0, name_, sums.not_finite));
  if (sums.out_of_plane > 0)
    throw fccda::InputError(
        fmt::format("the user force {} acts along z on {} particles, but the body is 2-D; set its z component to 0.", name_, sums.out_of_plane));
  squared_force_per_density_ = sums.squared;
  account.record_force(sums.force, {});
  account.add({}, sums.work);
}

double UserForce::half_kick(double, double dt) const { return 0.125 * dt * dt * squared_force_per_density_; }

}  // namespace perimpact
