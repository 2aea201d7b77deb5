#include "fccda/plain/vectors.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace fccda;

namespace {

/// Writes through one view of six doubles and reads through another.
void copy(ConstVectors from, Vectors to) {
  REQUIRE(from.size() == to.size());
  for (std::size_t i = 0; i < from.size(); ++i) to.set(i, from[i]);
}

}  // namespace

TEST_CASE("vectors: the same numbers are seen in vectors, in triples, in three arrays and in structs, and can be written there") {
  const std::vector<Vec3d> vectors{{1, 2, 3}, {4, 5, 6}};

  std::vector<double> triples(6);
  copy(vectors, triples);
  CHECK(triples == std::vector<double>{1, 2, 3, 4, 5, 6});

  std::vector<double> x(2), y(2), z(2);
  copy(triples, {x.data(), y.data(), z.data(), 2});
  CHECK((x == std::vector<double>{1, 4} && y == std::vector<double>{2, 5} && z == std::vector<double>{3, 6}));

  struct Particle {
    double mass, position[3];
  } particles[2]{{7, {}}, {8, {}}};
  double* first = particles[0].position;
  copy({x.data(), y.data(), z.data(), 2}, {first, first + 1, first + 2, 2, sizeof(Particle) / sizeof(double)});
  CHECK((particles[1].position[0] == 4 && particles[1].position[2] == 6 && particles[1].mass == 8));

  std::vector<Vec3d> again(2);
  copy({first, first + 1, first + 2, 2, 4}, again);
  CHECK(again == vectors);
}

TEST_CASE("vectors: of nothing there are none") {
  CHECK(ConstVectors().size() == 0);
  CHECK(ConstVectors(std::vector<Vec3d>{}).size() == 0);
  CHECK(Vectors(std::vector<double>{}).size() == 0);
}

TEST_CASE("vectors: doubles that are no whole number of triples are refused") {
  CHECK_THROWS_WITH_AS(ConstVectors(std::vector<double>(7)), "vectors: 7 doubles are no whole number of vectors; give x, y and z of each.", InputError);
}
