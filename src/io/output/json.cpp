#include "io/output/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace perimpact::output {

namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;  // deduction guide required by clang before version 17

/// Quotes a string and escapes quotes, backslashes and control characters (RFC 8259, section 7); the rest is passed through as UTF-8.
std::string quoted(std::string_view words) {
  std::string text = "\"";
  for (const char c : words) {
    if (c == '"' || c == '\\') {
      text += {'\\', c};
    } else if (c == '\n') {
      text += "\\n";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      text += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      text += c;
    }
  }
  return text + '"';
}

std::string indent(int level) { return std::string(static_cast<std::size_t>(2 * level), ' '); }

}  // namespace

Json& Json::operator[](std::string_view name) {
  if (std::holds_alternative<std::monostate>(value_)) value_ = Members{};
  EXPECTS(std::holds_alternative<Members>(value_));
  Members& members = std::get<Members>(value_);
  const auto found = std::find_if(members.begin(), members.end(), [&](const auto& member) { return member.first == name; });
  return found != members.end() ? found->second : members.emplace_back(name, Json()).second;
}

void Json::push_back(Json element) {
  if (std::holds_alternative<std::monostate>(value_)) value_ = Elements{};
  EXPECTS(std::holds_alternative<Elements>(value_));
  std::get<Elements>(value_).push_back(std::move(element));
}

void Json::append(const Json& object) {
  EXPECTS(std::holds_alternative<Members>(object.value_));
  for (const auto& [name, value] : std::get<Members>(object.value_)) (*this)[name] = value;
}

std::string Json::line() const {
  std::string text;
  add_to(text, std::nullopt);
  return text + '\n';
}

std::string Json::text() const {
  std::string text;
  add_to(text, 0);
  return text + '\n';
}

void Json::add_to(std::string& text, std::optional<int> level) const {
  const std::optional<int> below = level ? std::optional(*level + 1) : std::nullopt;
  // Numbers and words of an array share a line; nested arrays and objects have separate lines.
  const auto is_simple = [](const Json& json) { return !std::holds_alternative<Elements>(json.value_) && !std::holds_alternative<Members>(json.value_); };
  const auto add_list = [&](const auto& list, char open, char close, bool is_short, const auto& add_one) {
    const bool on_one_line = is_short || !level;
    const std::string gap = on_one_line ? "" : "\n" + indent(*below);
    text += open;
    for (std::size_t i = 0; i < list.size(); ++i) {
      text += (i == 0 ? "" : on_one_line ? ", " : ",") + gap;
      add_one(list[i]);
    }
    if (!on_one_line) text += "\n" + indent(*level);
    text += close;
  };
  std::visit(Overloaded{[&](std::monostate) { text += "null"; }, [&](bool value) { text += value ? "true" : "false"; },
                        [&](std::int64_t value) { fmt::format_to(std::back_inserter(text), "{}", value); },
                        [&](double value) { text += std::isfinite(value) ? fmt::format("{}", value) : "null"; },
                        [&](const std::string& value) { text += quoted(value); },
                        [&](const Elements& elements) {
                          const bool on_one_line = std::all_of(elements.begin(), elements.end(), is_simple);
                          add_list(elements, '[', ']', on_one_line, [&](const Json& element) { element.add_to(text, below); });
                        },
                        [&](const Members& members) {
                          add_list(members, '{', '}', members.empty(), [&](const auto& member) {
                            text += quoted(member.first) + ": ";
                            member.second.add_to(text, below);
                          });
                        },
                        [&](const Verbatim& json) {
                          for (const char c : json.text) text += c != '\n' ? std::string(1, c) : level ? "\n" + indent(*level) : " ";
                        }},
             value_);
}

}  // namespace perimpact::output
