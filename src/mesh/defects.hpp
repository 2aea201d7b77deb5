/// What is wrong with a surface, by panel: for messages, and for pictures in which the user finds the place.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace fccda {

enum class DefectKind : std::uint8_t {
  rim,                ///< an edge belongs to one panel only: a hole, or the end of an open surface
  non_manifold,       ///< an edge belongs to more than two panels, and which hang together cannot be told
  twisted,            ///< no winding is consistent: the surface has one side only
  no_volume,          ///< closed, but without an inside
  self_intersection,  ///< panels of one body go through one another
  inside_out          ///< they do, and what they enclose so has its outside within
};

constexpr std::string_view defect_names[] = {"rim", "non-manifold edge", "twisted", "no volume", "self-intersection", "inside out"};
constexpr std::string_view name_of(DefectKind kind) { return defect_names[static_cast<std::size_t>(kind)]; }

/// One kind of defect and the panels that have it, in rising order, as the file counts them (from 0).
struct Defect {
  DefectKind kind;
  std::vector<int> panels;
};

/// A surface that cannot be used because of a defect.
class SurfaceError : public InputError {
 public:
  SurfaceError(const std::string& sentence, Defect defect, Advice advice = Advice::none) : InputError(sentence, advice), defect_(std::move(defect)) {}
  const Defect& defect() const { return defect_; }

 private:
  Defect defect_;
};

}  // namespace fccda
