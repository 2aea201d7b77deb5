#include "io/statistics/series.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "fixtures/tolerance.hpp"

using namespace perimpact;

namespace {

/// Unevenly spaced rows from 0.
std::vector<double> uneven_times(std::size_t rows, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> apart(0.1, 1.9);
  std::vector<double> times(rows, 0.0);
  for (std::size_t row = 1; row < rows; ++row) times[row] = times[row - 1] + apart(random);
  return times;
}

std::vector<double> noise(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(count);
  for (double& value : values) value = normal(random);
  return values;
}

}  // namespace

TEST_CASE("series: the mean of a constant is that constant, whatever the rows and the window") {
  const std::vector<double> times = uneven_times(200, 1), values(200, 3.25);
  for (const RowIs row_is : {RowIs::mean_since_row_before, RowIs::value_at_its_time}) {
    const Series series(times, values, row_is);
    for (const double t0 : {0.0, 0.3, 77.7}) {
      CHECK(series.mean(t0, times.back()) == fixtures::relative(3.25, 1e-14));  // a quotient of two sums of 200
      CHECK(series.standard_deviation(t0, times.back()) < 1e-13);
    }
  }
}

TEST_CASE("series: the mean force times the duration is the impulse, for all rows and for parts of rows") {
  const std::vector<double> times = {0, 1, 3, 3.5}, forces = {99, 4, -2, 10};  // the first row has no preceding interval
  const Series series(times, forces, RowIs::mean_since_row_before);
  CHECK(series.mean(0, 3.5) == fixtures::relative((4 * 1 - 2 * 2 + 10 * 0.5) / 3.5, 1e-15));
  CHECK(series.mean(0.5, 2) == fixtures::absolute((4 * 0.5 - 2 * 1) / 1.5, 4e-15, "N"));
  CHECK(series.mean(1, 3) == -2);
  const double mean = 5.0 / 3.5, square = (16 * 1 + 4 * 2 + 100 * 0.5) / 3.5;
  CHECK(series.standard_deviation(0, 3.5) == fixtures::relative(std::sqrt(square - mean * mean), 1e-14));
  CHECK(series.maximum(0, 3.5).value == 10);
  CHECK(series.maximum(0, 3.5).time == 3.5);
  CHECK(series.maximum(0, 3).value == 4);
  CHECK(series.maximum(0.2, 0.4).time == 1);  // the time of its row
  CHECK(series.minimum(0, 3.5).value == -2);
  CHECK(series.minimum(0, 3.5).time == 3);
}

TEST_CASE("series: instantaneous values are interpolated linearly") {
  const std::vector<double> times = {0, 2, 3}, values = {0, 4, 1};
  const Series series(times, values, RowIs::value_at_its_time);
  CHECK(series.mean(0, 3) == fixtures::relative((4.0 + 2.5) / 3, 1e-15));
  CHECK(series.mean(1, 2.5) == fixtures::relative((3 * 1 + 3.25 * 0.5) / 1.5, 1e-15));
  CHECK(series.maximum(0, 1).value == 2);
  CHECK(series.maximum(0, 3).time == 2);
  CHECK(series.minimum(2, 3).value == 1);
  // of 2 t from 0 to 2 the mean square about 2 is 4/3
  CHECK(series.standard_deviation(0, 2) == fixtures::relative(std::sqrt(4.0 / 3), 1e-15));
}

TEST_CASE("series: a window from row to row excludes the adjacent rows, also where its ends are rounded") {
  std::vector<double> times, values;
  for (int row = 0; row <= 70; ++row) times.push_back(row * 0.1), values.push_back(row);
  const Series series(times, values, RowIs::mean_since_row_before);
  bool is_rounded = false;
  for (int k = 0; k < 70; ++k) {
    const double begin = 7.0 * k / 70, end = 7.0 * (k + 1) / 70;
    is_rounded = is_rounded || begin != times[static_cast<std::size_t>(k)];
    CHECK(series.minimum(begin, end).value == k + 1);
    CHECK(series.maximum(begin, end).value == k + 1);
  }
  CHECK(is_rounded);  // else the check is void
}

TEST_CASE("series: resampling preserves the impulse, and leaves evenly spaced rows unchanged") {
  const std::vector<double> times = uneven_times(1000, 2), values = noise(1000, 3);
  const Series series(times, values, RowIs::mean_since_row_before);
  const std::size_t count = 313;
  const double interval = times.back() / static_cast<double>(count);
  double impulse = 0, wanted = 0;
  for (const double mean : series.resampled(0, interval, count)) impulse += mean * interval;
  for (std::size_t row = 1; row < 1000; ++row) wanted += values[row] * (times[row] - times[row - 1]);
  CHECK(impulse == fixtures::relative(wanted, 1e-11));  // rounding of a thousand numbers, some cancel

  std::vector<double> even;
  for (int row = 0; row < 1000; ++row) even.push_back(0.01 * row);
  const std::vector<double> same = Series(even, values, RowIs::mean_since_row_before).resampled(0, 0.01, 999);
  for (std::size_t k = 0; k < 999; ++k) CHECK(std::abs(same[k] - values[k + 1]) < 1e-9);  // slivers of rounded times
}
