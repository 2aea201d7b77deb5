/// Writes one file of each kind to the given folder, for check_vtp.py, which evaluates the same formulas.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "fccda/contact_bounds/bounds_panels.hpp"
#include "io/output/pvd.hpp"
#include "io/output/vtp.hpp"

using namespace perimpact::output;

namespace {

void write_particles(const std::filesystem::path& path, std::size_t count, Compression compression) {
  std::vector<float> points(3 * count), displacement(3 * count);
  std::vector<double> energy(count);
  std::vector<std::int32_t> number(count);
  std::vector<std::uint8_t> even(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float x = static_cast<float>(i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      points[3 * i + axis] = x * static_cast<float>(axis + 1) / 1024;
      displacement[3 * i + axis] = (x + static_cast<float>(axis)) / 4096;
    }
    energy[i] = static_cast<double>(i) / 3;
    number[i] = 5 - static_cast<std::int32_t>(i);
    even[i] = i % 2 == 0;
  }
  write_vtp(path,
            {.points = std::span(points),
             .point_arrays = {{"displacement", 3, std::span(displacement)}, {"energy", 1, std::span(energy)}, {"a <b> & \"c\"", 1, std::span(number)}},
             .cell_arrays = {{"even", 1, std::span(even)}},
             .time = 1.0 / 3},
            compression);
}

void write_surface(const std::filesystem::path& path, Compression compression) {
  fccda::Panels panels;
  panels.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0.5, 1.0 / 3}};
  panels.add_quad(0, 1, 2, 3);
  panels.add_triangle(1, 4, 2);
  const std::vector<double> pressure = {2.5e6, -1};
  write_vtp(path, {.points = coordinates(panels.vertices), .panels = panels.panels, .cell_arrays = {{"pressure", 1, std::span(pressure)}}}, compression);
}

void write_region(const std::filesystem::path& path) {
  const fccda::Box boxes[] = {{{-1, -2, -3}, {1, 2, 3}}, {{4, 0, 0}, {5, 1, 1}}};
  const fccda::Panels region = fccda::panels_of(boxes);
  write_vtp(path, {.points = coordinates(region.vertices), .panels = region.panels}, Compression::none);
}

}  // namespace

int main(int, char** arguments) {
  const std::filesystem::path folder = arguments[1];
  for (const auto& [name, compression] : {std::pair("plain", Compression::none), {"zlib", Compression::zlib}}) {
    write_particles(folder / (std::string("particles_") + name + ".vtp"), 100'000, compression);
    write_particles(folder / (std::string("empty_") + name + ".vtp"), 0, compression);
    write_surface(folder / (std::string("surface_") + name + ".vtp"), compression);
  }
  write_region(folder / "region.vtp");
  Series series(folder, "series");
  for (const double time : {0.0, 1e-6}) {
    series.add(time, [](const std::filesystem::path& path) { write_particles(path, 10, Compression::none); });
  }
}
