/// `perimpact check` of bodies that are too large to be built for the question.
#pragma once

#include <string>
#include <vector>

#include "io/output/json.hpp"
#include "perimpact/deck_model/setup.hpp"
#include "perimpact/discretisation/discretise.hpp"
#include "perimpact/simulation/memory.hpp"

namespace perimpact {

/// True if the lattices have so many particles that building them takes longer than an answer may.
bool is_large(const Setup& setup, const std::vector<Discretisation>& bodies);

/// What follows from counting cells, from the surfaces, and from blocks of the materials.
class LargeCheck {
 public:
  LargeCheck(const Setup& setup, const std::vector<Discretisation>& bodies);

  const std::string& text() const { return text_; }
  /// Members of `check --json`; "is_estimate" is true.
  const output::Json& json() const { return json_; }
  /// Throws SetupError if the run does not fit into memory.
  void expect_to_fit() const;

 private:
  const Setup& setup_;
  const std::vector<Discretisation>& bodies_;
  Memory memory_;
  std::string text_;
  output::Json json_;
};

}  // namespace perimpact
