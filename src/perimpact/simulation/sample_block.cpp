#include "perimpact/simulation/sample_block.hpp"

#include <cmath>
#include <variant>

#include "perimpact/body/body.hpp"
#include "perimpact/discretisation/filling.hpp"

namespace perimpact {

namespace {

/// Points in the middle of cubes, or squares in the plane z = 0.
PointsShape grid_of_points(double spacing, int along_axis, const std::optional<double>& thickness) {
  PointsShape shape;
  shape.thickness = thickness;
  const int layers = thickness ? 1 : along_axis;
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < along_axis; ++j)
      for (int i = 0; i < along_axis; ++i) shape.points.push_back({i * spacing, j * spacing, k * spacing});
  shape.volumes.assign(shape.points.size(), spacing * spacing * thickness.value_or(spacing));
  return shape;
}

}  // namespace

BodySetup sample_block(const BodySetup& body, const Discretisation& discretisation, int particles) {
  BodySetup block = body;
  if (const auto* cloud = std::get_if<Cloud>(&discretisation)) {
    block.shape = grid_of_points(spacing_of(*cloud), particles, cloud->thickness);
  } else {
    const double size = particles * body.spacing.value();
    block.shape = BoxSolid{.size = {size, size, size}};
  }
  block.position = block.rotate = {};
  block.add = block.holes = block.particle_sets = {};
  block.cracks = {};
  block.boundary_conditions = {};
  block.moving_window = {};
  if (block.bending_calibration.as<ThinAxis>() != ThinAxis::none) {
    const int layers = lattice_that_fills(body, std::get<BodySolid>(discretisation)).cells[axis_of_calibration(body)];
    const double stiffness = bending_calibration(body, layers) * elastic_of(body).youngs_modulus;
    std::visit([&](auto& material) { material.youngs_modulus = stiffness; }, block.material);
    block.bending_calibration.index = 0;  // the block is as stiff, but not as thin
  }
  if (block.failure) block.failure->no_fail = {};
  return block;
}

}  // namespace perimpact
