#include <fmt/format.h>

#include "cli/commands.hpp"
#include "io/deck/describe.hpp"

namespace perimpact {

int describe_command(const std::string& key, bool markdown) {
  fmt::print("{}", markdown ? deck::describe_markdown() : deck::describe(key));
  return 0;
}

}  // namespace perimpact
