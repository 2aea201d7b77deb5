// Contact of particles of different ranks, where bonds break between two lists of pairs; and the messages by which ranks find one another's particles.
#include "perimpact/self_contact/foreign_particles.hpp"

#include <doctest/doctest.h>

#include <array>
#include <map>
#include <mutex>
#include <set>

#include "perimpact/force/piles.hpp"
#include "perimpact/ranks/in_process.hpp"

using namespace perimpact;

namespace {

using Cell = std::array<int, 3>;

struct PairsInRange {
  std::set<std::array<std::uint64_t, 2>> ends;  // slots of the whole body
  std::size_t lists_before = 0, lists = 0;
};

struct Bond {
  Cell one, other;
};

/// Compressed block in which bonds are shorter than the range of contact. A bond breaks, then, after a first evaluation, another.
PairsInRange after_breaking(int ranks, const Cell& cells, const Vec3d& shift, const Bond& first, const Bond& second) {
  constexpr double spacing = 0.001;
  BodySetup setup =
      fixtures::body_setup({.size = {cells[0] * spacing, cells[1] * spacing, cells[2] * spacing}, .spacing = spacing, .family = FamilyRule::madenci_oterkus});
  setup.horizon_ratio = 1.6;
  PairsInRange pairs;
  std::mutex mutex;
  run_in_process(ranks, [&](Ranks& its) {
    fixtures::Pile pile{.law = {}, .bodies = {}};
    fccda::Stages stages{fccda::Stages::Announce{}};
    pile.bodies.push_back(make_body(setup, make_particles(setup, discretise(setup), its), stages));
    Body& body = pile.bodies[0];
    const Share& share = body.particles.share();
    for (const std::uint32_t slot : body.particles.slot_of()) body.particles.position.set(slot, 0.9 * body.particles.reference(slot) + spacing * shift);
    const auto slot_of = [&](const Cell& cell) { return share.local_slot(body.particles.whole_lattice()->slot(cell[0], cell[1], cell[2])); };
    const auto cut = [&](const Bond& bond) {
      const auto i = slot_of(bond.one), j = slot_of(bond.other);
      if (!i || !j) return;
      body.family.cut([&](std::size_t s, std::size_t t) { return (s == *i && t == *j) || (s == *j && t == *i); });
      body.internal.visit_state("", [&](const std::string&, auto values) {
        if constexpr (std::is_base_of_v<std::span<std::uint32_t>, decltype(values)>)
          for (const std::size_t end : {*i, *j})
            if (body.particles.owns(end)) ++values[end / fccda::byte_lanes];
      });
    };
    const auto bodies = pile.contacts();
    ShortRange contact(pile.law, bodies);
    const auto evaluate = [&] { pile.clear_forces(), contact.add_forces(bodies, 1e-8); };
    cut(first);
    evaluate();
    const std::size_t lists_before = contact.near_pairs().times_made();
    cut(second);
    evaluate();
    const std::lock_guard guard(mutex);
    pairs.lists_before = lists_before, pairs.lists = contact.near_pairs().times_made();
    contact.visit_state(bodies, [&](std::string_view name, auto&& values) {
      const auto numbers = fccda::numbers_in(values);
      if (name != "pair_ends") return;
      for (std::size_t k = 0; k + 1 < numbers.size(); k += 2)
        pairs.ends.insert({static_cast<std::uint64_t>(numbers[k]), static_cast<std::uint64_t>(numbers[k + 1])});
    });
  });
  return pairs;
}

}  // namespace

TEST_CASE(
    "foreign particles: those exposed since the list of pairs was made are in range, although the damage that began before is out of reach of this rank") {
  // a bond breaks at 19 cells of a bar, then, with the list of pairs at hand, one at 17 cells, whose particle is in range of that at 15 cells
  const auto with = [](int ranks) { return after_breaking(ranks, {32, 5, 5}, {}, {{19, 2, 2}, {20, 2, 2}}, {{17, 2, 2}, {18, 2, 2}}); };
  const PairsInRange one = with(1), two = with(2);
  for (const PairsInRange* pairs : {&one, &two}) CHECK(pairs->lists == pairs->lists_before);  // the last bond breaks where one had broken before
  const Lattice lattice{.cells = {32, 5, 5}};
  CHECK(one.ends.contains({lattice.slot(15, 2, 2), lattice.slot(17, 2, 2)}));
  CHECK(two.ends == one.ends);
}

TEST_CASE(
    "foreign particles: where three ranks meet within reach, those exposed since are in range although their owner knows the damage from another rank alone") {
  // the second bond is in reach of what one rank knows to be damaged, and its particle in range of that at row 5 of a third rank
  const auto with = [](int ranks) { return after_breaking(ranks, {8, 12, 3}, {1.25, 1.25, 1.25}, {{3, 11, 1}, {4, 11, 1}}, {{3, 7, 1}, {4, 7, 1}}); };
  const PairsInRange one = with(1);
  const Lattice lattice{.cells = {8, 12, 3}};
  CHECK(one.ends.contains({lattice.slot(4, 5, 1), lattice.slot(4, 7, 1)}));
  for (const int ranks : {2, 4}) {
    CAPTURE(ranks);
    CHECK(with(ranks).ends == one.ends);
  }
}

TEST_CASE("foreign particles: each rank finds those within reach of its own, and is refreshed with those it keeps") {
  // two particles on each of four ranks, one near the next rank's and one far from all
  run_in_process(4, [&](Ranks& ranks) {
    const double x = ranks.rank();
    VectorArray own(2, 0);
    own.set(0, {x, 0, 0}), own.set(1, {100, 50 * x, 100});
    ForeignParticles foreign;
    foreign.find(ranks, own, 1.0, [&](std::size_t p) {
      return ForeignParticles::Particle{.id = 2 * static_cast<std::uint64_t>(ranks.rank()) + p,
                                        .body = 0,
                                        .is_exposed = 1,
                                        .has_lost = 0,
                                        .reference = {},
                                        .position = own.at(p),
                                        .size = 1,
                                        .volume = 1};
    });
    std::map<std::uint64_t, std::size_t> found;
    for (std::size_t f = 0; f < foreign.all().size(); ++f) found[foreign.all()[f].id] = f;
    for (const int other : {ranks.rank() - 1, ranks.rank() + 1})
      if (other >= 0 && other < 4) REQUIRE(found.contains(2 * static_cast<std::uint64_t>(other)));
    std::vector<std::uint8_t> used(foreign.all().size(), 0);
    if (ranks.rank() > 0) used[found.at(2 * static_cast<std::uint64_t>(ranks.rank() - 1))] = 1;
    foreign.keep(ranks, used);
    std::map<std::size_t, double> refreshed;
    foreign.refresh<double>(
        ranks, [&](std::size_t p) { return 10.0 * ranks.rank() + static_cast<double>(p); }, [&](std::size_t f, double value) { refreshed[f] = value; });
    REQUIRE(refreshed.size() == (ranks.rank() > 0 ? 1 : 0));
    for (const auto& [f, value] : refreshed) REQUIRE((used[f] == 1 && value == 10.0 * (ranks.rank() - 1)));
  });
}
