/// Scene of the contact benchmarks: an undulated hull that moves through a sheet of points.
///
/// The hull is 1 m long, 0.5 m wide and 0.4 m high; the sheet is 2 m × 1 m × 0.1 m, and the bow is half a metre inside it. Points
/// closer than the contact radius of half a spacing are removed, so contact begins at once along the entire bow. As for the plate of
/// Zhang et al. (32 m/s, 0.1 µs, 1 mm) the surface moves 0.0032 spacings per step. Points in contact remain at their relocated position; the
/// others are at rest, but their bound on the distance travelled is a tenth of the surface's motion, as in a body with stress waves.
/// With debris, one random point in a hundred moves at ten times the speed of the surface.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <vector>

#include "fccda/detect/contact.hpp"
#include "fccda/rigid_body/pose.hpp"
#include "mesh/shapes/sphere.hpp"
#include "mesh/surface.hpp"

namespace benchmark {

using fccda::Vec3d;

/// The hull, with the number of triangles 20 f² nearest to `panels`.
inline std::shared_ptr<const fccda::Surface> hull(double panels) {
  const auto sphere = [](double panel) { return fccda::make_sphere({.diameter = 1, .edge_length = panel}); };
  const double wanted = std::max(2.0, std::round(std::sqrt(panels / 20)));
  constexpr double trial = 0.2;
  const double of_trial = std::sqrt(static_cast<double>(sphere(trial).panels.size()) / 20);
  // f is the smallest integer above c/panel; it is known for the trial, so half below the wanted value is safe
  double panel = trial * of_trial / wanted;
  fccda::Panels shape = sphere(panel);
  for (int k = 0; k < 60 && std::lround(std::sqrt(static_cast<double>(shape.panels.size()) / 20)) != std::lround(wanted); ++k) {
    panel *= std::sqrt(static_cast<double>(shape.panels.size()) / 20) / wanted * (k % 2 == 0 ? 1.002 : 0.999);
    shape = sphere(panel);
  }
  for (Vec3d& p : shape.vertices) {
    const double bump = 1 + 0.08 * std::sin(9 * p.x) * std::cos(7 * p.y + 1) * std::cos(8 * p.z);
    p = {bump * p.x, 0.5 * bump * p.y, 0.4 * bump * p.z};
  }
  return std::make_shared<const fccda::Surface>(shape);
}

/// The points of the sheet for detection, and the operations of a solver between two detections.
class Sheet {
 public:
  static constexpr std::size_t block = 64;
  static constexpr double paper_speed = 0.0032;  // of the surface, in spacings per step

  explicit Sheet(double points) : spacing_(std::cbrt(extent.x * extent.y * extent.z / points)) {
    const auto count = [&](double length) { return std::max(1L, std::lround(length / spacing_)); };
    const Vec3d corner{0.5 - bow, -0.5 * extent.y, -0.5 * extent.z};
    for (long k = 0; k < count(extent.z); ++k)
      for (long j = 0; j < count(extent.y); ++j)
        for (long i = 0; i < count(extent.x); ++i)
          x1_.push_back(corner + spacing_ * Vec3d{static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5, static_cast<double>(k) + 0.5});
    begin();
  }

  double spacing() const { return spacing_; }
  double step_length() const { return paper_speed * spacing_; }  ///< [m] distance travelled by the surface per step

  /// Keeps only the points for which keep(i) is true.
  template <class Keep>
  void thin(const Keep& keep) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < x1_.size(); ++i)
      if (keep(i)) x1_[kept++] = x1_[i];
    x1_.resize(kept);
    begin();
  }

  /// Repeats the points until there are at least `count`.
  void repeat(std::size_t count) {
    const std::vector<Vec3d> once = x1_;
    while (!once.empty() && x1_.size() < count) x1_.insert(x1_.end(), once.begin(), once.end());
    begin();
  }

  void add_debris() {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < x1_.size(); ++i) {
      if (random() % 100 != 0) continue;
      const double x = normal(random), y = normal(random), z = normal(random);
      fast_.push_back({i, 10 * step_length() * normalised(Vec3d{x, y, z})});
    }
  }

  /// Performs one step of the solver.
  void advance() {
    for (const std::size_t i : moved_) x0_[i] = x1_[i], travel_[i / block] = waves();
    moved_.clear();
    for (const Fast& f : fast_) {
      x0_[f.point] = x1_[f.point];
      x1_[f.point] += f.way;
      travel_[f.point / block] = std::max(travel_[f.point / block], norm(f.way));
    }
  }

  /// Contact response: relocates the points.
  void relocate(const std::vector<fccda::Contact>& contacts) {
    for (const fccda::Contact& contact : contacts) {
      const std::size_t i = contact.point;
      x1_[i] = contact.relocation;
      travel_[i / block] = std::max(travel_[i / block], norm(x1_[i] - x0_[i]));
      moved_.push_back(i);
    }
  }

  std::size_t size() const { return x1_.size(); }
  bool occupied(std::size_t) const { return true; }
  const Vec3d& position_t0(std::size_t i) const { return x0_[i]; }
  const Vec3d& position_t1(std::size_t i) const { return x1_[i]; }
  std::size_t block_count() const { return travel_.size(); }
  std::size_t block_begin(std::size_t b) const { return b * block; }
  std::size_t block_end(std::size_t b) const { return std::min(x1_.size(), (b + 1) * block); }
  double block_travel(std::size_t b) const { return travel_[b]; }

 private:
  static constexpr Vec3d extent{2, 1, 0.1};  // [m]
  static constexpr double bow = 0.5;         // [m] depth of the bow in the sheet

  struct Fast {
    std::size_t point;
    Vec3d way;  // [m] per step
  };

  double waves() const { return 0.1 * step_length(); }
  void begin() {
    x0_ = x1_;
    travel_.assign((x1_.size() + block - 1) / block, waves());
  }

  double spacing_;
  std::vector<Vec3d> x0_, x1_;  // [m]
  std::vector<double> travel_;  // [m] per block
  std::vector<std::size_t> moved_;
  std::vector<Fast> fast_;
};

/// Motion of the hull in step k: translation.
inline fccda::Motion motion(const Sheet& sheet, long k) {
  const auto pose = [&](long step) { return fccda::Pose({static_cast<double>(step) * sheet.step_length(), 0, 0}); };
  return {pose(k), pose(k + 1), 1};
}

}  // namespace benchmark
