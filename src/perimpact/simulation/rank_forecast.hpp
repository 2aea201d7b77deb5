/// What a run of several ranks needs, before it exists: shares of the bodies, messages of a step, and its duration by a model.
#pragma once

#include <span>
#include <vector>

#include "perimpact/deck_model/setup.hpp"
#include "perimpact/discretisation/discretise.hpp"
#include "perimpact/force/step_messages.hpp"
#include "perimpact/particles/partition.hpp"
#include "perimpact/ranks/network.hpp"

namespace perimpact {

/// What one of the ranks that own a body has of it; as the largest of any rank, each number by itself.
struct BodyShare {
  double cells = 0;            ///< owned, of the lattice; particles of a cloud
  double ghosts = 0;           ///< slots of other ranks that are refreshed
  double sent_slots = 0;       ///< in a refresh, with repetition
  double slots = 0;            ///< of the arrays of the rank, over those of the whole
  std::size_t neighbours = 0;  ///< ranks with which ghosts are exchanged
};

/// The share of each rank in the body, which is the next in turn.
std::vector<BodyShare> shares_of_ranks(const BodySetup& body, const Discretisation& discretisation, RanksInTurn& in_turn);

/// Of one body in a step: its ghosts, and the reductions of its material and boundary conditions.
StepMessages messages_of_body(const BodySetup& body, const Discretisation& discretisation);

/// Reductions and collections of a step apart from those of single bodies, for contact with impactors.
Traffic collectives_of_contact(const Setup& setup);

struct RankForecast {
  std::vector<double> cells;       ///< of each body, as BodyShare::cells
  std::vector<BodyShare> largest;  ///< of each body, the largest numbers of any rank
  std::vector<Traffic> sent;       ///< in a step, by each rank, in the state of StepMessages; without seconds
  double computing = 0;            ///< [s] of a step, of the slowest rank
  double messaging = 0;            ///< [s] of a step, of that rank

  const Traffic& most_sent() const;                      ///< by the rank that sends most bytes
  double memory_share() const;                           ///< largest share of the slots of any body
  double step() const { return computing + messaging; }  ///< [s] wall-clock time
};

/// `seconds_of_step` [s]: of one process, to compute a step of all cells alike. Throws SetupError where there are more ranks than blocks of cells.
RankForecast rank_forecast_of(const Setup& setup, std::span<const Discretisation> bodies, int ranks, double seconds_of_step, const Network& network);

}  // namespace perimpact
