#include "perimpact/integrate/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/parallel.hpp"
#include "perimpact/integrate/stiffest_mode.hpp"

namespace perimpact {

using fccda::byte_lanes;

namespace {

/// Critical time step [s] of a damped oscillation with ω² [1/s²] and damping [1/s].
double longest_step(double squared, double damping) { return (std::sqrt(damping * damping + 4 * squared) - damping) / squared; }

/// Largest eigenvalue of a symmetric 3×3 matrix (Smith, Commun. ACM 4 (1961) 168).
double largest_eigenvalue(const double (&m)[3][3]) {
  const double mean = (m[0][0] + m[1][1] + m[2][2]) / 3;
  double off = 0, deviator[3][3];
  for (int r = 0; r < 3; ++r)
    for (int s = 0; s < 3; ++s) {
      deviator[r][s] = m[r][s] - (r == s ? mean : 0);
      off += deviator[r][s] * deviator[r][s];
    }
  const double p = std::sqrt(off / 6);
  if (p == 0) return mean;
  const auto& d = deviator;
  const double determinant =
      d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) - d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) + d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
  const double angle = std::acos(std::clamp(determinant / (2 * p * p * p), -1.0, 1.0)) / 3;
  return mean + 2 * p * std::cos(angle);
}

/// Groups of eight slots with the same stiffness, slot by slot: in the interior of a lattice, and along its faces.
class Groups {
 public:
  template <class Force>
  Groups(const Body& body, const Force& force) : first_of_(body.particles.slots() / byte_lanes) {
    std::iota(first_of_.begin(), first_of_.end(), 0u);
    const Family& family = body.family;
    if (!family.stencil()) return;
    std::vector<std::uint64_t> keys(first_of_.size(), none);
    const auto for_each_eight = [&](const auto& f) {
      fccda::parallel_for(static_cast<std::ptrdiff_t>(first_of_.size()), [&](std::ptrdiff_t eight) { f(static_cast<std::size_t>(eight)); });
    };
    if constexpr (requires { force.correction(); }) {
      for_each_eight([&](std::size_t eight) { keys[eight] = key_of(family, force.correction().table_of(eight), eight); });
      join_equal(keys, [&](std::size_t a, std::size_t b) {
        return force.correction().table_of(a) == force.correction().table_of(b) && std::equal(family.bytes(a), family.bytes(a + 1), family.bytes(b));
      });
    } else {  // the stiffness of a bond depends on the families of both of its ends
      std::vector<std::uint8_t> is_complete(first_of_.size());
      for_each_eight([&](std::size_t eight) { is_complete[eight] = family.is_complete(eight); });
      for_each_eight([&](std::size_t eight) {
        if (!is_complete[eight]) return;
        for (const std::ptrdiff_t offset : family.offsets()) {
          const auto first = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(eight * byte_lanes) + offset);
          if (!is_complete[first / byte_lanes] || !is_complete[(first + byte_lanes - 1) / byte_lanes]) return;
        }
        keys[eight] = none + 1;
      });
      join_equal(keys, [](std::size_t, std::size_t) { return true; });
    }
  }

  /// f(slot) of all particles, by particle, but in each group of its first eight slots only; then copy(from, to) for the others.
  template <class F, class Copy>
  void for_each_particle(const Body& body, const F& f, const Copy& copy) const {
    const auto for_each_slot = [&](const auto& visit) {
      fccda::parallel_for_uneven(static_cast<std::ptrdiff_t>(first_of_.size()), [&](std::ptrdiff_t number) {
        const auto eight = static_cast<std::size_t>(number);
        for (std::size_t lane = 0; lane < byte_lanes; ++lane) visit(eight * byte_lanes + lane, std::size_t{first_of_[eight]} * byte_lanes + lane);
      });
    };
    for_each_slot([&](std::size_t slot, std::size_t first) {
      if (slot == first && body.particles.owns(slot)) f(slot);
    });
    for_each_slot([&](std::size_t slot, std::size_t first) {
      if (slot != first) copy(first, slot);
    });
  }

 private:
  static constexpr std::uint64_t none = 0;

  static std::uint64_t key_of(const Family& family, std::int32_t table, std::size_t eight) {
    if (table == CorrectionFactors::no_table) return none;
    const auto bytes = std::string_view(reinterpret_cast<const char*>(family.bytes(eight)), family.offsets().size());
    return (std::hash<std::string_view>{}(bytes)*31 + static_cast<std::uint64_t>(table)) | 1;
  }

  template <class Equal>
  void join_equal(const std::vector<std::uint64_t>& keys, const Equal& equal) {
    std::unordered_map<std::uint64_t, std::uint32_t> first;
    for (std::size_t eight = 0; eight < keys.size(); ++eight) {
      if (keys[eight] == none) continue;
      const std::uint32_t found = first.emplace(keys[eight], static_cast<std::uint32_t>(eight)).first->second;
      if (equal(found, eight)) first_of_[eight] = found;
    }
  }

  std::vector<std::uint32_t> first_of_;  // of each eight slots: the first eight of their group, or themselves
};

/// Of values by slot, none of which is negative.
double largest_of_body(const std::vector<double>& values, const Body& body) {
  return body.particles.share().ranks().max(*std::max_element(values.begin(), values.end()));
}

/// Largest of Σ_j C_ij v V [N/m⁴].
template <class Force>
double stiffest_springs(const Body& body, const Force& force) {
  std::vector<double> stiffness(body.particles.slots(), 0);
  Groups(body, force)
      .for_each_particle(
          body,
          [&](std::size_t slot) {
            double sum = 0;
            body.family.for_each_bond(slot, [&](const FamilyBond& bond) { sum += force.bond_stiffness(slot, bond) * bond.volume; });
            stiffness[slot] = sum;
          },
          [&](std::size_t from, std::size_t to) { stiffness[to] = stiffness[from]; });
  return largest_of_body(stiffness, body);
}

double stiffest_springs(const Body& body) {
  return body.internal.with_kernel([&](const auto& force) { return stiffest_springs(body, force); });
}

/// The larger of that and half of ρ ω² of safe_stable_step() [N/m⁴] for a material whose dilatation stores energy.
template <class Force>
double stiffest_with_dilatation(const Body& body, const Force& force) {
  const std::size_t slots = body.particles.slots();
  std::vector<double> springs(slots, 0), both(slots, 0);  // Σ C v V, and with the largest eigenvalue of Σ C v V n nᵀ
  std::vector<double> reach(slots, 0), push(slots, 0);    // S [1/m], g² S
  Groups(body, force)
      .for_each_particle(
          body,
          [&](std::size_t slot) {
            double tensor[3][3] = {}, sum = 0, weights = 0;
            Vec3d own{};
            body.family.for_each_bond(slot, [&](const FamilyBond& bond) {
              const double spring = force.bond_stiffness(slot, bond) * bond.volume, weight = force.dilatation_slope(slot, bond) * bond.volume;
              sum += spring, weights += weight;
              own += weight * bond.direction;
              for (std::size_t r = 0; r < 3; ++r)
                for (std::size_t s = 0; s <= r; ++s) tensor[r][s] += spring * bond.direction[r] * bond.direction[s];
            });
            for (std::size_t r = 0; r < 3; ++r)
              for (std::size_t s = 0; s < r; ++s) tensor[s][r] = tensor[r][s];
            springs[slot] = sum, both[slot] = largest_eigenvalue(tensor) + sum;
            reach[slot] = weights + norm(own);
            push[slot] = force.family_factor(slot) * force.family_factor(slot) * reach[slot];
          },
          [&](std::size_t from, std::size_t to) { springs[to] = springs[from], both[to] = both[from], reach[to] = reach[from], push[to] = push[from]; });
  const double least = largest_of_body(springs, body), hardest_of_all = largest_of_body(push, body);
  body.particles.share().refresh({push.data()});
  const auto occupied = body.particles.slot_of();
  fccda::parallel_for(static_cast<std::ptrdiff_t>(occupied.size()), [&](std::ptrdiff_t particle) {
    const std::size_t slot = occupied[static_cast<std::size_t>(particle)];
    const auto norm_with = [&](double hardest) { return 0.5 * (both[slot] + 2 * force.law().a() * reach[slot] * hardest); };
    if (norm_with(hardest_of_all) <= least) return;  // most of them where the dilatation is soft
    double hardest = push[slot];
    body.family.for_each_bond(slot, [&](const FamilyBond& bond) { hardest = std::max(hardest, push[bond.j]); });
    springs[slot] = std::max(springs[slot], norm_with(hardest));
  });
  return largest_of_body(springs, body);
}

/// Stable step for this Σ_j C_ij V_j [N/m⁴] and contacts.
double step_of(double springs, const Body& body, const ShortRange::Bound& contact) {
  const double stiffest = springs + contact.stiffness, density = body.particles.density();
  if (!(stiffest > 0)) return std::numeric_limits<double>::infinity();
  if (contact.damping == 0) return std::sqrt(2 * density / stiffest);
  return longest_step(2 * stiffest / density, 2 * contact.damping / density);
}

}  // namespace

double silling_askari_step(const Body& body, const ShortRange::Bound& contact) { return step_of(stiffest_springs(body), body, contact); }

double safe_stable_step(const Body& body, const ShortRange::Bound& contact) {
  const double springs = body.internal.with_kernel([&](const auto& force) {
    if constexpr (requires(const FamilyBond& bond) { force.dilatation_slope(0, bond); }) {
      // for a < 0 the dilatation reduces the energy of the bonds, which alone are a bound
      if (force.law().a() > 0) return stiffest_with_dilatation(body, force);
    }
    return stiffest_springs(body);
  });
  return step_of(springs, body, contact);
}

double exact_stable_step(const Body& body) { return exact_stable_step(stiffest_mode(body)); }
double exact_stable_step(double stiffest_mode) { return stiffest_mode > 0 ? 2 / std::sqrt(stiffest_mode) : std::numeric_limits<double>::infinity(); }

double own_stable_step(const Body& body, const ShortRange::Bound& contact) { return own_stable_step(stiffest_mode(body), body.particles.density(), contact); }
double own_stable_step(double stiffest_mode, double density, const ShortRange::Bound& contact) {
  constexpr double margin = 1.02;  // Lanczos' method is up to 0.7 % below
  // the highest frequency of two springs together is at most that of both in their stiffest modes (Weyl's inequality)
  const double squared = margin * stiffest_mode + 2 * contact.stiffness / density;
  if (!(squared > 0)) return std::numeric_limits<double>::infinity();
  return longest_step(squared, 2 * contact.damping / density);
}

}  // namespace perimpact
