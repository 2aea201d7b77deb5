#include "io/results/panel_frames.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"
#include "fixtures/vtp_file.hpp"
#include "perimpact/simulation/simulation.hpp"

using namespace perimpact;

namespace {

/// A block hit by a face wider than itself, with panels smaller than its spacing.
Setup impacted_block() {
  Setup setup;
  setup.time = {.end = 20e-6, .step = 5e-7};
  BodySetup block;
  block.name = "block";
  block.shape = BoxSolid{{0.04, 0.02, 0.02}};
  block.spacing = 0.004;
  block.material = OrdinaryStateSetup{191e9, 0.25, 8000, std::nullopt};
  setup.bodies = {block};
  ImpactorSetup hammer;
  hammer.name = "hammer";
  hammer.surface = BoxSurface{.size = {0.06, 0.02, 0.06}, .edge_length = 0.002};
  hammer.mass = 0.1;
  hammer.position = {0.003, 0.0201, 0.002};
  hammer.velocity = {1, -32, 0};
  hammer.free_dofs = {"x", "y", "z"};
  setup.impactors = {hammer};
  setup.contact.impactors.friction = 0.2;
  setup.output.history_interval = 2e-6;
  return setup;
}

fixtures::VtpFile frame_of(PanelFrames& frames, const fixtures::TemporaryFolder& folder, const Simulation& simulation) {
  const std::filesystem::path path = folder.path() / "frame.vtp";
  frames.write([&](const output::PolyData& frame) { output::write_vtp(path, frame, output::Compression::zlib); }, simulation.impactors()[0],
               simulation.clock().time());
  std::ifstream file(path, std::ios::binary);
  return fixtures::VtpFile({std::istreambuf_iterator<char>(file), {}});
}

}  // namespace

TEST_CASE("panel frames: impulses of the panels sum to the momentum loss of the impactor, and pressures times areas to the force") {
  const fixtures::TemporaryFolder folder;
  Simulation simulation(impacted_block());
  const Impactor& hammer = simulation.impactors()[0];
  const fccda::PanelFaces faces(hammer.surface());
  PanelFrames frames;
  frame_of(frames, folder, simulation);
  Vec3d before = hammer.body().momentum();
  const Vec3d first = before;
  double time = 0;
  std::vector<float> peak(faces.size(), 0);
  bool was_struck = false;
  while (!simulation.clock().is_finished()) {
    for (int k = 0; k < 6; ++k) simulation.step();  // not a multiple of the row interval of 4 steps
    const fixtures::VtpFile file = frame_of(frames, folder, simulation);
    const auto pressure = file.arrays.at("CellData/contact_pressure").as<float>(), impulse = file.arrays.at("CellData/contact_impulse").as<float>();
    REQUIRE(pressure.size() == faces.size());
    Vec3d sum{};
    double force = 0;
    for (std::size_t p = 0; p < faces.size(); ++p) {
      sum += Vec3d{impulse[3 * p], impulse[3 * p + 1], impulse[3 * p + 2]};
      force += pressure[p] * faces[p].area;
    }
    const Vec3d lost = hammer.body().momentum() - first;
    CHECK(norm(sum - lost) <= 1e-5 * (norm(lost) + 1e-9));  // written as float, 6e-8 per number
    // the contact face points along -y, so the normal force is the y component
    const double mean = (hammer.body().momentum() - before).y / (simulation.clock().time() - time);
    if (mean == 0)
      CHECK(force == 0);
    else
      CHECK(force == fixtures::relative(mean, 1e-6));  // written as float, 6e-8 per number
    was_struck = was_struck || mean > 0;
    const auto peak_now = file.arrays.at("CellData/peak_pressure").as<float>();
    for (std::size_t p = 0; p < faces.size(); ++p) CHECK(peak_now[p] >= peak[p]);
    peak = peak_now;
    before = hammer.body().momentum(), time = simulation.clock().time();
  }
  CHECK(was_struck);
  CHECK(*std::max_element(peak.begin(), peak.end()) > 0);
}

TEST_CASE("panel frames: an analytic sphere resolves no panels and has no arrays") {
  const fixtures::TemporaryFolder folder;
  Setup setup = impacted_block();
  setup.impactors[0].surface = SphereSurface{.diameter = 0.02, .edge_length = 0.002};
  setup.contact.impactors.detector.index = static_cast<int>(DetectorKind::analytic);
  const Simulation simulation(setup);
  PanelFrames frames;
  CHECK(frame_of(frames, folder, simulation).arrays.count("CellData/contact_pressure") == 0);
}
