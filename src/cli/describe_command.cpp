#include <fmt/format.h>

#include "cli/commands.hpp"
#include "io/deck/describe.hpp"

namespace perimpact {

int describe_command(const std::string& key) {
  fmt::print("{}", deck::describe(key));
  return 0;
}

}  // namespace perimpact
