#include "fccda/modes/modes_file.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/finite.hpp"
#include "mesh_io/file/contents.hpp"
#include "mesh_io/file/inflate.hpp"
#include "mesh_io/file/text.hpp"
#include "mesh_io/file/words.hpp"

namespace fccda {
namespace {

constexpr std::string_view shape_prefix = "mode_", stress_prefix = "stress_", frequency_name = "frequency [Hz]", damping_name = "damping_ratio";
constexpr std::size_t shape_components = 3, stress_components = 6;

/// The 12 of mode_12; nothing for other names.
std::optional<std::size_t> number_of(std::string_view name, std::string_view prefix) {
  return name.starts_with(prefix) ? parsed<std::size_t>(name.substr(prefix.size())) : std::nullopt;
}

bool is_of_modes(std::string_view name, std::size_t /*components*/) {
  return number_of(name, shape_prefix) || number_of(name, stress_prefix) || name == frequency_name || name == damping_name;
}

/// Arrays such as mode_1 by their numbers.
using Numbered = std::map<std::size_t, const TupleArray*>;

class ModesOfArrays {
 public:
  ModesOfArrays(std::string file, PointData arrays) : file_(std::move(file)), arrays_(std::move(arrays)) {}

  ModesFile modes() {
    const Numbered shapes = numbered(shape_prefix, shape_components, "x, y and z"),
                   stresses = numbered(stress_prefix, stress_components, "xx, yy, zz, xy, yz and zx");
    if (shapes.empty()) fail("there are no modes; give point arrays mode_1, mode_2 and so on, with three components each.");
    expect_gapless(shapes);
    const std::vector<double> frequencies = of_file(frequency_name, shapes.size()), dampings = of_file(damping_name, shapes.size());
    if (frequencies.empty()) fail("there is no field data `frequency [Hz]`; give the frequency of each mode.");
    Modes modes;
    for (const auto& [number, shape] : shapes) {
      const std::size_t m = number - 1;
      const double damping = dampings.empty() ? 0 : dampings[dampings.size() == 1 ? 0 : m];
      expect_vibration(number, frequencies[m], damping);
      modes.push_back({.angular_frequency = 2 * std::numbers::pi * frequencies[m], .damping_ratio = damping, .shape = vectors(*shape)});
    }
    add_stresses(modes, stresses);
    return {file_, std::move(arrays_.points), std::move(modes)};
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) const { throw InputError(file_ + ": " + sentence); }

  Numbered numbered(std::string_view prefix, std::size_t components, std::string_view names) const {
    Numbered found;
    for (const TupleArray& one : arrays_.of_points) {
      const auto number = number_of(one.name, prefix);
      if (!number) continue;
      if (one.components != components)
        fail(one.name + " has " + std::to_string(one.components) + " components, but needs " + std::to_string(components) + ", " + std::string(names) + ".");
      if (!found.emplace(*number, &one).second) fail(excerpt(one.name) + " has the number of an array before it; number the arrays from 1.");
    }
    return found;
  }

  void expect_gapless(const Numbered& shapes) const {
    std::size_t expected = 1;
    for (const auto& [number, shape] : shapes) {
      if (number != expected)
        fail("there is " + excerpt(shape->name) + ", but no mode_" + std::to_string(expected) + "; number the modes from 1 without gaps.");
      ++expected;
    }
  }

  /// Field data with one number for each mode; of damping ratios also one for all. Empty where there are none.
  std::vector<double> of_file(std::string_view name, std::size_t modes) const {
    const auto found = std::find_if(arrays_.of_file.begin(), arrays_.of_file.end(), [&](const TupleArray& one) { return one.name == name; });
    if (found == arrays_.of_file.end()) return {};
    const bool is_one_for_all = name == damping_name && found->values.size() == 1;
    if (found->values.size() != modes && !is_one_for_all)
      fail("`" + std::string(name) + "` has " + std::to_string(found->values.size()) + " values for " + std::to_string(modes) +
           " modes; give one for each mode, in their order.");
    return found->values;
  }

  void expect_vibration(std::size_t number, double frequency, double damping) const {
    const std::string mode = "mode_" + std::to_string(number);
    if (!(frequency > 0))
      fail(mode + " has a frequency of " + in_words(frequency) +
           " Hz, but that of an elastic mode is positive; leave out rigid-body modes, because the impactor has its rigid motion without them.");
    if (!(damping >= 0 && damping < 1)) fail(mode + " has a damping ratio of " + in_words(damping) + ", but it must be at least 0 and below 1.");
  }

  static std::vector<Vec3d> vectors(const TupleArray& array) {
    std::vector<Vec3d> out;
    for (std::size_t k = 0; k < array.values.size(); k += 3) out.push_back({array.values[k], array.values[k + 1], array.values[k + 2]});
    return out;
  }

  void add_stresses(Modes& modes, const Numbered& stresses) const {
    if (stresses.empty()) return;
    for (const auto& [number, stress] : stresses)
      if (number < 1 || number > modes.size()) fail("there is " + excerpt(stress->name) + ", but no mode of this number; give its shape, or remove it.");
    for (std::size_t m = 0; m < modes.size(); ++m) {
      const auto found = stresses.find(m + 1);
      if (found == stresses.end()) fail("there is no stress_" + std::to_string(m + 1) + "; give the stresses of all modes, or of none.");
      const std::vector<double>& values = found->second->values;
      for (std::size_t k = 0; k < values.size(); k += stress_components) {
        SymmetricTensor& tensor = modes[m].stress.emplace_back();
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(k), stress_components, tensor.begin());
      }
    }
  }

  std::string file_;
  PointData arrays_;
};

}  // namespace

ModesFile read_modes(const std::filesystem::path& path) {
  const std::string file = path.string(), extension = unpacked(path).extension().string();
  if (is_word(extension, ".csv")) {
    const std::string stored = contents_of(path);
    return ModesOfArrays(file, parse_modes_csv(is_gzip(path) ? gunzip(stored, file) : stored, file)).modes();
  }
  if (!is_word(extension, ".vtu") && !is_word(extension, ".vtp") && !is_word(extension, ".vtk"))
    throw InputError(file + ": " + (extension.empty() ? "a file without extension" : shown(extension)) +
                     " is not a supported format of modes; the formats are .vtu, .vtp, .vtk and .csv.");
  return ModesOfArrays(file, read_point_arrays(path, is_of_modes)).modes();
}

}  // namespace fccda
