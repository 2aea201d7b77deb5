#include "fccda/api/contact_detector.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "base/parallel.hpp"

namespace fccda {

namespace {

/// Points per block. One bound on the path length is kept per block: blocks are large enough to be cheap, and small enough that a fast point
/// makes few others due.
constexpr std::size_t block_size = 64;

/// Minimum number of blocks for a parallel loop: the paths of fewer are measured (in 25 µs) before other threads have woken.
constexpr std::ptrdiff_t blocks_worth_threads = 128;

std::size_t blocks_of(std::size_t points) { return (points + block_size - 1) / block_size; }

template <class Body>
void for_blocks(std::size_t count, const Body& body) {
  const auto blocks = static_cast<std::ptrdiff_t>(count);
  if (blocks < blocks_worth_threads)
    for (std::ptrdiff_t block = 0; block < blocks; ++block) body(block);
  else
    parallel_for(blocks, body);
}

/// Relative rounding error of the stored positions: half a unit in the last place.
double rounding_of(ConstVectors x) { return x.is_single() ? 0.5 * std::numeric_limits<float>::epsilon() : 0; }

/// The Points interface over arrays.
class ArrayPoints {
 public:
  ArrayPoints(ConstVectors x_t0, ConstVectors x_t1, std::span<const double> travel) : x_t0_(x_t0), x_t1_(x_t1), travel_(travel) {}

  std::size_t size() const { return x_t0_.size(); }
  Vec3d position_t0(std::size_t i) const { return x_t0_[i]; }
  Vec3d position_t1(std::size_t i) const { return x_t1_[i]; }
  static bool occupied(std::size_t) { return true; }
  std::size_t block_count() const { return blocks_of(size()); }
  static std::size_t block_begin(std::size_t block) { return block * block_size; }
  std::size_t block_end(std::size_t block) const { return std::min((block + 1) * block_size, size()); }
  double block_travel(std::size_t block) const { return travel_[block]; }

 private:
  ConstVectors x_t0_, x_t1_;
  std::span<const double> travel_;
};

/// The same for points that are balls of individual radii.
class ArrayBalls : public ArrayPoints {
 public:
  ArrayBalls(const ArrayPoints& points, const Numbers& radius, double largest) : ArrayPoints(points), radius_(radius), largest_(largest) {}

  double radius(std::size_t i) const { return radius_[i]; }
  double largest_radius() const { return largest_; }

 private:
  Numbers radius_;
  double largest_;
};
static_assert(PointsOfOwnRadius<ArrayBalls> && !PointsOfOwnRadius<ArrayPoints>);

bool is_radius(double radius) { return radius >= 0 && std::isfinite(radius); }

double checked_radius(double radius) {
  if (is_radius(radius)) return radius;
  throw InputError("contact: the contact radius is " + in_words(radius) + " m, but it must be a number of at least 0; 0 is for points without extent.");
}

double size_of(const Surface& surface) { return largest_magnitude(surface.report().bounds.size()); }

void expect_radii(const Numbers& radius, std::size_t points) {
  if (!radius.are_for(points))
    throw InputError("contact: the number of radii differs from the " + std::to_string(points) + " points; give one for each, or one number for all.");
}

/// Visitors of Swept::visit_state.
struct StateReader {
  ContactDetector::State& state;
  void operator()(std::string_view name, const std::vector<std::uint64_t>& numbers) const {
    (name == "points_inside" ? state.inside : state.in_contact) = numbers;
  }
  void operator()(std::string_view name, const std::uint64_t& number) const { (name == "entered_inside" ? state.entered : state.renumbered) = number; }
};

struct StateWriter {
  const ContactDetector::State& state;
  void operator()(std::string_view name, std::vector<std::uint64_t>& numbers) const { numbers = name == "points_inside" ? state.inside : state.in_contact; }
  void operator()(std::string_view name, std::uint64_t& number) const { number = name == "entered_inside" ? state.entered : state.renumbered; }
};

double squared_path(ConstVectors x_t0, ConstVectors x_t1, std::size_t i) { return squared_norm(x_t1[i] - x_t0[i]); }

[[noreturn]] void refuse_path(ConstVectors x_t0, ConstVectors x_t1, double longest) {
  std::size_t i = 0;
  while (std::sqrt(squared_path(x_t0, x_t1, i)) <= longest) ++i;
  const std::string sentence = "contact: point " + std::to_string(i) + " goes from " + in_words(x_t0[i]) + " to " + in_words(x_t1[i]) + " in one step, ";
  if (!std::isfinite(squared_path(x_t0, x_t1, i))) throw RunError(sentence + "which is not finite; the solver has become unstable, use a shorter step.");
  throw RunError(sentence + "farther than " + in_words(longest) +
                 " m, beyond which rounding hides its contact; the solver has become unstable, use a shorter step.");
}

}  // namespace

ContactDetector::ContactDetector(SharedSurface surface, const Options& options)
    : swept_(std::move(surface), options.region, checked_radius(options.radius)),
      centre_(swept_.surface().report().bounds.centre()),
      reach_(swept_.surface().radius_about(centre_)),
      longest_path_(longest_path * size_of(swept_.surface())) {}

void ContactDetector::measure_paths(ConstVectors x_t0, ConstVectors x_t1) {
  if (x_t0.size() != x_t1.size())
    throw InputError("contact: there are " + std::to_string(x_t0.size()) + " points at the beginning of the step and " + std::to_string(x_t1.size()) +
                     " at its end; give both positions of every point.");
  travel_.resize(blocks_of(x_t0.size()));
  const auto measure = [&](std::ptrdiff_t block) {
    const std::size_t begin = static_cast<std::size_t>(block) * block_size, end = std::min(begin + block_size, x_t0.size());
    double longest = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const double squared = squared_path(x_t0, x_t1, i);
      if (!(squared <= longest)) longest = squared;
      if (std::isnan(longest)) break;  // comparisons with it are always false
    }
    travel_[static_cast<std::size_t>(block)] = std::sqrt(longest);
  };
  for_blocks(travel_.size(), measure);
  if (!std::ranges::all_of(travel_, [&](double travel) { return travel <= longest_path_; })) refuse_path(x_t0, x_t1, longest_path_);
}

// A known distance is a distance beyond the point's contact radius. So a point with a larger radius is evaluated again. If it now starts
// inside, it counts as pushed there.
double ContactDetector::note_radii(const Numbers& radius, std::size_t points) {
  expect_radii(radius, points);
  if (radius_.empty()) swept_.forget();
  std::vector<double> largest(blocks_of(points));
  std::vector<std::uint8_t> differs(largest.size());
  const auto scan = [&](std::ptrdiff_t block) {
    const auto b = static_cast<std::size_t>(block);
    for (std::size_t i = b * block_size; i < std::min((b + 1) * block_size, points); ++i) {
      const double now = radius[i];
      if (!is_radius(now) || i >= radius_.size() || now != radius_[i]) differs[b] = 1;
      largest[b] = std::max(largest[b], now);
    }
  };
  for_blocks(largest.size(), scan);
  const std::size_t known = radius_.size();
  radius_.resize(points);
  for (std::size_t b = 0; b < differs.size(); ++b) {
    if (differs[b] == 0) continue;
    for (std::size_t i = b * block_size; i < std::min((b + 1) * block_size, points); ++i) {
      const double now = radius[i];
      if (!is_radius(now))
        throw InputError("contact: the radius of point " + std::to_string(i) + " is " + in_words(now) + " m, but it must be a number of at least 0.");
      if (i < known && now > radius_[i]) swept_.grown(i);
      radius_[i] = now;
    }
  }
  return points == 0 ? 0 : *std::ranges::max_element(largest);
}

template <class P>
std::vector<Contact> ContactDetector::contacts_of(const P& points, const Motion& motion) {
  std::vector<Contact> contacts;
  const double reach = norm(motion.centre - centre_) + reach_;  // radius of the surface about the centre of rotation
  swept_.detect(points, motion, travel_bound(motion, motion.centre, reach), contacts);
  return contacts;
}

ContactDetector::State ContactDetector::state() const {
  State state;
  swept_.visit_state(StateReader{state});
  return state;
}

void ContactDetector::resume(const State& state) {
  if (!std::ranges::is_sorted(state.inside) || !std::ranges::is_sorted(state.in_contact))
    throw InputError("contact: the points of a detector's state are not in ascending order; pass what state() returned.");
  swept_.visit_state(StateWriter{state});
  swept_.forget();
}

std::vector<Contact> ContactDetector::detect(const Motion& motion, ConstVectors x_t0, ConstVectors x_t1) {
  expect_usable(motion);
  measure_paths(x_t0, x_t1);
  if (!radius_.empty()) swept_.forget(), radius_.clear();  // the points had other radii in the previous step
  swept_.set_rounding(rounding_of(x_t1));
  return contacts_of(ArrayPoints(x_t0, x_t1, travel_), motion);
}

std::vector<Contact> ContactDetector::detect(const Motion& motion, ConstVectors x_t0, ConstVectors x_t1, const Numbers& radius) {
  expect_usable(motion);
  measure_paths(x_t0, x_t1);
  const double largest = note_radii(radius, x_t1.size());
  swept_.set_rounding(rounding_of(x_t1));
  return contacts_of(ArrayBalls(ArrayPoints(x_t0, x_t1, travel_), radius, largest), motion);
}

std::vector<std::size_t> ContactDetector::points_inside(const Pose& pose, ConstVectors x) const { return points_inside(pose, x, swept_.radius()); }

std::vector<std::size_t> ContactDetector::points_inside(const Pose& pose, ConstVectors x, const Numbers& radius) const {
  expect_usable(pose, "contact: ");
  expect_radii(radius, x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!is_finite(x[i])) throw RunError("contact: point " + std::to_string(i) + " is at " + in_words(x[i]) + ", which is not finite.");
    checked_radius(radius[i]);
  }
  return swept_.initial_overlap(ArrayBalls(ArrayPoints(x, x, {}), radius, 0), pose);
}

}  // namespace fccda
