#include "words.hpp"

#include <array>
#include <cstddef>
#include <regex>
#include <string_view>

namespace perimpact::python {

namespace {

struct Wording {
  std::string_view command_line, python;
};

// the more specific ones first
constexpr std::array wordings{
    Wording{"so there is nothing to resume; run without --resume.", "so there is nothing to resume; leave out resume=True."},
    Wording{"without --resume", "without resume=True"},
    Wording{"hoose another one with --out, or with output.folder in the deck.", "hoose another one."},
    Wording{"hoose another folder with --out, or with output.folder in the deck.", "hoose another folder."},
    Wording{"hoose another folder with --out or output.folder", "hoose another folder"},
    Wording{"pass it with --set or --out, where the shell expands it.", "expand it with os.path.expandvars."},
};

}  // namespace

std::string in_words_of_python(std::string sentence) {
  if (sentence.find("--") == std::string::npos) return sentence;
  for (const auto& [from, to] : wordings)
    for (std::size_t at = 0; (at = sentence.find(from, at)) != std::string::npos; at += to.size()) sentence.replace(at, from.size(), to);
  static const std::regex assignment(R"(with --set\s+([\w.]+)=(\S+)\.$)"), place_at_start("^--set (.*?): "), place("--set ([\\w.-]+)");
  sentence = std::regex_replace(sentence, assignment, "with $1 = $2 in the set-up.");
  sentence = std::regex_replace(sentence, place_at_start, "set[\"$1\"]: ");
  return std::regex_replace(sentence, place, "set[\"$1\"]");
}

}  // namespace perimpact::python
