/// Share of contact in a run, compared with an impactor of particles as usual in peridynamics: CSV rows on standard output.
///
///   contact_share cases/plate_impact/deck.yaml
///
/// The run is that of the deck, with the swept detector on the impactor's mesh. At its end, with the same positions, contact is also evaluated with
/// the impactor's volume filled with particles at the spacing of the body: a short-range force acts between particles closer than one spacing
/// (Macek and Silling, Finite Elem. Anal. Des. 43 (2007) 1169). The pairs are found
///   all pairs        by comparing every particle of the body with every one of the impactor (10 000 of the body timed, extrapolated to all);
///   one cell list    by sorting the particles of both into cells of one spacing in each step, as pure particle codes do;
///   impactor's cells by sorting those of the impactor only, and querying the particles of the body in the box around them.
/// Shares refer to the resulting duration of a step: prediction, forces and monitors as measured in the run, plus this contact. One thread.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "fccda/detect/path_test.hpp"
#include "io/deck/deck.hpp"
#include "perimpact/simulation/simulation.hpp"

namespace {

using namespace perimpact;

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Particles at the given spacing inside the impactor at its current position.
std::vector<Vec3d> filled(const Impactor& impactor, double spacing) {
  const auto surface = std::shared_ptr<const fccda::Surface>(std::shared_ptr<void>(), &impactor.surface());
  const fccda::PathTest test(surface, fccda::Unbounded(), 0);
  const fccda::Box& bounds = impactor.surface().report().bounds;
  std::vector<Vec3d> particles;
  for (double z = bounds.low.z + 0.5 * spacing; z < bounds.high.z; z += spacing)
    for (double y = bounds.low.y + 0.5 * spacing; y < bounds.high.y; y += spacing)
      for (double x = bounds.low.x + 0.5 * spacing; x < bounds.high.x; x += spacing)
        if (test.is_inside({x, y, z}, 0)) particles.push_back(impactor.body().pose().to_world({x, y, z}));
  return particles;
}

/// Short-range force between two particles, in units of its stiffness.
void push(const Vec3d& a, const Vec3d& b, double reach, Vec3d& force, std::size_t& pairs) {
  const Vec3d way = a - b;
  const double squared = squared_norm(way);
  if (squared >= reach * reach || squared == 0) return;
  const double distance = std::sqrt(squared);
  force += (reach / distance - 1) * way;
  ++pairs;
}

struct Found {
  double seconds = 0;  // per step
  std::size_t pairs = 0;
};

Found all_pairs(const std::vector<Vec3d>& body, const std::vector<Vec3d>& impactor, double reach, std::vector<Vec3d>& force) {
  constexpr std::size_t wanted = 10000;
  const std::size_t every = std::max<std::size_t>(1, body.size() / wanted);
  Found found;
  std::size_t timed = 0;
  const double begin = seconds();
  for (std::size_t i = 0; i < body.size(); i += every, ++timed)
    for (const Vec3d& other : impactor) push(body[i], other, reach, force[i], found.pairs);
  found.seconds = (seconds() - begin) * static_cast<double>(body.size()) / static_cast<double>(timed);
  found.pairs *= every;
  return found;
}

/// Particles sorted by cell: counting sort over their bounding box.
class CellList {
 public:
  struct Item {
    Vec3d place;
    std::size_t number;
  };
  void sort(const std::vector<Vec3d>& particles, const fccda::Box& box, double cell) {
    low_ = box.low, cell_ = cell;
    for (std::size_t axis = 0; axis < 3; ++axis) cells_[axis] = static_cast<long>(box.size()[axis] / cell) + 1;
    first_.assign(static_cast<std::size_t>(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
    cell_of_.resize(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) ++first_[(cell_of_[i] = index(particles[i])) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    sorted_.resize(particles.size());
    next_ = first_;
    for (std::size_t i = 0; i < particles.size(); ++i) sorted_[next_[cell_of_[i]]++] = {particles[i], i};
  }
  template <class Visit>
  void visit_near(const Vec3d& point, const Visit& visit) const {
    const auto range = [&](std::size_t axis) {
      const long at = static_cast<long>((point[axis] - low_[axis]) / cell_);
      return std::pair(std::max(0L, at - 1), std::min(cells_[axis] - 1, at + 1));
    };
    const auto [x0, x1] = range(0);
    const auto [y0, y1] = range(1);
    const auto [z0, z1] = range(2);
    for (long z = z0; z <= z1; ++z)
      for (long y = y0; y <= y1; ++y) {
        const auto row = static_cast<std::size_t>((z * cells_[1] + y) * cells_[0]);
        for (std::uint32_t k = first_[row + static_cast<std::size_t>(x0)]; k < first_[row + static_cast<std::size_t>(x1) + 1]; ++k) visit(sorted_[k]);
      }
  }

 private:
  std::size_t index(const Vec3d& p) const {
    const auto at = [&](std::size_t axis) { return std::clamp(static_cast<long>((p[axis] - low_[axis]) / cell_), 0L, cells_[axis] - 1); };
    return static_cast<std::size_t>((at(2) * cells_[1] + at(1)) * cells_[0] + at(0));
  }
  Vec3d low_{};
  double cell_ = 1;
  long cells_[3]{};
  std::vector<std::uint32_t> first_, next_;
  std::vector<std::size_t> cell_of_;
  std::vector<Item> sorted_;
};

constexpr int rounds = 5;

Found by_cells_of_impactor(const std::vector<Vec3d>& body, const std::vector<Vec3d>& impactor, double reach, std::vector<Vec3d>& force) {
  CellList cells;
  Found found;
  for (int round = 0; round < rounds; ++round) {
    found.pairs = 0;
    const double begin = seconds();
    fccda::Box box;
    for (const Vec3d& p : impactor) box.include(p);
    cells.sort(impactor, box, reach);
    const Vec3d low = box.low - Vec3d{reach, reach, reach}, high = box.high + Vec3d{reach, reach, reach};
    for (std::size_t i = 0; i < body.size(); ++i) {
      const Vec3d& p = body[i];
      if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y || p.z < low.z || p.z > high.z) continue;
      cells.visit_near(p, [&](const CellList::Item& other) { push(p, other.place, reach, force[i], found.pairs); });
    }
    found.seconds += (seconds() - begin) / rounds;
  }
  return found;
}

Found by_one_cell_list(const std::vector<Vec3d>& body, const std::vector<Vec3d>& impactor, double reach, std::vector<Vec3d>& force) {
  std::vector<Vec3d> all = body;
  all.insert(all.end(), impactor.begin(), impactor.end());
  CellList cells;
  Found found;
  for (int round = 0; round < rounds; ++round) {
    found.pairs = 0;
    const double begin = seconds();
    fccda::Box box;
    for (const Vec3d& p : all) box.include(p);
    cells.sort(all, box, reach);
    for (std::size_t i = 0; i < body.size(); ++i)
      cells.visit_near(body[i], [&](const CellList::Item& other) {
        if (other.number >= body.size()) push(body[i], other.place, reach, force[i], found.pairs);
      });
    found.seconds += (seconds() - begin) / rounds;
  }
  return found;
}

struct Arguments {
  std::string deck;
  std::vector<std::string> set;
  int warm_up = 300, steps = 200;
};

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Share of contact in a run, compared with an impactor of particles; prints CSV rows.");
  app.add_option("deck", arguments.deck)->required()->check(CLI::ExistingFile);
  app.add_option("--set", arguments.set, "key.path=value: changes the deck")->allow_extra_args(false);
  app.add_option("--warm-up", arguments.warm_up)->check(CLI::NonNegativeNumber);
  app.add_option("--steps", arguments.steps)->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    fccda::use_threads(1);
    Simulation simulation(deck::read_deck(arguments.deck, arguments.set).setup);
    for (int step = 0; step < arguments.warm_up; ++step) simulation.step();
    const fccda::Timers before = simulation.timers();
    for (int step = 0; step < arguments.steps; ++step) simulation.step();
    const auto a_step = [&](std::string_view timer) { return (simulation.timers().seconds(timer) - before.seconds(timer)) / arguments.steps; };
    const double contact = a_step("contact"), rest = a_step("predict") + a_step("forces") + a_step("boundary_conditions") + a_step("monitors");

    const Body& body = simulation.bodies().front();
    const double spacing = body.particles.spacing();
    std::vector<Vec3d> particles;
    for (const std::uint32_t slot : body.particles.slot_of()) particles.push_back(body.particles.position.at(slot));
    const std::vector<Vec3d> impactor = filled(simulation.impactors().front(), spacing);
    std::vector<Vec3d> force(particles.size());

    fmt::print("impactor,search,particles,impactor_elements,contacts,contact_ms,rest_ms,share\n");
    const auto row = [&](const char* made_of, const char* search, std::size_t elements, std::size_t contacts, double taken) {
      fmt::print("{},{},{},{},{},{:.4g},{:.4g},{:.4g}\n", made_of, search, particles.size(), elements, contacts, 1e3 * taken, 1e3 * rest,
                 taken / (taken + rest));
    };
    row("mesh", "swept", simulation.impactors().front().surface().triangles().size(), simulation.contacts(), contact);
    const Found cells = by_cells_of_impactor(particles, impactor, spacing, force);
    row("particles", "impactor's cells", impactor.size(), cells.pairs, cells.seconds);
    const Found one_list = by_one_cell_list(particles, impactor, spacing, force);
    row("particles", "one cell list", impactor.size(), one_list.pairs, one_list.seconds);
    const Found pairs = all_pairs(particles, impactor, spacing, force);
    row("particles", "all pairs", impactor.size(), pairs.pairs, pairs.seconds);
    double sum = 0;  // use the forces, so that the compiler does not remove their computation
    for (const Vec3d& f : force) sum += norm(f);
    if (!std::isfinite(sum)) fmt::print(stderr, "the forces are not finite\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
  return 0;
}
