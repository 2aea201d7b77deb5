#include "cli/manual.hpp"

#include <fmt/format.h>

namespace perimpact {

namespace {

struct ExitStatus {
  const char *code, *meaning;
};
constexpr ExitStatus exit_codes[] = {
    {"0", "The command finished."},
    {"2", "Invalid input: command line, deck or another file."},
    {"3", "The run, or its output, could not continue; the sentence names the last checkpoint."},
    {"128 + n",
     "Signal n ended the command: 130 after Ctrl-C, 143 after SIGTERM. A run also ends its step on SIGHUP and SIGXCPU, and writes a checkpoint; on SIGUSR1 "
     "it writes one and continues."},
};

std::string usage_of(const std::string& path, const Command& command) {
  std::string text = path;
  for (const Option& option : command.options)
    if (option.is_argument()) text += option.is_required ? " " + option.name : " [" + option.name + "]";
  if (!command.commands.empty()) text += command.run ? " [command]" : " command";
  return text + " [options]";
}

/// "-o, --out FILE"
std::string form_of(const Option& option) {
  std::string text;
  for (const char c : option.name) text += c == ',' ? std::string(", ") : std::string(1, c);
  return option.value.empty() ? text : text + " " + option.value;
}

/// The sentence, with the possible values and the default.
std::string meaning_of(const Option& option) {
  std::string text = option.help;
  if (const auto* number = std::get_if<double*>(&option.target)) text += fmt::format("; default {}", **number);
  return text + ".";
}

/// Calls f(path, command) for all commands that do something.
template <class F>
void for_each_command(const std::string& path, const Command& command, const F& f) {
  for (const Command& one : command.commands) {
    f(path + " " + one.name, one);
    for_each_command(path + " " + one.name, one, f);
  }
}

/// Text as troff prints it: a dash that is to be copied, and no line that is read as a request.
std::string troff(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\\' ? std::string("\\e") : c == '-' ? std::string("\\-") : std::string(1, c);
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

/// A cell of a Markdown table.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : c == '<' ? std::string("&lt;") : std::string(1, c);
  return out;
}

}  // namespace

std::string manual_page(const Command& program) {
  std::string text = fmt::format(R"(.TH PERIMPACT 1 "2026-11-23" "perimpact {0}" "User commands"
.SH NAME
perimpact \- peridynamic bodies in contact with rigid bodies of any shape
.SH SYNOPSIS
.B perimpact
.I command
[\fIargument\fR ...] [\fIoptions\fR]
.SH DESCRIPTION
A deck, one YAML file, defines the deformable bodies, the rigid impactors, contact and the output of a run.
Results are tables (CSV) and frames (VTP) in a folder.
Every command has the option
.BR \-\-help .
.SH COMMANDS
)",
                                 PERIMPACT_VERSION);
  for_each_command(program.name, program, [&](const std::string& path, const Command& command) {
    text += fmt::format(".SS {}\n{}.\n", troff(usage_of(path, command)), troff(command.help));
    for (const Option& option : command.options) text += fmt::format(".TP\n.B {}\n{}\n", troff(form_of(option)), troff(meaning_of(option)));
  });
  text += ".SH EXIT STATUS\n";
  for (const ExitStatus& one : exit_codes) text += fmt::format(".TP\n.B {}\n{}\n", one.code, troff(one.meaning));
  return text + R"(.SH ENVIRONMENT
.TP
.B OMP_NUM_THREADS
Number of threads where \-\-threads is not given.
.TP
.B COLUMNS
Width of the progress line on a terminal that does not report its own.
.SH FILES
.TP
.I /usr/share/perimpact/cases
example decks with their results
.TP
.I /usr/share/doc/perimpact/html/index.html
the documentation, of the package perimpact-doc
)";
}

std::string manual_markdown(const Command& program) {
  std::string text = R"(# Command line

Written by `perimpact manual --markdown` from the table that parses the command line. `man perimpact` has the same content, and each command lists its
options with `--help`. `perimpact completion bash`, `zsh` or `fish` prints a completion script; the package installs them. Elsewhere, for bash:

    source <(perimpact completion bash)

What `check --json` and `run --progress json` print: [messages.md](messages.md).
)";
  for_each_command(program.name, program, [&](const std::string& path, const Command& command) {
    text += fmt::format("\n## {}\n\n    {}\n\n{}.\n", path, usage_of(path, command), command.help);
    if (command.options.empty()) return;
    text += "\n| option | meaning |\n|---|---|\n";
    for (const Option& option : command.options) text += fmt::format("| `{}` | {} |\n", form_of(option), cell(meaning_of(option)));
  });
  text += "\n## Exit status\n\n| status | meaning |\n|---|---|\n";
  for (const ExitStatus& one : exit_codes) text += fmt::format("| {} | {} |\n", one.code, one.meaning);
  return text;
}

}  // namespace perimpact
