#include "perimpact/self_contact/fast_particles.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace perimpact {

double FastParticles::margin_of(std::uint32_t particle) const {
  const auto found = std::ranges::lower_bound(all_, particle, {}, &Particle::particle);
  return found != all_.end() && found->particle == particle ? found->margin : margin_;
}

void FastParticles::choose_among(std::span<const double> squared_speeds) {
  constexpr std::size_t one_in = 100;
  constexpr double worthwhile = 2, spare = 1.25;  // as many times as fast as others; so much more margin, for those that gain speed
  all_.clear();
  double fastest = 0;  // NaN is never faster
  for (const double speed : squared_speeds) fastest = std::max(fastest, speed);
  // slower ones do not leave their margin before the fastest
  double limit = std::pow(margin_ / most_, 2) * fastest;
  std::vector<double> above;
  std::ranges::copy_if(squared_speeds, std::back_inserter(above), [&](double speed) { return speed > limit; });
  if (const std::size_t count = squared_speeds.size() / one_in; above.size() > count) {
    const auto first_left_out = above.begin() + static_cast<std::ptrdiff_t>(count);
    std::ranges::nth_element(above, first_left_out, std::greater<>());
    limit = *first_left_out;
  }
  if (!(limit * worthwhile * worthwhile < fastest)) return;
  for (std::size_t p = 0; p < squared_speeds.size(); ++p)
    if (squared_speeds[p] > limit) all_.push_back({static_cast<std::uint32_t>(p), std::min(most_, spare * std::sqrt(squared_speeds[p] / limit) * margin_)});
}

}  // namespace perimpact
