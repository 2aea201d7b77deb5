#include "perimpact/device/boundary_conditions_on_device.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "perimpact/device/body_passes.hpp"
#include "perimpact/device/kernels.hpp"
#include "perimpact/particles/advance.hpp"

namespace perimpact {

using fccda::byte_lanes;

namespace device {

namespace {

template <class Action>
constexpr bool owns_eights = std::is_same_v<Action, Floating> || std::is_same_v<Action, Absorbing>;
/// The others, such as user forces, run on the host.
template <class Action>
constexpr bool has_kernels = owns_eights<Action> || std::is_same_v<Action, Load> || std::is_same_v<Action, PrescribedDisplacement>;

/// Quantities that a boundary condition sums in each step.
template <class Action>
constexpr std::size_t quantities_of(const Action& action) {
  if constexpr (std::is_same_v<Action, Floating>)
    return 2 + (action.resists() ? 4 : 0);
  else if constexpr (std::is_same_v<Action, Absorbing>)
    return 4;
  else
    return has_kernels<Action> ? 3 : 0;
}

/// Sorted numbers of the travel blocks of listed eights, and the first eight of each.
struct Blocks {
  std::vector<std::uint32_t> numbers, begin;
};

Blocks blocks_of(const ListedEights& eights) {
  Blocks blocks;
  for (std::uint32_t e = 0; e < eights.count(); ++e)
    if (const auto block = static_cast<std::uint32_t>(eights.numbers()[e] * byte_lanes / travel_block);
        blocks.numbers.empty() || blocks.numbers.back() != block)
      blocks.numbers.push_back(block), blocks.begin.push_back(e);
  blocks.begin.push_back(static_cast<std::uint32_t>(eights.count()));
  return blocks;
}

}  // namespace

/// Arrays of a load or a prescribed displacement in device memory.
struct ListedArrays {
  DeviceArray<std::uint32_t> numbers, begin;
  DeviceArray<std::uint8_t> lanes;
  std::array<DeviceArray<double>, 3> reference;
  DeviceArray<double> weights;  // of a load
  std::vector<std::uint32_t> blocks;
};

/// A boundary condition on the device.
struct Part {
  std::size_t eights = 0;                 // listed
  std::size_t first = 0;                  // of its sums among those of all
  ListedArrays listed;                    // of a load or a prescribed displacement
  bool is_outdated = false;               // latest forces on the host
  std::optional<EightsInTransit> intact;  // shares of intact bonds of floating bodies
};

class BoundaryPasses {
 public:
  BoundaryPasses(Device& device, BodyPasses& body, const Particles& particles, BoundaryConditions& boundary_conditions);

  void impose_displacements(Particles& particles, const fccda::Step& step, std::span<double> travel);
  void add_forces(Body& body, const fccda::Step& next);
  void record_to_host();
  void renew();

 private:
  /// act(action, part) for each boundary condition with such an action.
  template <class Act>
  void for_each(const Act& act) {
    std::size_t number = 0;
    for (NamedBoundaryCondition& one : boundary_conditions_->all()) {
      Part& part = parts_[number++];
      std::visit(
          [&](auto& action) {
            if constexpr (std::is_invocable_v<const Act&, decltype(action), Part&>) act(action, part);
          },
          one.boundary);
    }
  }
  template <class T>
  DeviceArray<T> uploaded(std::span<const T> numbers) const {
    DeviceArray<T> array(*device_, numbers.size());
    device_->upload(array.data(), numbers.data(), numbers.size_bytes());
    return array;
  }
  ListedArrays listed_arrays(const ListedEights& eights, const Particles& particles) const;
  ListedView view(const ListedArrays& arrays, Particles& particles) const;
  NumbersOfPlaces numbers_of(const Part& part, std::size_t first_quantity = 0) const {
    return {numbers_.data() + (part.first + first_quantity * part.eights) * byte_lanes, part.eights * byte_lanes};
  }
  void update_surface(Floating& water, Part& part, Body& body);
  std::vector<std::uint32_t> deep_tops(Floating& water, const Part& part, Particles& particles);
  void flood(Floating& water, std::span<const std::uint32_t> tops, const Particles& particles);
  template <class Action>
  void outdate_latest_forces(Action& action, Part& part) {
    part.is_outdated = true;
    device_->outdate(action.latest_forces());
  }
  void enter_sums(const Particles& particles, const fccda::Step& next);

  Device* device_;
  BodyPasses* body_;
  BoundaryConditions* boundary_conditions_;
  std::vector<Part> parts_;
  DeviceArray<double> numbers_, sums_;  // of places and of eights
  std::vector<double> sums_on_host_;
  DeviceArray<std::uint32_t> deep_count_, deep_;  // a GrowingList
};

BoundaryPasses::BoundaryPasses(Device& device, BodyPasses& body, const Particles& particles, BoundaryConditions& boundary_conditions)
    : device_(&device), body_(&body), boundary_conditions_(&boundary_conditions), parts_(boundary_conditions.all().size()), deep_count_(device, 1) {
  std::size_t sums = 0, most_places = 0;
  for_each([&]<class Action>(Action& action, Part& part) {
    if constexpr (owns_eights<Action>) {
      action.visit_arrays([&](const auto& array) { body_->mirrors().add(array); });
      part.eights = action.eights().count();
      if constexpr (std::is_same_v<Action, Floating>) part.intact.emplace(device, body_->mirrors(), part.eights * byte_lanes);
    } else if constexpr (has_kernels<Action>) {
      const ListedEights eights(action.slots());
      part.eights = eights.count();
      part.listed = listed_arrays(eights, particles);
      if constexpr (std::is_same_v<Action, Load>) {
        std::vector<double> weights(eights.places(), 0.0);
        for (std::size_t k = 0; k < action.slots().size(); ++k) weights[eights.place(k)] = action.weights()[k];
        part.listed.weights = uploaded(std::span<const double>(weights));
      }
    }
    part.first = sums;
    sums += part.eights * quantities_of(action);
    if constexpr (std::is_same_v<Action, Floating>)
      if (action.has_dry_top()) most_places = std::max(most_places, part.eights * byte_lanes);
  });
  numbers_ = DeviceArray<double>(device, sums * byte_lanes);
  sums_ = DeviceArray<double>(device, sums);
  sums_on_host_.resize(sums);
  deep_ = DeviceArray<std::uint32_t>(device, most_places);
}

ListedArrays BoundaryPasses::listed_arrays(const ListedEights& eights, const Particles& particles) const {
  ListedArrays arrays{uploaded(eights.numbers()), {}, uploaded(eights.lanes()), {}, {}, {}};
  Blocks blocks = blocks_of(eights);
  arrays.begin = uploaded(std::span<const std::uint32_t>(blocks.begin));
  arrays.blocks = std::move(blocks.numbers);
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<double> along(eights.places(), 0.0);
    for (const std::uint32_t place : eights.place_of()) along[place] = particles.reference(eights.view().slot(place))[c];
    arrays.reference[c] = uploaded(std::span<const double>(along));
  }
  return arrays;
}

ListedView BoundaryPasses::view(const ListedArrays& arrays, Particles& particles) const {
  const auto on_device = [&](VectorArray& vectors) { return body_->mirrors().at(vectors.writable_pointers()); };
  return {{arrays.numbers.data(), arrays.lanes.data()},
          {arrays.reference[0].data(), arrays.reference[1].data(), arrays.reference[2].data()},
          on_device(particles.position),
          on_device(particles.velocity),
          on_device(particles.force_density),
          particles.volume(0)};
}

void BoundaryPasses::impose_displacements(Particles& particles, const fccda::Step& step, std::span<double> travel) {
  for (NamedBoundaryCondition& one : boundary_conditions_->all()) one.account().accumulate_impulse(step.dt);
  for_each([&](PrescribedDisplacement& constraint, Part& part) {
    const ListedView listed = view(part.listed, particles);
    device_->launch(ImposeKernel{listed, constraint.motion(step)}, part.eights * byte_lanes);
    body_->motion().changed_on_device();
    const std::size_t blocks = part.listed.blocks.size();
    device_->launch(ListedTravelKernel{listed, part.listed.begin.data(), step.dt, numbers_of(part).numbers}, blocks);
    std::vector<double> of_blocks(blocks);
    device_->download(of_blocks.data(), numbers_of(part).numbers, blocks * sizeof(double));
    for (std::size_t n = 0; n < blocks; ++n) travel[part.listed.blocks[n]] = std::max(travel[part.listed.blocks[n]], of_blocks[n]);
  });
}

void BoundaryPasses::add_forces(Body& body, const fccda::Step& next) {
  if (parts_.empty()) return;
  Particles& particles = body.particles;
  Mirrors& mirrors = body_->mirrors();
  const auto launch = [&](const Kernel& kernel, const Part& part) {
    body_->forces().to_device();
    device_->launch(kernel, part.eights * byte_lanes);
    body_->forces().changed_on_device();
  };
  const auto on_host = [&](const auto& act) {
    body_->motion().to_host(), body_->forces().to_host();
    act();
    body_->forces().changed_on_host();
  };
  for_each([&]<class Action>(Action& action, Part& part) {
    if constexpr (std::is_same_v<Action, Floating>)
      update_surface(action, part, body);
    else if constexpr (requires { action.update_exposed_surface(particles, body.family, body.internal.broken_ends()); })
      on_host([&] { action.update_exposed_surface(particles, body.family, body.internal.broken_ends()); });
  });
  for_each([&]<class Action>(Action& action, Part& part) {
    if constexpr (std::is_same_v<Action, Load>)
      launch(LoadKernel{view(part.listed, particles), part.listed.weights.data(), action.intensity(next.t0), numbers_of(part)}, part);
    else if constexpr (requires { action.apply_load(particles, next); })
      on_host([&] { action.apply_load(particles, next); });
  });
  for_each([&]<class Action>(Action& action, Part& part) {
    if constexpr (std::is_same_v<Action, Floating>)
      launch(LiftKernel{mirrors.on_device(action.view(particles)), numbers_of(part)}, part);
    else if constexpr (requires { action.apply_hydrostatics(particles); })
      on_host([&] { action.apply_hydrostatics(particles); });
  });
  for_each([&]<class Action>(Action& action, Part& part) {
    if constexpr (std::is_same_v<Action, Absorbing>) {
      launch(DampKernel{mirrors.on_device(action.view(particles, next.dt)), numbers_of(part)}, part);
      outdate_latest_forces(action, part);
    } else if constexpr (requires { action.damp(particles, next.dt); }) {
      on_host([&] { action.damp(particles, next.dt); });
    }
  });
  for_each([&]<class Action>(Action& action, Part& part) {
    if constexpr (std::is_same_v<Action, Floating>) {
      if (!action.resists()) return;
      const WaterView water = mirrors.on_device(action.view(particles));
      if (water.wetness) device_->launch(WetKernel{water}, water.columns.count);
      launch(ResistKernel{water, next.dt, numbers_of(part, 2)}, part);
      outdate_latest_forces(action, part);
    } else if constexpr (requires { action.apply_resistance(particles, next.dt); }) {
      on_host([&] { action.apply_resistance(particles, next.dt); });
    }
  });
  for_each([&]<class Action>(Action& action, Part& part) {
    if constexpr (std::is_same_v<Action, PrescribedDisplacement>)
      launch(ReactKernel{view(part.listed, particles), action.motion(next), particles.density() / next.dt, numbers_of(part)}, part);
    else if constexpr (requires { action.apply_constraint(particles, next); })
      on_host([&] { action.apply_constraint(particles, next); });
  });
  device_->launch(SumLanesKernel{numbers_.data(), sums_.data()}, sums_on_host_.size());
  device_->download(sums_on_host_.data(), sums_.data(), sums_on_host_.size() * sizeof(double));
  enter_sums(particles, next);
}

/// What the sums of a boundary condition mean for its accounts.
void BoundaryPasses::enter_sums(const Particles& particles, const fccda::Step& next) {
  for_each([&]<class Action>(Action& action, Part& part) {
    const auto sum_of = [&]<std::size_t count>(std::size_t first_quantity) {
      return exact_sum_of_eights(particles.share().ranks(), part.eights, [&](std::size_t eight) {
        std::array<double, count> numbers;
        for (std::size_t n = 0; n < count; ++n) numbers[n] = sums_on_host_[part.first + (first_quantity + n) * part.eights + eight];
        return numbers;
      });
    };
    if constexpr (std::is_same_v<Action, Load>) {
      const auto [x, y, z] = sum_of.template operator()<3>(0);
      action.record(next.t0, Vec3d{x, y, z});
    } else if constexpr (std::is_same_v<Action, Absorbing>) {
      const auto [x, y, z, work] = sum_of.template operator()<4>(0);
      action.record(Resistance{{x, y, z}, work});
    } else if constexpr (std::is_same_v<Action, Floating>) {
      const auto [lift, potential] = sum_of.template operator()<2>(0);
      action.record(Hydrostatics{lift, potential});
      Vec3d resistance{};
      if (action.resists()) {
        const auto [x, y, z, work] = sum_of.template operator()<4>(2);
        resistance = action.record(Resistance{{x, y, z}, work});
      }
      action.record_force(resistance);
    } else if constexpr (std::is_same_v<Action, PrescribedDisplacement>) {
      const auto [x, y, z] = sum_of.template operator()<3>(0);
      action.record(next, Vec3d{x, y, z});
    }
  });
}

/// Exposed particles, those in contact with impactors, shares of intact bonds and dry tops, of which few change.
void BoundaryPasses::update_surface(Floating& water, Part& part, Body& body) {
  const Floating::SurfaceChange change = water.update_surface(body.particles, body.family, body.internal.broken_ends());
  if (change.is_exposed && part.eights > 0) body_->mirrors().upload(water.exposed());
  if (water.contact_has_changed()) {
    body_->mirrors().upload(water.in_contact());
    if (!water.carriers().empty()) body_->mirrors().upload(water.carriers());
  }
  part.intact->to_device(change.eights, std::array{water.intact_shares().data()});
  if (!water.has_dry_top()) return;
  flood(water, change.tops, body.particles);
  flood(water, deep_tops(water, part, body.particles), body.particles);
}

std::vector<std::uint32_t> BoundaryPasses::deep_tops(Floating& water, const Part& part, Particles& particles) {
  std::uint32_t count = 0;
  device_->upload(deep_count_.data(), &count, sizeof count);
  device_->launch(DeepTopsKernel{body_->mirrors().on_device(water.view(particles)), {deep_count_.data(), deep_.data()}}, part.eights * byte_lanes);
  device_->download(&count, deep_count_.data(), sizeof count);
  std::vector<std::uint32_t> tops(count);
  if (count > 0) device_->download(tops.data(), deep_.data(), count * sizeof(std::uint32_t));
  return tops;
}

void BoundaryPasses::flood(Floating& water, std::span<const std::uint32_t> tops, const Particles& particles) {
  if (tops.empty()) return;
  std::vector<std::uint32_t> slots;
  for (const std::uint32_t place : tops) slots.push_back(static_cast<std::uint32_t>(water.eights().view().slot(place)));
  body_->motion().to_host(slots);
  water.flood(tops, particles);
  body_->mirrors().upload(water.dry_tops());
}

void BoundaryPasses::record_to_host() {
  for_each([&]<class Action>(Action& action, Part& part) {
    if constexpr (owns_eights<Action>)
      if (std::exchange(part.is_outdated, false)) body_->mirrors().download(action.latest_forces());
  });
}

void BoundaryPasses::renew() {
  for_each([&]<class Action>(Action& action, Part& part) {
    if constexpr (owns_eights<Action>)
      if (!part.is_outdated && !action.latest_forces().empty()) body_->mirrors().upload(action.latest_forces());
    if constexpr (std::is_same_v<Action, Floating>)
      if (action.has_dry_top()) body_->mirrors().upload(action.dry_tops());
  });
}

}  // namespace device

BoundaryConditionsOnDevice::BoundaryConditionsOnDevice(Device& device, BodyOnDevice& on_device, Body& body, BoundaryConditions& boundary_conditions)
    : passes_(std::make_unique<device::BoundaryPasses>(device, on_device.passes(), body.particles, boundary_conditions)) {}
BoundaryConditionsOnDevice::BoundaryConditionsOnDevice(BoundaryConditionsOnDevice&&) noexcept = default;
BoundaryConditionsOnDevice::~BoundaryConditionsOnDevice() = default;

void BoundaryConditionsOnDevice::impose_displacements(Particles& particles, const fccda::Step& step, std::span<double> travel) {
  passes_->impose_displacements(particles, step, travel);
}
void BoundaryConditionsOnDevice::add_forces(Body& body, const fccda::Step& next) { passes_->add_forces(body, next); }
void BoundaryConditionsOnDevice::record_to_host() const { passes_->record_to_host(); }
void BoundaryConditionsOnDevice::renew() { passes_->renew(); }

DeviceTraffic BoundaryConditionsOnDevice::traffic_of_step(std::span<const NamedBoundaryCondition> all) {
  DeviceTraffic traffic;
  for (const NamedBoundaryCondition& one : all)
    std::visit(
        [&]<class Action>(const Action& action) {
          if constexpr (!device::has_kernels<Action>) return;
          const ListedEights eights(action.slots());
          traffic.downloaded += device::quantities_of(action) * eights.count() * sizeof(double);
          if constexpr (std::is_same_v<Action, PrescribedDisplacement>) traffic.downloaded += device::blocks_of(eights).numbers.size() * sizeof(double);
          if constexpr (std::is_same_v<Action, Floating>)
            if (action.has_dry_top()) traffic.uploaded += sizeof(std::uint32_t), traffic.downloaded += sizeof(std::uint32_t);  // how many are flooded
        },
        one.boundary);
  return traffic;
}

}  // namespace perimpact
