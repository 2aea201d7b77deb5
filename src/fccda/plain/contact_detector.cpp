#include "fccda/plain/contact_detector.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "fccda/core/error.hpp"
#include "fccda/core/parallel.hpp"

namespace fccda {

namespace {

/// Points of which one bound on the way they went is kept: enough that a block costs little, few enough that a fast point wakes few.
constexpr std::size_t block_size = 64;

/// Ways of fewer points are measured (in 25 µs) before other threads have woken.
constexpr std::ptrdiff_t blocks_worth_threads = 128;

std::size_t blocks_of(std::size_t points) { return (points + block_size - 1) / block_size; }

/// Arrays as the Points interface.
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

double checked_radius(double radius) {
  if (radius >= 0 && std::isfinite(radius)) return radius;
  std::ostringstream text;
  text << "contact: the contact radius is " << radius << " m, but it must be a number of at least 0; 0 is for points without extent.";
  throw InputError(text.str());
}

std::string text_of(const Vec3d& x) {
  std::ostringstream text;
  text << '(' << x.x << ", " << x.y << ", " << x.z << ')';
  return text.str();
}

/// Visitors of Swept::visit_state.
struct StateReader {
  ContactDetector::State& state;
  void operator()(std::string_view name, const std::vector<std::uint64_t>& numbers) const {
    (name == "points_inside" ? state.inside : state.touched) = numbers;
  }
  void operator()(std::string_view name, const std::uint64_t& number) const { (name == "entered_inside" ? state.entered : state.renumbered) = number; }
};

struct StateWriter {
  const ContactDetector::State& state;
  void operator()(std::string_view name, std::vector<std::uint64_t>& numbers) const { numbers = name == "points_inside" ? state.inside : state.touched; }
  void operator()(std::string_view name, std::uint64_t& number) const { number = name == "entered_inside" ? state.entered : state.renumbered; }
};

double squared_way(ConstVectors x_t0, ConstVectors x_t1, std::size_t i) { return squared_norm(x_t1[i] - x_t0[i]); }

[[noreturn]] void complain_of_way(ConstVectors x_t0, ConstVectors x_t1) {
  std::size_t i = 0;
  while (std::isfinite(squared_way(x_t0, x_t1, i))) ++i;
  throw RunError("contact: point " + std::to_string(i) + " goes from " + text_of(x_t0[i]) + " to " + text_of(x_t1[i]) +
                 " in one step, which is no way to go; the solver has become unstable, try a shorter step.");
}

}  // namespace

ContactDetector::ContactDetector(Surface surface, const Options& options)
    : swept_(std::make_shared<const Surface>(std::move(surface)), options.region, checked_radius(options.radius)),
      centre_(swept_.surface().report().bounds.centre()),
      reach_(swept_.surface().radius_about(centre_)) {}

std::vector<Contact> ContactDetector::detect(const Motion& motion, ConstVectors x_t0, ConstVectors x_t1) {
  if (x_t0.size() != x_t1.size())
    throw InputError("contact: there are " + std::to_string(x_t0.size()) + " points at the beginning of the step and " + std::to_string(x_t1.size()) +
                     " at its end; give both positions of every point.");
  travel_.resize(blocks_of(x_t0.size()));
  const auto measure = [&](std::ptrdiff_t block) {
    const std::size_t begin = static_cast<std::size_t>(block) * block_size, end = std::min(begin + block_size, x_t0.size());
    double longest = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const double squared = squared_way(x_t0, x_t1, i);
      if (!(squared <= longest)) longest = squared;
      if (std::isnan(longest)) break;  // nothing compares with it
    }
    travel_[static_cast<std::size_t>(block)] = std::sqrt(longest);
  };
  const auto blocks = static_cast<std::ptrdiff_t>(travel_.size());
  if (blocks < blocks_worth_threads)
    for (std::ptrdiff_t block = 0; block < blocks; ++block) measure(block);
  else
    parallel_for(blocks, measure);
  if (!std::ranges::all_of(travel_, [](double travel) { return std::isfinite(travel); })) complain_of_way(x_t0, x_t1);

  std::vector<Contact> contacts;
  const double reach = norm(motion.centre - centre_) + reach_;  // of the surface from the centre of its turn
  swept_.detect(ArrayPoints(x_t0, x_t1, travel_), motion, travel_bound(motion, motion.centre, reach), contacts);
  return contacts;
}

ContactDetector::State ContactDetector::state() const {
  State state;
  swept_.visit_state(StateReader{state});
  return state;
}

void ContactDetector::resume(const State& state) {
  if (!std::ranges::is_sorted(state.inside) || !std::ranges::is_sorted(state.touched))
    throw InputError("contact: the points of a detector's state are not in rising order; give back what state() returned.");
  swept_.visit_state(StateWriter{state});
  swept_.forget();
}

std::vector<std::size_t> ContactDetector::points_inside(const Pose& pose, ConstVectors x) const { return swept_.starting_inside(ArrayPoints(x, x, {}), pose); }

}  // namespace fccda
