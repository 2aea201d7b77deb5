/// JSON arrays of vectors.
#pragma once

#include "base/vec3.hpp"
#include "io/output/json.hpp"

namespace perimpact {

inline output::Json json_vector(const fccda::Vec3d& v) { return std::vector<double>{v.x, v.y, v.z}; }

}  // namespace perimpact
