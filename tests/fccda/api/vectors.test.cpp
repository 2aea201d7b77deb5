#include "fccda/api/vectors.hpp"

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

TEST_CASE("vectors: views of vectors, of triples, of three arrays and of structs read and write the same numbers") {
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

TEST_CASE("vectors: views of empty arrays are empty") {
  CHECK(ConstVectors().size() == 0);
  CHECK(ConstVectors(std::vector<Vec3d>{}).size() == 0);
  CHECK(Vectors(std::vector<double>{}).size() == 0);
}

TEST_CASE("vectors: a named view can be copied, and converted to a read-only view") {
  double x[2]{1, 2}, y[2]{3, 4}, z[2]{5, 6};
  Vectors view(x, y, z, 2);
  Vectors again = view;
  again.set(1, {7, 8, 9});
  const ConstVectors seen = view, twice = seen;
  CHECK((view[1] == Vec3d{7, 8, 9} && twice[1] == Vec3d{7, 8, 9}));
  std::vector<Vec3d> other{{1, 1, 1}};
  view = Vectors(other);
  CHECK((view.size() == 1 && again.size() == 2));
}

TEST_CASE("vectors: floats are read as doubles and written rounded, in triples, in three arrays and in structs, with negative strides too") {
  std::vector<float> triples{1, 2, 3, 4, 5, 6};
  const std::vector<Vec3d> wanted{{1, 2, 3}, {4, 5, 6}};
  std::vector<Vec3d> found(2);
  copy(triples, found);
  CHECK(found == wanted);
  struct Particle {
    float mass, position[3];
  } particles[2]{};
  float* first = particles[0].position;
  copy(wanted, {first, first + 1, first + 2, 2, sizeof(Particle) / sizeof(float)});
  CHECK((particles[1].position[0] == 4 && particles[1].position[2] == 6 && particles[1].mass == 0));
  const ConstVectors backwards(triples.data() + 3, triples.data() + 4, triples.data() + 5, 2, -3);
  CHECK((backwards[0] == wanted[1] && backwards[1] == wanted[0] && backwards.is_single()));
  const Vectors view(triples);
  view.set(0, {0.1, 0, 0});
  CHECK(view[0].x == double(0.1F));
  CHECK_THROWS_WITH_AS(ConstVectors(std::vector<float>(7)), "vectors: 7 floats are not a multiple of three; give x, y and z of each.", InputError);
}

TEST_CASE("numbers: one for all, one for each, members of structs, doubles and floats") {
  struct Particle {
    double mass, position[3];
  } particles[2]{{7, {}}, {8, {}}};
  const Numbers masses(&particles[0].mass, 2, sizeof(Particle) / sizeof(double));
  CHECK((masses[0] == 7 && masses[1] == 8 && masses.of_each() && masses.are_for(2) && !masses.are_for(3)));
  const std::vector<float> floats{1.5F, 2.5F, 3.5F};
  const Numbers every_second(floats.data(), 2, 2), all_floats = floats;
  CHECK((every_second[1] == 3.5 && all_floats[2] == 3.5 && all_floats.are_for(3)));
  const Numbers one = 4;
  CHECK((one[17] == 4 && !one.of_each() && one.are_for(9)));
}

TEST_CASE("vectors: a number of doubles that is not a multiple of three is rejected") {
  CHECK_THROWS_WITH_AS(ConstVectors(std::vector<double>(7)), "vectors: 7 doubles are not a multiple of three; give x, y and z of each.", InputError);
}
