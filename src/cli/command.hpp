/// The command line as one table: commands, their options, what they run. It is parsed (parse_command_line.hpp) and described by --help,
/// shell completion and manual pages (completion.hpp, manual.hpp).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace perimpact {

/// What an option sets: the type says how its text is read. A function is called with the text.
using OptionTarget = std::variant<bool*, int*, double*, std::string*, std::optional<std::string>*, std::filesystem::path*, std::vector<std::string>*,
                                  std::function<void(const std::string&)>>;

/// What the shell offers for a value.
enum class Completion { nothing, files, folders };

struct Option {
  std::string name;        ///< "--out", "-o,--out"; an argument, which is given by its position, has no dashes
  std::string value = {};  ///< the word for its value, such as FOLDER; empty for flags and arguments
  std::string help;
  OptionTarget target;
  Completion completion = Completion::nothing;
  std::vector<std::string> words = {};  ///< the possible values, where there are few
  std::optional<std::pair<double, double>> range = {};
  bool is_required = false;
  bool splits_at_commas = false;
  std::vector<std::string> excludes = {};  ///< names of options that cannot be given too

  bool is_argument() const { return !name.starts_with('-'); }
  bool is_flag() const { return std::holds_alternative<bool*>(target); }
  bool is_repeated() const { return std::holds_alternative<std::vector<std::string>*>(target); }
};

struct Command {
  std::string name;
  std::string help;
  std::vector<Option> options = {};
  std::function<int()> run = {};  ///< exit code; empty where one of `commands` is needed
  std::vector<Command> commands = {};
};

}  // namespace perimpact
