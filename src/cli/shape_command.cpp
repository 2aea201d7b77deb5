#include "cli/shape_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <type_traits>

#include "base/error.hpp"
#include "cli/mesh_report.hpp"
#include "cli/surface_text.hpp"
#include "io/deck/overrides.hpp"
#include "io/deck/reader.hpp"
#include "io/deck/reference.hpp"
#include "io/output/surface_file.hpp"
#include "marine/wageningen.hpp"
#include "mesh/inspect/volume_below.hpp"
#include "perimpact/impactor/generated_shape.hpp"
#include "perimpact/impactor/surface_of.hpp"

namespace perimpact {

using namespace fccda;

namespace {

std::string_view sentence_of(std::string_view shape) {
  constexpr std::pair<std::string_view, std::string_view> known[] = {{"cylinder", "A circular cylinder"},
                                                                     {"sphere", "A sphere, subdivided from an icosahedron"},
                                                                     {"box", "A box"},
                                                                     {"hull", "The hull of an icebreaker, from its main dimensions and angles"},
                                                                     {"propeller", "A propeller: Wageningen B-series, or user-defined sections"}};
  const auto found = std::find_if(std::begin(known), std::end(known), [&](const auto& one) { return one.first == shape; });
  return found == std::end(known) ? "" : found->second;
}

std::string option_name(std::string key) {
  std::replace_if(
      key.begin(), key.end(), [](char c) { return c == '_' || c == '.'; }, '-');
  return "--" + key;
}

/// Without its last full stop, as in the table of commands.
std::string help_of(const deck::Entry& entry) {
  const std::string range = entry.range.empty() ? "" : ", " + entry.range;
  std::string help = fmt::format("{}{}; {}. {}", entry.form, range, entry.need, entry.sentence);
  if (help.ends_with('.')) help.pop_back();
  return help;
}

/// The map of the options, as below `surface` in a deck.
deck::YamlNode map_of(const ShapeArguments& arguments) {
  deck::YamlNode map{.kind = deck::YamlNode::Kind::map, .place = "perimpact shape " + arguments.shape};
  for (const auto& [option, text] : arguments.values) deck::set_value(map, option.key, text, option.name);
  return map;
}

/// Throws InputError if a required option is missing.
void expect_complete(const ShapeArguments& arguments) {
  const auto kind = std::ranges::find(shape_kinds(), arguments.shape, &ShapeKind::name);
  for (const ShapeOption& option : kind->options) {
    const bool is_given = std::ranges::any_of(arguments.values, [&](const auto& value) { return value.first.key == option.key; });
    if (option.required.empty() || is_given) continue;
    throw InputError(fmt::format("perimpact shape {0}: {1} is missing, a {2}; perimpact shape {0} --help lists the options.", arguments.shape, option.name,
                                 option.required));
  }
}

SurfaceSetup setup_of(const ShapeArguments& arguments) {
  expect_complete(arguments);
  const deck::YamlNode map = map_of(arguments);
  Places places("perimpact shape " + arguments.shape);
  SurfaceSetup setup;
  deck::for_each_alternative(SurfaceSetup{}, [&]<class T>(const T& alternative) {
    if (T::name == arguments.shape) deck::Reader(map, arguments.shape, map.place, places).read(setup.emplace<T>(alternative));
  });
  return setup;
}

using Rows = std::vector<std::pair<std::string, std::string>>;

template <class Setup>
Rows facts_of(const Setup&, const Surface&) {
  return {};
}

Rows facts_of(const HullSurface& setup, const Surface& surface) {
  const HullForm form(shape_of(setup));
  const double displaced = volume_below(surface, 0);
  return {{"bow, stern", fmt::format("{:.5g} and {:.5g} m long", form.bow_length(), form.stern_length())},
          {"displacement", fmt::format("{:.5g} m3 below z = 0", displaced)},
          {"block coeff.", fmt::format("{:.4g}", displaced / (setup.length * setup.breadth * setup.draft))}};
}

Rows facts_of(const PropellerSurface& setup, const Surface&) {
  const PropellerShape shape = shape_of(setup);
  const BladeForm form(shape);
  const BladeForm::Section section = form.section(0.7 * form.tip_radius());
  const double from = shape.sections ? shape.hub_ratio : wageningen::hub;
  const std::string beyond = fmt::format("{:.4g} outside r/R = {:.4g}", form.expanded_area_ratio(from), from);
  return {{"area ratio", "expanded " + beyond + (shape.sections ? "" : fmt::format(", {:.4g} outside this hub", form.expanded_area_ratio(shape.hub_ratio)))},
          {"at 0.7 R", fmt::format("chord {:.4g} m, thickness {:.4g} m, pitch angle {:.4g} deg", section.chord, section.thickness,
                                   section.pitch_angle * 180 / std::numbers::pi)},
          {"blades", fmt::format("from {:.4g} to {:.4g} m", form.root_radius(), form.tip_radius())}};
}

}  // namespace

const std::vector<ShapeKind>& shape_kinds() {
  static const std::vector<ShapeKind> kinds = [] {
    std::vector<ShapeKind> all;
    deck::for_each_alternative(SurfaceSetup{}, [&]<class T>(const T&) {
      if constexpr (!std::is_same_v<T, FileSurface>) {
        ShapeKind& kind = all.emplace_back(ShapeKind{std::string(T::name), sentence_of(T::name), {}});
        const std::string path = fmt::format("impactors.{}.surface.{}.", deck::any_name, T::name);
        for (const deck::Entry& entry : deck::reference()) {
          if (entry.is_map || !entry.path.starts_with(path)) continue;
          const std::string key = entry.path.substr(path.size());
          const bool is_required = entry.need == "required" && key.find('.') == std::string::npos;  // keys of a nested map: where it is given
          kind.options.push_back({key, option_name(key), help_of(entry), is_required ? entry.form : ""});
        }
      }
    });
    return all;
  }();
  return kinds;
}

int shape_command(const ShapeArguments& arguments) {
  if (!arguments.out.empty()) output::expect_surface_file(arguments.out);
  const SurfaceSetup setup = setup_of(arguments);
  const Surface surface = surface_of(setup, arguments.shape).surface;
  fmt::print("{}\n{}{}", arguments.shape, surface_text(surface.report()), defects_text(surface, self_intersections(surface, Bvh(surface))));
  const Rows facts = std::visit([&](const auto& chosen) { return facts_of(chosen, surface); }, setup);
  for (const auto& [name, value] : facts) fmt::print("  {:<18}{}\n", name, value);
  if (!arguments.out.empty()) {
    output::write_surface(arguments.out, surface);
    fmt::print("  the surface is in {}\n", arguments.out.string());
  }
  return 0;
}

int list_shapes() {
  for (const ShapeKind& kind : shape_kinds()) fmt::print("{:<12}{}.\n", kind.name, kind.sentence);
  fmt::print("perimpact shape NAME --help lists the options of each.\n");
  return 0;
}

}  // namespace perimpact
