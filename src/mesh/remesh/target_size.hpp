/// How long the panels of a surface may be, place by place, for several wishes at once.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/remesh/bisection.hpp"
#include "mesh/remesh/curvature.hpp"
#include "mesh/remesh/refine.hpp"

namespace fccda {

class TargetSize {
 public:
  /// Throws InputError where a part is none, or a box empty. Both must outlive it.
  TargetSize(const Surface& surface, const Curvature& curvature, std::span<const Refinement> refinements);

  /// [m] The longest that this piece of a surface may be by the smallest wish that holds for it; infinity where none does. It never
  /// shrinks for a part of the piece.
  double of(const Bisection& bisection, const Bisection::Piece& piece) const;

  /// About how many panels the refinement makes; more rather than fewer.
  double estimated_panels(const Refinement& refinement) const;

 private:
  struct SizeRequest {
    Refinement refinement;
    std::vector<bool> holds_for_part;  // of each of the surface
  };
  void expect_panels_in(const SizeRequest& request) const;
  SizeRequest request_of(const Refinement& refinement) const;
  bool holds_for_part_of(const SizeRequest& request, std::size_t triangle) const;
  double smooth_size(const SizeRequest& request, std::size_t triangle) const;

  const Surface& surface_;
  const Curvature& curvature_;
  std::vector<SizeRequest> requests_;
};

}  // namespace fccda
