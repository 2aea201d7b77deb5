#include <fmt/format.h>

#include "cli/commands.hpp"
#include "io/deck/describe.hpp"
#include "io/deck/json_schema.hpp"

namespace perimpact {

int describe_command(const DescribeArguments& arguments) {
  switch (arguments.form) {
    case DescribeForm::text:
      fmt::print("{}", deck::describe(arguments.key));
      break;
    case DescribeForm::markdown:
      fmt::print("{}", deck::describe_markdown());
      break;
    case DescribeForm::schema:
      fmt::print("{}", deck::json_schema());
      break;
  }
  return 0;
}

}  // namespace perimpact
