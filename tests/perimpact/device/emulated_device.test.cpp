#include "perimpact/device/emulated_device.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

using namespace perimpact;

TEST_CASE("emulated device: memory is not initialised to numbers, and copies outside of it are refused") {
  EmulatedDevice device;
  auto* const memory = static_cast<double*>(device.allocate(2 * sizeof(double)));
  std::vector<double> values(3, 1.0);
  device.download(values.data(), memory, 2 * sizeof(double));
  CHECK(std::isnan(values[0]));
  CHECK(std::isnan(values[1]));
  CHECK_THROWS_AS(device.download(values.data(), memory, 3 * sizeof(double)), std::logic_error);
  CHECK_THROWS_AS(device.upload(values.data(), memory, sizeof(double)), std::logic_error);
  CHECK(device.copied().uploaded == 0);
  CHECK(device.copied().downloaded == 2 * sizeof(double));
}

TEST_CASE("emulated device: each thread runs once, also of a block that is not full") {
  for (const std::size_t threads : {std::size_t{0}, std::size_t{1}, std::size_t{127}, std::size_t{128}, std::size_t{1000}}) {
    CAPTURE(threads);
    EmulatedDevice device;
    std::vector<double> x(threads + 1, 0.0), v(threads + 1, 1.0), f(threads + 1, 0.0);
    const Motion motion{{x.data(), x.data(), x.data()}, {v.data(), v.data(), v.data()}, {f.data(), f.data(), f.data()}, 0, 1};
    device.launch(device::AdvanceKernel{motion}, threads);  // adds 1 for each component
    for (std::size_t thread = 0; thread < threads; ++thread) CHECK(x[thread] == 3);
    CHECK(x[threads] == 0);
  }
}
