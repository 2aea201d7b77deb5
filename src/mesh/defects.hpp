/// Defects of a surface mesh by panel, for messages and for output files that locate them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace fccda {

enum class DefectKind : std::uint8_t {
  rim,                ///< boundary edge, of one panel only: a hole, or the end of an open surface
  non_manifold,       ///< an edge is shared by more than two panels, and the pairs to be joined are ambiguous
  twisted,            ///< not orientable: no winding is consistent, as on a Möbius strip
  no_volume,          ///< closed, but encloses no volume
  self_intersection,  ///< panels of one body intersect
  inside_out          ///< they intersect, and enclose a pocket with negative winding number
};

constexpr std::string_view defect_names[] = {"boundary edge", "non-manifold edge", "non-orientable", "no volume", "self-intersection", "inside out"};
constexpr std::string_view name_of(DefectKind kind) { return defect_names[static_cast<std::size_t>(kind)]; }

/// One kind of defect and the affected panels, in ascending order, numbered as in the file (from 0).
struct Defect {
  DefectKind kind;
  std::vector<int> panels;
};

/// The surface is unusable because of a defect.
class SurfaceError : public InputError {
 public:
  SurfaceError(const std::string& sentence, Defect defect, Advice advice = Advice::none) : InputError(sentence, advice), defect_(std::move(defect)) {}
  const Defect& defect() const { return defect_; }

 private:
  Defect defect_;
};

}  // namespace fccda
