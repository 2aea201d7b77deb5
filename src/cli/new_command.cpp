#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/starters.hpp"
#include "io/deck/did_you_mean.hpp"
#include "io/deck/json_schema.hpp"
#include "io/output/file.hpp"

namespace perimpact {

namespace fs = std::filesystem;

namespace {

/// Written next to the deck, so that editors find it independently of the installation.
constexpr const char* schema_name = "perimpact.schema.json";

const Starter& starter_called(const std::string& name) {
  const auto all = starters();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Starter& each) { return each.name == name; });
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const Starter& each : all) names.emplace_back(each.name);
  throw fccda::InputError(fmt::format("there is no starter deck {}; {}", name, deck::suggestion(name, names)));
}

}  // namespace

int new_command(const NewArguments& arguments) {
  const Starter& starter = starter_called(arguments.starter);
  const fs::path file = arguments.file.empty() ? fs::path(fmt::format("{}.yaml", starter.name)) : arguments.file;
  const fs::path schema = file.parent_path() / schema_name;
  if (fs::exists(file) && !arguments.force)
    throw fccda::InputError(fmt::format("{} already exists; choose another file, or overwrite it with --force.", file.string()));
  output::expect_place_for(file);

  const bool keeps_schema = fs::exists(schema) && !arguments.force;
  if (!keeps_schema) output::write_whole_file(schema, deck::json_schema());
  output::write_whole_file(file, fmt::format("# yaml-language-server: $schema={}\n{}", schema_name, starter.text));

  fmt::print("{} is a commented deck, ready to run; {}\n\n", file.string(),
             keeps_schema ? fmt::format("{} is kept.", schema.string()) : fmt::format("{} provides completion and checks in editors.", schema.string()));
  fmt::print("  perimpact check {0}    summary and estimated duration\n  perimpact run {0}      a minute or less on two cores\n", file.string());
  return 0;
}

}  // namespace perimpact
