/// What the boundary conditions of the deck have in common (docs/theory/boundary_conditions.md).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/parameter.hpp"
#include "base/vec3.hpp"
#include "perimpact/deck_model/motion_table.hpp"
#include "perimpact/deck_model/solids.hpp"

namespace perimpact {

using fccda::Choice;
using fccda::Field;
using fccda::Vec3d;

struct BodyContext;

/// Outward normals of axis-aligned faces, indexed by 2 · axis for the positive and 2 · axis + 1 for the negative direction.
inline constexpr std::string_view face_words[] = {"+x", "-x", "+y", "-y", "+z", "-z"};

inline constexpr std::string_view particle_set_sentence = "Name of a particle set of the body. Where absent, the whole body.";
inline constexpr std::string_view load_times_sentence = "Times of the factors, increasing.";
inline constexpr std::string_view load_factors_sentence =
    "Factor on the load at each time, interpolated linearly; constant before the first time and after the last. Where absent, 1.";

/// Restrictions that several boundary conditions share; each throws SetupError.
void refuse_along_z(std::string_view key, const BodyContext& deck);  ///< where the body is 2-D
void refuse_face_along_z(const Choice& face, const BodyContext& deck);
void check_factors(const std::vector<double>& times, const std::vector<double>& factors, const BodyContext& deck);

}  // namespace perimpact
