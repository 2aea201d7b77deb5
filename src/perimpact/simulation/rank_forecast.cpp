#include "perimpact/simulation/rank_forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <variant>

#include "base/parallel.hpp"
#include "perimpact/body/body.hpp"
#include "perimpact/boundary_conditions/boundary_conditions.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/simulation/expect_parts.hpp"
#include "perimpact/simulation/memory.hpp"
#include "perimpact/simulation/sample_block.hpp"

namespace perimpact {

namespace {

/// An exchange of so many bytes of each cell.
Traffic message_of(const BodyShare& share, std::size_t bytes) {
  return {.messages = static_cast<std::int64_t>(share.neighbours), .bytes = static_cast<std::int64_t>(share.sent_slots) * static_cast<std::int64_t>(bytes)};
}

std::vector<BodyShare> shares_of_lattice(const BodySetup& body, const BodySolid& solid, RanksInTurn& in_turn) {
  const Lattice whole = lattice_that_fills(body, solid);
  const PartitionRule rule = partition_rule_of(body, whole);
  const std::vector<CellBox> boxes = boxes_of_ranks(rule, in_turn.ranks(), in_turn.first_rank());
  in_turn.add(count_parts(boxes));
  std::vector<BodyShare> shares(boxes.size());
  fccda::parallel_for(static_cast<std::ptrdiff_t>(boxes.size()), [&](std::ptrdiff_t rank) {
    BodyShare& share = shares[static_cast<std::size_t>(rank)];
    const CellBox& own = boxes[static_cast<std::size_t>(rank)];
    share.cells = static_cast<double>(own.cells());
    share.slots = share_of_slots(whole, with_ghosts(own, rule));
    for (const ExchangedCells& exchanged : exchanged_cells(boxes, static_cast<int>(rank), rule.reach)) {
      share.ghosts += static_cast<double>(exchanged.receive.cells());
      share.sent_slots += static_cast<double>(exchanged.send.cells());
      ++share.neighbours;
    }
  });
  return shares;
}

std::vector<BodyShare> shares_of_cloud(const BodySetup& body, const Cloud& cloud, RanksInTurn& in_turn) {
  using fccda::byte_lanes;
  const CloudParts parts = parts_of(body, cloud, in_turn.ranks(), in_turn.first_rank());
  const CloudPartition& partition = parts.partition();
  in_turn.add(partition.parts());
  std::vector<BodyShare> shares(static_cast<std::size_t>(in_turn.ranks()));
  for (std::size_t rank = 0; rank < shares.size(); ++rank) {
    const CloudPart part = parts.of(static_cast<int>(rank));
    const int own = partition.part_of(static_cast<int>(rank));
    const std::size_t end = std::min(partition.end(own) * byte_lanes, cloud.points.size()), begin = std::min(partition.begin(own) * byte_lanes, end);
    BodyShare& share = shares[rank];
    share.cells = static_cast<double>(end - begin);
    share.slots = static_cast<double>(part.eights.size()) / static_cast<double>(partition.eights());
    share.neighbours = part.exchanged.size();
    for (const CloudPart::Exchanged& exchanged : part.exchanged) {
      share.ghosts += static_cast<double>(byte_lanes * exchanged.receive.size());
      share.sent_slots += static_cast<double>(byte_lanes * exchanged.send.size());
    }
  }
  return shares;
}

}  // namespace

std::vector<BodyShare> shares_of_ranks(const BodySetup& body, const Discretisation& discretisation, RanksInTurn& in_turn) {
  if (const auto* cloud = std::get_if<Cloud>(&discretisation)) return shares_of_cloud(body, *cloud, in_turn);
  return shares_of_lattice(body, std::get<BodySolid>(discretisation), in_turn);
}

StepMessages messages_of_body(const BodySetup& setup, const Discretisation& discretisation) {
  constexpr int particles = 12;                        // along each axis
  constexpr std::size_t of_ghost = 2 * sizeof(Vec3d);  // Particles::refresh_ghosts
  StepMessages messages{.refreshed = {of_ghost}, .collectives = {}};
  messages += make_body(sample_block(setup, discretisation, particles)).internal.messages();
  for (const BoundaryConditionSetup& boundary : setup.boundary_conditions)
    std::visit(
        [&](const auto& kind) {
          using Action = decltype(make_boundary(kind, std::declval<const BoundarySite&>()));
          messages.collectives += Action::collectives_in_step(kind);
        },
        boundary.kind);
  return messages;
}

Traffic collectives_of_contact(const Setup& setup) {
  Traffic traffic;
  for (const ImpactorSetup& impactor : setup.impactors) traffic.collections += impactor.elastic ? 2 : 1;  // contacts, and those of the structure
  if (setup.impactors.size() > 1)                                                                         // unresolved penetrations
    for (std::size_t pair = 0; pair < setup.impactors.size() * setup.bodies.size(); ++pair) traffic += reduction_of(1);
  return traffic;
}

const Traffic& RankForecast::most_sent() const { return *std::ranges::max_element(sent, {}, &Traffic::bytes); }

double RankForecast::memory_share() const { return std::ranges::max_element(largest, {}, &BodyShare::slots)->slots; }

RankForecast rank_forecast_of(const Setup& setup, std::span<const Discretisation> bodies, int ranks, double seconds_of_step, const Network& network) {
  RankForecast forecast;
  forecast.sent.resize(static_cast<std::size_t>(ranks));
  Traffic collectives = collectives_of_contact(setup);
  std::vector<double> cells(forecast.sent.size(), 0);
  RanksInTurn in_turn(ranks);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::vector<BodyShare> shares = shares_of_ranks(setup.bodies[b], bodies[b], in_turn);
    const StepMessages messages = messages_of_body(setup.bodies[b], bodies[b]);
    collectives += messages.collectives;
    BodyShare& largest = forecast.largest.emplace_back();
    double& all = forecast.cells.emplace_back(0);
    for (std::size_t rank = 0; rank < shares.size(); ++rank) {
      const BodyShare& share = shares[rank];
      cells[rank] += share.cells, all += share.cells;
      for (const std::size_t bytes : messages.refreshed) forecast.sent[rank] += message_of(share, bytes);
      largest = {std::max(largest.cells, share.cells), std::max(largest.ghosts, share.ghosts), std::max(largest.sent_slots, share.sent_slots),
                 std::max(largest.slots, share.slots), std::max(largest.neighbours, share.neighbours)};
    }
  }
  expect_parts_for_all(in_turn);
  const double seconds_of_cell = seconds_of_step / std::accumulate(forecast.cells.begin(), forecast.cells.end(), 0.0);
  for (std::size_t rank = 0; rank < cells.size(); ++rank) {
    forecast.sent[rank] += collectives;
    const double computing = seconds_of_cell * cells[rank], messaging = network.seconds_of(forecast.sent[rank], ranks);
    if (computing + messaging >= forecast.step()) forecast.computing = computing, forecast.messaging = messaging;
  }
  return forecast;
}

}  // namespace perimpact
