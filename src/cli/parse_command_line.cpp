// Only this file includes CLI11, which is slow to compile.
#include "cli/parse_command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

#include "base/error.hpp"

namespace perimpact {

namespace {

CLI::Option* add_to(CLI::App& app, const Option& option) {
  return std::visit(
      [&]<class Target>(const Target& target) -> CLI::Option* {
        if constexpr (std::is_same_v<Target, bool*>)
          return app.add_flag(option.name, *target, option.help);
        else if constexpr (std::is_same_v<Target, std::function<void(const std::string&)>>)
          return app.add_option_function<std::string>(option.name, target, option.help);
        else if constexpr (std::is_same_v<Target, std::vector<std::string>*>)
          return app.add_option(option.name, *target, option.help)->allow_extra_args(false);
        else if constexpr (std::is_same_v<Target, double*>)
          return app.add_option(option.name, *target, option.help)->capture_default_str();
        else
          return app.add_option(option.name, *target, option.help);
      },
      option.target);
}

CLI::Validator is_one_of(std::vector<std::string> words) {
  const auto complaint = [words = std::move(words)](std::string& text) {
    const bool is_known = std::find(words.begin(), words.end(), text) != words.end();
    return is_known ? std::string() : fmt::format("{} is unknown, known are {}", text, fmt::join(words, ", "));
  };
  return {complaint, ""};
}

void add_to(CLI::App& app, const Command& command) {
  std::map<std::string, CLI::Option*> added;
  for (const Option& option : command.options) {
    CLI::Option* const one = added[option.name] = add_to(app, option);
    if (!option.value.empty()) one->type_name(option.value);
    if (option.is_required) one->required();
    if (option.splits_at_commas) one->delimiter(',');
    if (option.range && std::holds_alternative<int*>(option.target))
      one->check(CLI::Range(static_cast<int>(option.range->first), static_cast<int>(option.range->second)));
    else if (option.range)
      one->check(CLI::Range(option.range->first, option.range->second));
    if (!option.words.empty() && !option.is_argument()) one->check(is_one_of(option.words));
    for (const std::string& other : option.excludes) one->excludes(added.at(other));
  }
  for (const Command& one : command.commands) add_to(*app.add_subcommand(one.name, one.help), one);
  app.require_subcommand(command.commands.empty() ? 0 : command.run ? 0 : 1, command.commands.empty() ? 0 : 1);
}

/// Error of CLI11 as one sentence with the relevant help command.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto commands = app.get_subcommands();
  if (!commands.empty()) return fmt::format("{}; perimpact {} --help lists the options.", error.what(), commands.front()->get_name());
  const auto rest = app.remaining();
  return rest.empty() ? "a command is needed; perimpact --help lists them." : fmt::format("{} is not a command; perimpact --help lists them.", rest.front());
}

/// The innermost command that was given.
const Command& chosen(const CLI::App& app, const Command& command) {
  for (const CLI::App* each : app.get_subcommands())
    for (const Command& one : command.commands)
      if (one.name == each->get_name()) return chosen(*each, one);
  return command;
}

}  // namespace

std::function<int()> parse_command_line(const Command& program, int argc, const char* const* argv) {
  CLI::App app{program.help, program.name};
  add_to(app, program);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {  // of the innermost command that was given
    return [text = app.help()] {
      fmt::print("{}", text);
      return 0;
    };
  } catch (const CLI::ParseError& error) {
    throw fccda::InputError(usage_error(app, error));
  }
  return chosen(app, program).run;
}

}  // namespace perimpact
