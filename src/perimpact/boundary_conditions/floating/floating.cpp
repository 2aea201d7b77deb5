#include "perimpact/boundary_conditions/floating/floating.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.hpp"

namespace perimpact {

namespace {

using fccda::byte_lanes;
using Pack = fccda::NativePack;

Hydrostatics lift_eight(const WaterView& body, std::size_t eight, bool with_squares) {
  double lift[byte_lanes], potential[byte_lanes], squared = 0;
  for (std::size_t lane = 0; lane < byte_lanes; lane += fccda::lanes<Pack>) {
    const HydrostaticsOfPack<Pack> of = lift_pack<Pack>(body, eight * byte_lanes + lane);
    fccda::store(lift + lane, of.lift), fccda::store(potential + lane, of.potential);
  }
  if (with_squares)
    for (const double force : lift) squared += force * force;
  return {sum_of_lanes(lift), sum_of_lanes(potential), squared};
}

/// Indices in a list of those values that it contains; both ascending.
std::vector<std::uint32_t> indices_in(std::span<const std::uint32_t> list, std::span<const std::uint32_t> values) {
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t value : values)
    if (const auto found = std::ranges::lower_bound(list, value); found != list.end() && *found == value)
      indices.push_back(static_cast<std::uint32_t>(found - list.begin()));
  return indices;
}

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

Floating::Floating(const Particles& particles, std::vector<std::uint32_t> slots, const Water& water, double floats_at)
    : slots_(std::move(slots)),
      eights_(slots_),
      water_(water),
      floats_at_(floats_at),
      exposed_(eights_.count(), 0),
      in_contact_(eights_.count(), 0),
      forces_(resists() ? eights_.places() : 0) {
  for (std::vector<std::uint8_t>& along : moves_) along.assign(eights_.lanes().begin(), eights_.lanes().end());
  if (!particles.lattice())
    for (std::size_t slot = 0; slot < particles.slots(); ++slot) heights_.push_back(particles.size_of(slot));
  if (water_.entrained_depth != 0 || water_.dry_top != 0) columns_.emplace(particles, eights_);
  if (water_.entrained_depth != 0)
    wetness_.assign(columns_->count(), 0), carriers_.assign(columns_->layers().begin(), columns_->layers().end()), intact_.assign(eights_.places(), 1);
  if (water_.dry_top == 0) return;
  is_dry_.assign(eights_.places(), 0);
  for (std::size_t c = 0; c < columns_->count(); ++c)
    if (columns_->top(c) != WaterColumns::none) is_dry_[columns_->top(c)] = 1;
}

WaterView Floating::view(Particles& particles) {
  const auto or_null = [](auto& numbers) { return numbers.empty() ? nullptr : numbers.data(); };
  return {particles.view(),
          eights_.view(),
          columns_ ? columns_->view() : ColumnsView{},
          particles.force_density.writable_pointers(),
          {moves_[0].data(), moves_[1].data(), moves_[2].data()},
          exposed_.data(),
          in_contact_.data(),
          or_null(is_dry_),
          or_null(intact_),
          or_null(wetness_),
          or_null(carriers_),
          forces_.view(),
          or_null(heights_),
          particles.spacing(),
          particles.density(),
          particles.material_density() * water_.gravity,
          water_};
}

void Floating::leave_out(std::span<const std::uint32_t> constrained, std::size_t axis) {
  for (std::size_t k = 0; k < slots_.size(); ++k)
    if (std::binary_search(constrained.begin(), constrained.end(), slots_[k])) {
      if (axis == 2 && !carriers_.empty() && moves(k, axis)) carriers_[columns_->column_of(slots_[k])] -= 1;
      std::uint8_t& bits = moves_[axis][eights_.place(k) / byte_lanes];
      bits = static_cast<std::uint8_t>(bits & ~(1u << slots_[k] % byte_lanes));
    }
}

void Floating::exclude_from_added_mass(std::span<const std::uint32_t> in_contact) {
  if (!water_.adds_mass()) return;
  const auto mark_all = [&](bool carries) {
    for (const std::size_t k : listed_in_contact_) {
      std::uint8_t& marks = in_contact_[eights_.place(k) / byte_lanes];
      marks = static_cast<std::uint8_t>(marks ^ 1u << slots_[k] % byte_lanes);
      if (!carriers_.empty() && moves(k, 2)) carriers_[columns_->column_of(slots_[k])] += carries ? 1 : -1;
    }
  };
  std::vector<std::uint32_t> now = indices_in(slots_, in_contact);
  contact_has_changed_ = now != listed_in_contact_;
  mark_all(true);
  listed_in_contact_ = std::move(now);
  mark_all(false);
}

void Floating::update_exposed_surface(const Particles& particles, const Family& family, std::span<const std::uint32_t> broken_ends) {
  const SurfaceChange change = update_surface(particles, family, broken_ends);
  if (!has_dry_top()) return;
  flood(change.tops, particles);
  flood_deep_columns(particles);
}

Floating::SurfaceChange Floating::update_surface(const Particles& particles, const Family& family, std::span<const std::uint32_t> broken_ends) {
  SurfaceChange change;
  if (water_.drag == 0 && !columns_) return change;
  const bool entrains = water_.entrained_depth != 0;
  std::vector<std::uint32_t> damaged;  // by their numbers in the list
  if (!exposure_) {
    exposure_.emplace(particles, family, broken_ends);
    std::ranges::fill(exposed_, 0), std::ranges::fill(intact_, 1.0);
    for (std::size_t k = 0; k < slots_.size(); ++k) {
      if (exposure_->is_exposed(slots_[k])) expose(k);
      if (exposure_->has_lost(slots_[k])) damaged.push_back(static_cast<std::uint32_t>(k));
    }
    for (std::uint32_t eight = 0; entrains && eight < eights_.count(); ++eight) change.eights.push_back(eight);
    change.is_exposed = true;
  } else {
    const Exposure::Change broken = exposure_->update(family, broken_ends);
    damaged = indices_in(slots_, broken.first_lost);
    if (entrains) change.eights = indices_in(eights_.numbers(), broken.eights);
    for (const std::size_t k : damaged) expose(k);
    change.is_exposed = !damaged.empty();
  }
  update_intact_share(family, change.eights);
  if (has_dry_top())
    for (const std::size_t k : damaged)
      if (const std::uint32_t top = columns_->top(columns_->column_of(slots_[k])); top != WaterColumns::none && is_dry_[top] != 0) change.tops.push_back(top);
  return change;
}

void Floating::expose(std::size_t k) {
  std::uint8_t& exposed = exposed_[eights_.place(k) / byte_lanes];
  exposed = static_cast<std::uint8_t>(exposed | 1u << slots_[k] % byte_lanes);
}

/// `changed`: eights of the list
void Floating::update_intact_share(const Family& family, std::span<const std::uint32_t> changed) {
  fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>(changed.size()), [&](std::ptrdiff_t number) {
    const std::size_t eight = changed[static_cast<std::size_t>(number)], first = std::size_t{eights_.numbers()[eight]} * byte_lanes;
    fccda::for_each_bit(eights_.lanes()[eight], [&](std::size_t lane) {
      if (exposure_->has_lost(first + lane)) intact_[eight * byte_lanes + lane] = 1 - family.damage(first + lane);
    });
  });
}

void Floating::flood(std::span<const std::uint32_t> tops, const Particles& particles) {
  fccda::ExactSums<double> loss;  // [J]
  for (const std::uint32_t top : tops) loss.add(flood_top(top, particles));
  record_flooding(value_of_all(particles.share().ranks(), loss));
}

double Floating::flood_top(std::uint32_t top, const Particles& particles) {
  if (is_dry_[top] == 0) return 0;
  is_dry_[top] = 0;
  const std::size_t slot = eights_.view().slot(top);
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
    if (top == WaterColumns::none || is_dry_[top] == 0) return 0.0;
    const std::size_t slot = eights_.view().slot(top);
    return water_.floods(particles.position.at(slot).z, particles.size_of(slot)) ? flood_top(top, particles) : 0.0;
  }));
}

Hydrostatics Floating::lift(Particles& particles, bool with_squares) {
  const WaterView body = view(particles);
  const Hydrostatics sum =
      exact_sum_of_eights(particles.share().ranks(), eights_.count(), [&](std::size_t eight) { return lift_eight(body, eight, with_squares); });
  record(sum);
  return sum;
}

ForceSum Floating::static_hydrostatics(Particles& particles) {
  const Hydrostatics sum = lift(particles, true);
  return {{0, 0, sum.lift}, sum.squared};
}

void Floating::apply_hydrostatics(Particles& particles) { lift(particles, false); }

void Floating::record(const Hydrostatics& sum) {
  lift_z_ = sum.lift;
  if (has_begun_) {
    account.add({}, potential_ - sum.potential);
    weight_buoyancy_work_ += potential_ - sum.potential;
  }
  potential_ = sum.potential, has_begun_ = true;
}

Vec3d Floating::resist(Particles& particles, double dt) {
  if (!resists()) return {};
  const WaterView body = view(particles);
  if (body.wetness)
    fccda::parallel_for(static_cast<std::ptrdiff_t>(columns_->count() / fccda::lanes<Pack>),
                        [&](std::ptrdiff_t pack) { wet_pack<Pack>(body, static_cast<std::size_t>(pack) * fccda::lanes<Pack>); });
  return record(exact_sum_of_eights(particles.share().ranks(), eights_.count(), [&](std::size_t eight) {
    return resistance_of_eight<Pack>(eight, [&](std::size_t place) { return resist_pack<Pack>(body, place, dt); });
  }));
}

Vec3d Floating::record(const Resistance& sum) {
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
