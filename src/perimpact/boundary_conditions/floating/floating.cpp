#include "perimpact/boundary_conditions/floating/floating.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace perimpact {

namespace {

struct Hydrostatics {
  ForceSum forces{};
  double potential = 0;  // [J]
  Hydrostatics& operator+=(const Hydrostatics& other) {
    forces += other.forces, potential += other.potential;
    return *this;
  }
};

}  // namespace

std::optional<double> floating_level(const Particles& particles, std::span<const std::uint32_t> slots, const Water& water) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const std::uint32_t slot : slots) {
    const double z = particles.position.at(slot).z, half = 0.5 * particles.size_of(slot);
    low = std::min(low, z - half), high = std::max(high, z + half);
  }
  Ranks& ranks = particles.share().ranks();
  low = ranks.min(low), high = ranks.max(high);
  const double volume = exact_sum_over_eights(ranks, slots, [&](std::size_t k) { return particles.volume(slots[k]); }),
               mass = particles.material_density() * volume;
  if (mass > water.density * volume) return std::nullopt;
  Water trial = water;
  for (int halvings = 0; halvings < 100 && high - low > 1e-15 * (std::fabs(high) + std::fabs(low)); ++halvings) {
    trial.level = 0.5 * (low + high);
    const double displaced = exact_sum_over_eights(ranks, slots, [&](std::size_t k) {
      return particles.volume(slots[k]) * trial.submerged(particles.position.at(slots[k]).z, particles.size_of(slots[k]));
    });
    (water.density * displaced < mass ? low : high) = trial.level;
  }
  return 0.5 * (low + high);
}

Floating::Floating(std::vector<std::uint32_t> slots, const Water& water, double floats_at, std::optional<WaterColumns> columns)
    : slots_(std::move(slots)),
      moves_(slots_.size(), {true, true, true}),
      water_(water),
      floats_at_(floats_at),
      columns_(std::move(columns)),
      forces_(resists() ? slots_.size() : 0) {
  if (water_.entrained_depth != 0) wetness_.assign(columns_->count(), 0), intact_.assign(slots_.size(), 1);
  if (water_.dry_top == 0) return;
  dry_tops_.assign(slots_.size(), 0);
  for (std::size_t c = 0; c < columns_->count(); ++c)
    if (columns_->top(c) != WaterColumns::none) dry_tops_[columns_->top(c)] = 1;
}

void Floating::leave_out(std::span<const std::uint32_t> constrained, std::size_t axis) {
  for (std::size_t k = 0; k < slots_.size(); ++k)
    if (std::binary_search(constrained.begin(), constrained.end(), slots_[k])) moves_[k][axis] = false;
}

void Floating::update_exposed_surface(const Particles& particles, const Family& family, std::span<const std::uint32_t> broken_ends) {
  if (water_.drag == 0 && !columns_) return;
  const bool is_first = !exposure_;
  std::vector<std::uint32_t> newly_damaged;
  if (is_first)
    exposure_.emplace(particles, family, broken_ends);
  else
    newly_damaged = exposure_->update(family, broken_ends);
  if (water_.entrained_depth != 0) update_intact_share(family, broken_ends);
  if (!has_dry_top()) return;
  fccda::ExactSums<double> loss;  // [J]
  if (is_first) {
    for (std::size_t k = 0; k < slots_.size(); ++k)
      if (exposure_->has_lost(slots_[k])) loss.add(flood(columns_->column_of(k), particles));
  } else {
    for (const std::uint32_t slot : newly_damaged) {
      const auto found = std::lower_bound(slots_.begin(), slots_.end(), slot);
      if (found != slots_.end() && *found == slot) loss.add(flood(columns_->column_of(static_cast<std::size_t>(found - slots_.begin())), particles));
    }
  }
  record_flooding(value_of_all(particles.share().ranks(), loss));
  flood_deep_columns(particles);
}

void Floating::update_intact_share(const Family& family, std::span<const std::uint32_t> broken_ends) {
  const bool is_first = broken_ends_.empty();
  if (is_first) broken_ends_.assign(broken_ends.begin(), broken_ends.end());
  std::vector<std::uint8_t> has_changed(broken_ends.size(), is_first ? 1 : 0);
  bool any = is_first;
  for (std::size_t eight = 0; eight < broken_ends.size(); ++eight)
    if (broken_ends[eight] != broken_ends_[eight]) has_changed[eight] = 1, broken_ends_[eight] = broken_ends[eight], any = true;
  if (!any) return;
  for_each_block(slots_.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k)
      if (has_changed[slots_[k] / fccda::byte_lanes] != 0 && exposure_->has_lost(slots_[k])) intact_[k] = 1 - family.damage(slots_[k]);
  });
}

double Floating::flood(std::size_t column, const Particles& particles) {
  const std::uint32_t top = columns_->top(column);
  if (top == WaterColumns::none || dry_tops_[top] == 0) return 0;
  dry_tops_[top] = 0;
  const std::size_t slot = slots_[top];
  const double height = particles.size_of(slot), above = std::max(water_.immersion(particles.position.at(slot).z, height) - 1, 0.0);
  return 0.5 * water_.density * water_.gravity * particles.volume(slot) * height * above * above;
}

void Floating::record_flooding(double loss) {
  if (!has_begun_) return;
  potential_ -= loss;
  flooding_dissipation_ += loss;
}

void Floating::flood_deep_columns(const Particles& particles) {
  if (!has_dry_top()) return;
  const auto each_column = [](std::size_t c) { return c; };  // the particles of a column are in several eights
  record_flooding(exact_sum_over_eights(particles.share().ranks(), columns_->count(), each_column, [&](std::size_t c) {
    const std::uint32_t top = columns_->top(c);
    if (top == WaterColumns::none || dry_tops_[top] == 0) return 0.0;
    const double depth = water_.level - particles.position.at(slots_[top]).z - 0.5 * particles.size_of(slots_[top]);
    return depth > water_.dry_top ? flood(c, particles) : 0.0;
  }));
}

ForceSum Floating::static_hydrostatics(Particles& particles) {
  const double weight = particles.material_density() * water_.gravity, lift = water_.density * water_.gravity;  // [N/m³]
  const Hydrostatics sum = exact_sum_over_eights(particles.share().ranks(), slots_, [&](std::size_t k) {
    const std::size_t slot = slots_[k];
    const double z = particles.position.at(slot).z, height = particles.size_of(slot), volume = particles.volume(slot);
    const bool is_dry = has_dry_top() && dry_tops_[k] != 0;
    const double t = water_.immersion(z, height);
    const double column = t <= 0 ? 0 : is_dry || t < 1 ? 0.5 * t * t : t - 0.5;  // ∫ S dz/Δ from the particle upward
    Vec3d density = particles.force_density.at(slot);
    const double net = lift * (is_dry ? std::max(t, 0.0) : water_.submerged(z, height)) - weight;
    density.z += net;
    particles.force_density.set(slot, density);
    const double force = volume * net;
    return Hydrostatics{{{0, 0, force}, force * force}, volume * (weight * z + lift * height * column)};
  });
  if (has_begun_) {
    account.add({}, potential_ - sum.potential);
    weight_buoyancy_work_ += potential_ - sum.potential;
  }
  potential_ = sum.potential, has_begun_ = true;
  return sum.forces;
}

void Floating::update_wetness(const Particles& particles) {
  for_each_block(columns_->count(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t c = begin; c < end; ++c) {
      wetness_[c] = 0;
      for (const std::uint32_t k : columns_->particles_of(c))
        wetness_[c] = std::max(wetness_[c], water_.submerged(particles.position.at(slots_[k]).z, particles.size_of(slots_[k])));
    }
  });
}

double Floating::entrained(std::size_t k, double height, double wet) const {
  if (water_.entrained_depth == 0) return water_.added_mass * water_.density * wet;
  const std::size_t column = columns_->column_of(k);
  const double layers = static_cast<double>(columns_->particles_of(column).size());
  return water_.density * water_.entrained_depth * wetness_[column] * intact_[k] / (layers * height);
}

Vec3d Floating::resist(Particles& particles, double dt) {
  if (!resists()) return {};
  if (water_.entrained_depth != 0) update_wetness(particles);
  const double density = particles.density();
  const Resistance sum = exact_sum_over_eights(particles.share().ranks(), slots_, [&](std::size_t k) {
    const std::size_t slot = slots_[k];
    const Vec3d velocity = particles.velocity.at(slot);
    const bool is_exposed = exposure_ && exposure_->is_exposed(slot);
    if (!is_exposed && water_.damping == 0 && !adds_mass()) return forces_.record_force(k, {}, dt * velocity);  // most particles of a thick body
    const Vec3d before = particles.force_density.at(slot);
    const double height = particles.size_of(slot), wet = water_.submerged(particles.position.at(slot).z, height);
    const bool drags = wet > 0 && is_exposed;
    const double damping =
        water_.damping + (drags ? 0.5 * water_.density * water_.drag * height * height * wet * norm(velocity) / (density * particles.volume(slot)) : 0);
    Vec3d after = before;
    for (std::size_t c = 0; c < 3; ++c)
      if (moves_[k][c]) after[c] = damped(before[c], velocity[c], density, damping, dt);
    if (moves_[k][2]) after.z *= density / (density + entrained(k, height, wet));
    particles.force_density.set(slot, after);
    return forces_.record_force(k, particles.volume(slot) * (after - before), dt * velocity);
  });
  account.add({}, sum.work);
  drag_work_ += sum.work;
  return sum.force;
}

Traffic Floating::collectives_in_step(const FloatingSetup& setup) {
  Traffic traffic = reduction_of_sums<Hydrostatics>();
  if (setup.drag != 0 || setup.damping != 0 || setup.added_mass != 0 || setup.entrained_depth != 0) traffic += reduction_of_sums<Resistance>();
  if (setup.dry_top != 0)
    for (int flooded = 0; flooded < 2; ++flooded) traffic += reduction_of_sums<double>();  // with lost bonds, and by depth
  return traffic;
}

}  // namespace perimpact
