/// Vibration modes for impactors of tests.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "fixtures/temporary_folder.hpp"
#include "perimpact/impactor/impactor.hpp"

namespace fixtures {

using namespace perimpact;

/// Gives an impactor of a few centimetres a mode that bends it and one that stretches it, so compliant that contact moves its vertices visibly. The file of
/// modes is written to that path.
inline void make_elastic(ImpactorSetup& impactor, const std::filesystem::path& file) {
  std::string text = "frequency [Hz], 20000, 50000\ndamping_ratio, 0.02\nx [m], y [m], z [m], mode_1_x, mode_1_y, mode_1_z, mode_2_x, mode_2_y, mode_2_z\n";
  const ImpactorSurface surface = surface_of(impactor);
  for (const Vec3d& X : surface.remeshed.surface.panels().vertices)
    text += fmt::format("{:.17g},{:.17g},{:.17g},0,{:.17g},0,{:.17g},{:.17g},{:.17g}\n", X.x, X.y, X.z, 3e4 * (X.x * X.x - 5e-5), 400 * X.x, -300 * X.y,
                        -300 * X.z);
  put(file, text);
  impactor.elastic = ElasticImpactorSetup{.modes = file.string()};
}

}  // namespace fixtures
