/// `perimpact check` of bodies that are too large to be built for the question.
#pragma once

#include <string>
#include <vector>

#include "io/output/json.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/discretisation/discretise.hpp"
#include "perimpact/simulation/memory.hpp"
#include "perimpact/simulation/rank_forecast.hpp"

namespace perimpact {

/// True if the lattices have so many particles that building them takes longer than an answer may.
bool is_large(const Setup& setup, const std::vector<Discretisation>& bodies);

/// What follows from counting cells, from the surfaces, and from blocks of the materials.
class LargeCheck {
 public:
  /// `ranks`: of the run; 0 for one process. Throws SetupError if they cannot share the bodies.
  LargeCheck(const Setup& setup, const std::vector<Discretisation>& bodies, int ranks, const Network& network);

  const std::string& text() const { return text_; }
  /// Members of `check --json`; "is_estimate" is true.
  const output::Json& json() const { return json_; }
  /// Throws SetupError if a run of one process does not fit into memory. Does nothing for several, which may have a machine each.
  void expect_to_fit() const;

 private:
  const Setup& setup_;
  const std::vector<Discretisation>& bodies_;
  int ranks_;
  Memory memory_;
  std::string text_;
  output::Json json_;
};

}  // namespace perimpact
