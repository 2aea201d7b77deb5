/// Strength of single particles, as factors of the critical stretch: material scatter (Weibull), and particles whose bonds never break.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace perimpact {

/// The factor of a particle whose bonds never break.
inline constexpr double unbreakable = std::numeric_limits<double>::infinity();

/// Uniform random number in (0, 1) for each particle index, the same on every machine: the mixing function of Steele, Lea and Flood
/// (Fast splittable pseudorandom number generators, OOPSLA 2014).
inline double uniform_of(std::uint64_t seed, std::uint64_t particle) {
  std::uint64_t z = seed * 0x9e3779b97f4a7c15u + (particle + 1) * 0xd1342543de82ef95u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return (static_cast<double>(z >> 11) + 0.5) * 0x1.0p-53;
}

/// Random factor with a Weibull distribution (Weibull, J. Appl. Mech. 18 (1951) 293) of mean 1: k = (-ln U)^(1/m)/Γ(1 + 1/m), m the Weibull modulus.
inline double weibull_factor(double modulus, std::uint64_t seed, std::uint64_t particle) {
  return std::pow(-std::log(uniform_of(seed, particle)), 1 / modulus) / std::tgamma(1 + 1 / modulus);
}

}  // namespace perimpact
