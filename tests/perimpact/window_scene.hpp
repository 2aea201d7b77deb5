/// Bodies whose window moves.
#pragma once

#include <filesystem>
#include <string>

#include "fixtures/temporary_folder.hpp"
#include "perimpact/bodies.hpp"

namespace fixtures {

using namespace perimpact;

inline constexpr double window_spacing = 1.0 / 512;  // [m]; positions on the lattice are exact, so that they do not depend on its first cell
inline constexpr int window_added = 8;               // cells of a move

/// A small ball.
inline ImpactorSetup window_ball(const std::string& name, const Vec3d& position, const Vec3d& velocity, double diameter = 6 * window_spacing) {
  ImpactorSetup setup;
  setup.name = name;
  setup.surface = SphereSurface{.diameter = diameter, .edge_length = diameter / 8};
  setup.mass = 0.05;
  setup.position = position;
  setup.velocity = velocity;
  return setup;
}

/// A strip of cells along x, struck in its middle, and a remote impactor, the guide, that travels somewhat more than eight spacings in ten steps.
inline Setup struck_strip(int cells, double centre, Model model, int steps, const Vec3d& direction = {-1, 0, 0}) {
  Setup setup;
  setup.time = {.end = steps * 2e-7, .step = 2e-7};
  setup.output.history_interval = 1e-6;
  const double across = 8 * window_spacing, length = cells * window_spacing;
  const bool along_x = direction.x != 0;
  BodySetup strip = body_setup({.size = along_x ? Vec3d{length, across, 4 * window_spacing} : Vec3d{across, length, 4 * window_spacing},
                                .spacing = window_spacing,
                                .critical_stretch = 4e-4,
                                .model = model});
  strip.position = along_x ? Vec3d{centre, 0, 0} : Vec3d{0, centre, 0};
  setup.bodies = {strip};
  const double top = 2 * window_spacing;
  setup.impactors = {window_ball("ball", {0.3 * window_spacing, 0.2 * window_spacing, top + 3 * window_spacing}, {0, 0, -150}),
                     window_ball("guide", {0, 0, 1}, 8400 * direction)};
  setup.contact.fragments.law.index = 1;
  setup.contact.fragments.friction = 0.2;
  return setup;
}

/// A window that follows the guide.
inline MovingWindowSetup window_after(double travel, WindowAxis axis = WindowAxis::x) {
  MovingWindowSetup window{.follow = "guide", .start_after = travel};
  window.axis.index = static_cast<int>(axis);
  return window;
}

/// A floating strip of 64 x 8 x 4 cells along an axis, held at one end in its plane and with an absorbing layer at the other, whose window
/// follows a guide by eight spacings in ten steps; its front sinks under its weight. A ball, of which the contact bounds leave out a part, breaks it, and an
/// open sheet is pressed against it.
inline Setup window_strip(const std::filesystem::path& folder, bool along_x, double direction, Model model) {
  constexpr double top = 2 * window_spacing;
  const auto along = [&](double length, double across, double up) { return along_x ? Vec3d{length, across, up} : Vec3d{across, length, up}; };
  Setup setup;
  setup.time = {.end = 32 * 2e-7, .step = 2e-7};
  setup.output.history_interval = 1e-6;
  BodySetup strip = body_setup(
      {.size = along(64 * window_spacing, 8 * window_spacing, 4 * window_spacing), .spacing = window_spacing, .critical_stretch = 4e-4, .model = model});
  SolidSetup front, rear;
  front.name = "front", front.shape = BoxSolid{along(6 * window_spacing, 1, 1)}, front.position = along(direction * 32 * window_spacing, 0, 0);
  rear.name = "rear", rear.shape = BoxSolid{along(10 * window_spacing, 1, 1)}, rear.position = along(-direction * 32 * window_spacing, 0, 0);
  strip.particle_sets = {front, rear};
  FloatingSetup water;
  water.level = 0.004, water.drag = 1, water.damping = 2, water.dry_top = 0.001, water.entrained_depth = 0.003;
  AbsorbingSetup end;
  end.particle_set = "rear", end.face = Choice{face_words, (along_x ? 0 : 2) + (direction > 0 ? 1 : 0)}, end.reflection = 0.01;
  strip.boundary_conditions = {{"sea", water}, {"ahead", FixedSetup{.particle_set = "front", .directions = {"x", "y"}}}, {"behind", end}};
  MovingWindowSetup window{.follow = "guide", .start_after = 0};
  window.axis.index = along_x ? 0 : 1;
  strip.moving_window = window;
  setup.bodies = {strip};
  ImpactorSetup ball = window_ball("ball", along(0.3 * window_spacing, 0.2 * window_spacing, top + 3 * window_spacing), {0, 0, -400});
  ball.contact_bounds = {BoxRegionSetup{.size = {2 * window_spacing, 2 * window_spacing, 6 * window_spacing}}, Choice{on_exceed_words, 1}};
  ball.free_dofs = {"z"};
  ImpactorSetup sheet = window_ball("sheet", along(-9 * window_spacing, 0.1 * window_spacing, top + 0.05 * window_spacing), {0, 0, -150});
  put(folder / "sheet.obj", "v -0.006 -0.006 0\nv -0.006 0.006 0\nv 0.006 0.006 0\nv 0.006 -0.006 0\nf 1 2 3 4\n");
  sheet.surface = FileSurface{.file = (folder / "sheet.obj").string(), .orientation = Choice{open_side_words, static_cast<int>(fccda::Orientation::normals)}};
  sheet.inertia = Vec3d{1e-6, 1e-6, 1e-6};
  sheet.centre_of_mass = Vec3d{};
  setup.impactors = {ball, window_ball("guide", {0, 0, 1}, along(direction * 8400, 0, 0)), sheet};
  setup.contact.impactors.friction = 0.2;
  return setup;
}

/// The same, of ice that yields, with contact between its fragments and with a block below it that stays beside the window.
inline Setup window_rubble(const std::filesystem::path& folder) {
  Setup setup = window_strip(folder, true, -1, Model::bond_based);
  std::get<BondBasedSetup>(setup.bodies[0].material).plasticity = PlasticitySetup{.compressive_strength = 2e7};
  BodySetup block = body_setup({.size = {16 * window_spacing, 4 * window_spacing, 4 * window_spacing}, .spacing = window_spacing, .critical_stretch = 4e-4});
  block.name = "block";
  block.position = {2 * window_spacing, 0, -4.1 * window_spacing};
  block.velocity = {0, 0, 40};
  setup.bodies.insert(setup.bodies.begin(), block);
  setup.contact.fragments.law.index = 1;
  setup.contact.fragments.friction = 0.2;
  return setup;
}

}  // namespace fixtures
