/// Local target size of panels from several refinements.
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
  /// Throws InputError if a part does not exist, or a box contains no panels. Both arguments must outlive the object.
  TargetSize(const Surface& surface, const Curvature& curvature, std::span<const Refinement> refinements);

  /// [m] The largest admissible longest edge of this piece, over all refinements that apply to it; infinity if none does. It never shrinks
  /// for a part of the piece.
  double of(const Bisection& bisection, const Bisection::Piece& piece) const;

  /// Estimated number of panels that the refinement creates, on the high side.
  double estimated_panels(const Refinement& refinement) const;

 private:
  struct SizeRequest {
    Refinement refinement;
    std::vector<bool> holds_for_part;  // by part of the surface
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
