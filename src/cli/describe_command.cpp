#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "io/deck/describe.hpp"
#include "io/deck/json_schema.hpp"
#include "io/deck/reference_markdown.hpp"
#include "io/output/file.hpp"

namespace perimpact {

namespace {

void write_pages(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw fccda::InputError(fmt::format("{}: this folder cannot be created ({}); give another one.", folder.string(), failure.message()));
  const std::vector<deck::Page> pages = deck::reference_pages();
  for (const deck::Page& page : pages) output::expect_place_for(folder / page.file);
  for (const deck::Page& page : pages) output::write_whole_file(folder / page.file, page.text);
  fmt::print("The deck reference is in {}.\n", (folder / pages.front().file).string());
}

}  // namespace

int describe_command(const DescribeArguments& arguments) {
  if (!arguments.pages.empty())
    write_pages(arguments.pages);
  else if (arguments.is_schema)
    fmt::print("{}", deck::json_schema());
  else
    fmt::print("{}", deck::describe(arguments.key));
  return 0;
}

}  // namespace perimpact
