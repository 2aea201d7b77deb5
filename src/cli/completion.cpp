#include "cli/completion.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/deck/did_you_mean.hpp"

namespace perimpact {

namespace {

/// Calls f(path, command) for the program and all commands below it; the path is the words that lead there, without the program.
template <class F>
void for_each_command(const Command& command, const std::vector<std::string>& path, const F& f) {
  f(path, command);
  for (const Command& one : command.commands) {
    std::vector<std::string> below = path;
    below.push_back(one.name);
    for_each_command(one, below, f);
  }
}

/// "-o,--out" as its two names.
std::vector<std::string> names_of(const Option& option) {
  const std::size_t comma = option.name.find(',');
  if (comma == std::string::npos) return {option.name};
  return {option.name.substr(0, comma), option.name.substr(comma + 1)};
}

std::vector<std::string> names_of(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const Command& one : commands) names.push_back(one.name);
  return names;
}

std::vector<const Option*> arguments_of(const Command& command) {
  std::vector<const Option*> all;
  for (const Option& option : command.options)
    if (option.is_argument()) all.push_back(&option);
  return all;
}

std::string escaped(const std::string& text, std::string_view characters) {
  std::string out;
  for (const char c : text) {
    if (characters.find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

/// Within single quotes of bash and zsh.
std::string within_quotes(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out;
}

std::string bash_offer(const Option& option) {
  if (!option.words.empty()) return fmt::format("words='{}'", fmt::join(option.words, " "));
  return option.completion == Completion::files ? "files=-f" : option.completion == Completion::folders ? "files=-d" : ":";
}

std::string bash_script(const Command& program) {
  std::string commands, takers, values, options, arguments;
  for_each_command(program, {}, [&](const std::vector<std::string>& path, const Command& command) {
    const std::string at = fmt::format("{}", fmt::join(path, " "));
    std::vector<std::string> dashed = {"--help"};
    for (const Option& option : command.options) {
      if (option.is_argument()) continue;
      for (const std::string& name : names_of(option)) {
        dashed.push_back(name);
        if (option.is_flag()) continue;
        takers += fmt::format("{}'{} {}'", takers.empty() ? "" : " | ", at, name);
        values += fmt::format("      '{} {}') {} ;;\n", at, name, bash_offer(option));
      }
    }
    options += fmt::format("      '{}') words='{}' ;;\n", at, fmt::join(dashed, " "));
    for (const Command& one : command.commands) commands += fmt::format("{}'{} {}'", commands.empty() ? "" : " | ", at, one.name);
    if (!command.commands.empty()) arguments += fmt::format("      '{} 0') words='{}' ;;\n", at, fmt::join(names_of(command.commands), " "));
    const std::vector<const Option*> by_position = arguments_of(command);
    for (std::size_t k = 0; k < by_position.size(); ++k) arguments += fmt::format("      '{} {}') {} ;;\n", at, k, bash_offer(*by_position[k]));
  });
  return fmt::format(R"(# bash completion for perimpact, written by `perimpact completion bash`
_perimpact() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" command='' option='' arguments=0 words='' files='' each k
  for ((k = 1; k < COMP_CWORD; ++k)); do
    each="${{COMP_WORDS[k]}}"
    if [[ -n "$option" ]]; then
      option=''
      continue
    fi
    case "$command $each" in
      {commands}) command="${{command:+$command }}$each" ;;
      {takers}) option="$each" ;;
      *' -'*) ;;
      *) arguments=$((arguments + 1)) ;;
    esac
  done
  if [[ -n "$option" ]]; then
    case "$command $option" in
{values}    esac
  elif [[ "$word" == -* ]]; then
    case "$command" in
{options}    esac
  else
    case "$command $arguments" in
{arguments}    esac
  fi
  COMPREPLY=()
  if [[ -n "$files" ]]; then
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen "$files" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  fi
}}
complete -F _perimpact perimpact
)",
                     fmt::arg("commands", commands), fmt::arg("takers", takers), fmt::arg("values", values), fmt::arg("options", options),
                     fmt::arg("arguments", arguments));
}

std::string zsh_offer(const Option& option) {
  if (!option.words.empty()) return fmt::format("({})", fmt::join(option.words, " "));
  return option.completion == Completion::files ? "_files" : option.completion == Completion::folders ? "_files -/" : " ";
}

/// One specification of _arguments, on a line of its own.
std::string zsh_specification(const Option& option, const std::string& name, std::size_t position) {
  const std::string help = within_quotes(escaped(option.help, "[]:\\"));
  if (option.is_argument()) return fmt::format(" \\\n    '{}:{}:{}'", position, option.name, zsh_offer(option));
  const std::string value = option.is_flag() ? "" : fmt::format(":{}:{}", escaped(option.value, ":"), zsh_offer(option));
  return fmt::format(" \\\n    '{}{}[{}]{}'", option.is_repeated() ? "*" : "", name, help, value);
}

std::string zsh_script(const Command& program) {
  std::string functions;
  for_each_command(program, {}, [&](std::vector<std::string> path, const Command& command) {
    path.insert(path.begin(), program.name);
    const std::string function = fmt::format("_{}", fmt::join(path, "_"));
    std::string specifications;
    std::size_t position = 0;
    for (const Option& option : command.options) {
      if (option.is_argument()) ++position;
      for (const std::string& name : names_of(option)) specifications += zsh_specification(option, name, position);
    }
    if (command.commands.empty()) {
      functions += fmt::format("{}() {{\n  _arguments \\\n    '--help[List the options]'{}\n}}\n\n", function, specifications);
      return;
    }
    std::string list, cases;
    for (const Command& one : command.commands) {
      list += fmt::format("\n        '{}:{}'", one.name, within_quotes(escaped(one.help, ":\\")));
      cases += fmt::format("        {}) {}_{} ;;\n", one.name, function, one.name);
    }
    functions += fmt::format(R"({0}() {{
  local context state state_descr line
  typeset -A opt_args
  _arguments -C \
    '--help[List the options]'{1} \
    '1: :->command' \
    '*:: :->rest'
  case $state in
    command)
      local -a commands=({2}
      )
      _describe command commands
      ;;
    rest)
      case $words[1] in
{3}      esac
      ;;
  esac
}}

)",
                             function, specifications, list, cases);
  });
  return fmt::format("#compdef perimpact\n# zsh completion for perimpact, written by `perimpact completion zsh`\n\n{}_perimpact \"$@\"\n", functions);
}

/// The condition of fish under which the words of the path were given, and none of the commands below.
std::string fish_condition(const std::vector<std::string>& path, const std::vector<std::string>& none_of) {
  std::string condition;
  for (const std::string& word : path) condition += fmt::format("{}__fish_seen_subcommand_from {}", condition.empty() ? "" : "; and ", word);
  if (!none_of.empty()) condition += fmt::format("{}not __fish_seen_subcommand_from {}", condition.empty() ? "" : "; and ", fmt::join(none_of, " "));
  return fmt::format("-n '{}'", condition);
}

std::string fish_script(const Command& program) {
  std::string lines;
  const auto help = [](const std::string& text) { return fmt::format("-d '{}'", escaped(text, "'\\")); };
  for_each_command(program, {}, [&](const std::vector<std::string>& path, const Command& command) {
    const std::vector<std::string> below = names_of(command.commands);
    const std::string here = path.empty() ? fish_condition({}, below) : fish_condition(path, below);
    for (const Command& one : command.commands) lines += fmt::format("complete -c perimpact {} -a {} {}\n", here, one.name, help(one.help));
    lines += fmt::format("complete -c perimpact {} -l help {}\n", here, help("List the options"));
    for (const Option& option : command.options) {
      const std::string words = option.words.empty() ? "" : fmt::format(" -a '{}'", fmt::join(option.words, " "));
      const std::string files = option.completion == Completion::nothing ? "" : " -F";
      if (option.is_argument()) {
        if (!words.empty()) lines += fmt::format("complete -c perimpact {}{} {}\n", fish_condition(path, option.words), words, help(option.help));
        if (!files.empty()) lines += fmt::format("complete -c perimpact {}{}\n", here, files);
        continue;
      }
      std::string names;
      for (const std::string& name : names_of(option)) names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      lines +=
          fmt::format("complete -c perimpact {}{}{} {}\n", here, names, option.is_flag() ? "" : (files.empty() ? " -x" : " -r -F") + words, help(option.help));
    }
  });
  return "# fish completion for perimpact, written by `perimpact completion fish`\ncomplete -c perimpact -f\n" + lines;
}

}  // namespace

const std::vector<std::string>& shells() {
  static const std::vector<std::string> names = {"bash", "zsh", "fish"};
  return names;
}

std::string completion_script(const Command& program, const std::string& shell) {
  if (shell == "bash") return bash_script(program);
  if (shell == "zsh") return zsh_script(program);
  if (shell == "fish") return fish_script(program);
  throw fccda::InputError(fmt::format("there is no completion for the shell {}; {}", shell, deck::suggestion(shell, shells())));
}

}  // namespace perimpact
