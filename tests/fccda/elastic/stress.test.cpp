#include "fccda/elastic/stress.hpp"

#include <doctest/doctest.h>

#include <random>

#include "base/quaternion.hpp"
#include "fixtures/tolerance.hpp"

using namespace fccda;

TEST_CASE("stress: the equivalent stress follows from the principal stresses, whatever the axes") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3d s{number(random), number(random), number(random)};  // [Pa] principal stresses
    const Mat3 turn = Quaternion::from_rotation({3 * number(random), 3 * number(random), 3 * number(random)}).matrix();
    Mat3 tensor{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) tensor.row[i][j] += turn.row[i][k] * s[k] * turn.row[j][k];
    const auto& t = tensor.row;
    const double expected = std::sqrt(0.5 * ((s.x - s.y) * (s.x - s.y) + (s.y - s.z) * (s.y - s.z) + (s.z - s.x) * (s.z - s.x)));
    CHECK(von_mises({t[0][0], t[1][1], t[2][2], t[0][1], t[1][2], t[2][0]}) == fixtures::relative(expected, 1e-12));  // rounding of sums of order 1
  }
}

TEST_CASE("stress: modes have stresses only if each of them has") {
  const Mode with{.stress = {SymmetricTensor{}}}, without{};
  CHECK(have_stresses(std::vector{with, with}));
  CHECK_FALSE(have_stresses(std::vector{with, without}));
  CHECK_FALSE(have_stresses(Modes{}));
}
