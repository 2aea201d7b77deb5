#include "io/deck/reference_markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <span>
#include <stdexcept>
#include <string_view>

#include "base/error.hpp"
#include "io/deck/key_path.hpp"
#include "io/deck/reference.hpp"
#include "io/deck/reference_text.hpp"

namespace perimpact::deck {

namespace {

/// A key of a map, with all alternatives of the map that have it.
struct Row {
  const Entry* entry;
  std::vector<std::string> conditions;
};

/// Keys of one map, or of several maps with the same keys.
struct Section {
  std::vector<std::string> maps;  ///< their paths
  std::string alternative;        ///< "file" for the keys that are allowed beside this one only
  std::vector<Row> rows;
  std::string heading;  ///< differs from all others of the page
};

bool is_same_key(const Entry& a, const Entry& b) {
  return a.key() == b.key() && a.form == b.form && a.range == b.range && a.need == b.need && a.sentence == b.sentence;
}

bool holds_names_only(const Entry& map) {
  return std::any_of(reference().begin(), reference().end(), [&](const Entry& inner) { return inner.key() == any_name && inner.parent() == map.path; });
}

/// The part of "with file" that is a key; empty for "with model: ordinary-state".
std::string flat_alternative(const Entry& entry) {
  constexpr std::string_view with = "with ";
  return entry.condition.empty() || entry.condition.find(':') != std::string::npos ? "" : entry.condition.substr(with.size());
}

std::vector<Row> rows_of(std::string_view map, const std::string& alternative) {
  std::vector<Row> rows;
  for (const Entry& entry : reference()) {
    if (entry.parent() != map || flat_alternative(entry) != alternative) continue;
    const auto same = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return is_same_key(*row.entry, entry); });
    Row& row = same == rows.end() ? rows.emplace_back(Row{&entry, {}}) : *same;
    if (alternative.empty() && !entry.condition.empty()) row.conditions.push_back(entry.condition);
  }
  return rows;
}

bool is_same(const std::vector<Row>& a, const std::vector<Row>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Row& one, const Row& other) { return one.conditions == other.conditions && is_same_key(*one.entry, *other.entry); });
}

std::vector<std::string> alternatives_in(std::string_view map) {
  std::vector<std::string> all = {""};
  for (const Entry& entry : reference())
    if (entry.parent() == map && std::find(all.begin(), all.end(), flat_alternative(entry)) == all.end()) all.push_back(flat_alternative(entry));
  return all;
}

/// "holes" of bodies.<name>.holes.<name>, "box" of bodies.<name>.shape.box.
std::string_view last_key(std::string_view map) {
  std::vector<std::string_view> keys = keys_of(map);
  while (keys.back() == any_name) keys.pop_back();
  return keys.back();
}

/// `a`, `b`: each once.
std::string as_code(std::vector<std::string_view> names) {
  std::vector<std::string> each;
  for (const std::string_view name : names) {
    const std::string code = fmt::format("`{}`", name);
    if (std::find(each.begin(), each.end(), code) == each.end()) each.push_back(code);
  }
  return fmt::format("{}", fmt::join(each, ", "));
}

void add_headings(std::vector<Section>& sections) {
  for (Section& section : sections) {
    std::vector<std::string_view> names, parents;
    for (const std::string& map : section.maps) {
      names.push_back(last_key(map));
      parents.push_back(last_key(std::string_view(map).substr(0, std::max(map.rfind('.'), std::size_t{1}))));
    }
    section.heading = as_code(names);
    if (!section.alternative.empty()) section.heading += fmt::format(" with `{}`", section.alternative);
    const bool is_taken =
        std::any_of(sections.begin(), sections.end(), [&](const Section& other) { return &other != &section && other.heading == section.heading; });
    if (is_taken) section.heading += " in " + as_code(parents);
  }
}

std::vector<Section> sections_of(const PageText* page) {
  std::vector<Section> sections;
  const auto add = [&](std::string_view map) {
    for (const std::string& alternative : alternatives_in(map)) {
      const std::vector<Row> rows = rows_of(map, alternative);
      if (rows.empty() && !alternative.empty()) continue;
      const auto same = std::find_if(sections.begin(), sections.end(), [&](const Section& section) {
        return !rows.empty() && section.alternative == alternative && is_same(section.rows, rows);
      });
      if (same == sections.end())
        sections.push_back({{std::string(map)}, alternative, rows, ""});
      else if (std::find(same->maps.begin(), same->maps.end(), map) == same->maps.end())
        same->maps.emplace_back(map);
    }
  };
  if (!page) add(top_level);
  std::vector<std::string_view> seen;
  for (const Entry& entry : reference()) {
    if (!entry.is_map || page_of(entry.path) != page || holds_names_only(entry)) continue;
    if (std::find(seen.begin(), seen.end(), entry.path) != seen.end()) continue;  // once for each alternative around it
    seen.push_back(entry.path);
    add(entry.path);
  }
  add_headings(sections);
  return sections;
}

/// The place that a heading has on its page.
std::string anchor_of(std::string_view heading) {
  std::string anchor;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-') anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

/// Text in a table: a bar would end the cell, and <name> would be HTML.
std::string in_table(std::string_view text) {
  std::string out;
  bool is_code = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '`') is_code = !is_code;
    const bool is_tag = text[k] == '<' && !is_code && k + 1 < text.size() && std::isalpha(static_cast<unsigned char>(text[k + 1])) != 0;
    if (text[k] == '|' || is_tag) out += '\\';
    out += text[k];
  }
  return out;
}

const Section& section_with(std::span<const Section> sections, std::string_view map) {
  const std::string of_names = fmt::format("{}.{}", map, any_name);
  const auto found = std::find_if(sections.begin(), sections.end(), [&](const Section& section) {
    return section.alternative.empty() &&
           std::any_of(section.maps.begin(), section.maps.end(), [&](const std::string& each) { return each == map || each == of_names; });
  });
  if (found == sections.end()) throw std::logic_error(fmt::format("no page has a section for {}", map));
  return *found;
}

std::string link_to(const Entry& map, const PageText* page, std::span<const Section> sections) {
  const PageText* other = page_of(fmt::format("{}.{}", map.path, any_name));  // bodies itself is on no page, bodies.<name> is
  if (!other) throw std::logic_error(fmt::format("no page describes {}", map.path));
  if (other != page) return fmt::format("map, see [{}]({}.md)", other->title, other->name);
  const std::string& heading = section_with(sections, map.path).heading;
  return fmt::format("map, see [{}](#{})", heading, anchor_of(heading));
}

/// Its own sentence, or for a map of names the one of what they name.
std::string_view sentence_of(const Entry& entry) {
  if (!entry.sentence.empty()) return entry.sentence;
  for (const Entry& inner : reference())
    if (inner.key() == any_name && inner.parent() == entry.path) return inner.sentence;
  return "";
}

/// "with model: a, b" where not all alternatives have the key.
std::string condition_of(const Row& row, const Section& section) {
  std::size_t most = 0;
  for (const Row& each : section.rows) most = std::max(most, each.conditions.size());
  if (row.conditions.empty() || row.conditions.size() == most) return "";
  std::vector<std::string> names;
  for (const std::string& condition : row.conditions) names.push_back(condition.substr(condition.find(": ") + 2));
  const std::string& first = row.conditions.front();
  return fmt::format("({}: {}) ", first.substr(0, first.find(": ")), fmt::join(names, ", "));
}

std::string without_default(std::string_view need) {
  constexpr std::string_view word = "default ";
  return need.starts_with(word) ? fmt::format("`{}`", need.substr(word.size())) : std::string(need.starts_with("one of ") ? "one of these" : need);
}

std::string table_of(const Section& section, const PageText* page, std::span<const Section> sections) {
  if (section.rows.empty()) return "It has no keys: `{}`.\n";
  std::string out = "| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const Row& row : section.rows) {
    const Entry& entry = *row.entry;
    const std::string form = entry.is_map ? link_to(entry, page, sections) : entry.range.empty() ? entry.form : fmt::format("{}, {}", entry.form, entry.range);
    out += fmt::format("| `{}` | {} | {} | {} |\n", entry.key(), in_table(form), without_default(entry.need),
                       in_table(condition_of(row, section) + std::string(sentence_of(entry))));
  }
  return out;
}

/// Sentences and paths of a section's maps.
std::string introduction(const Section& section) {
  const auto sentence = [&](const std::string& map) -> std::string_view {
    const auto entry = std::find_if(reference().begin(), reference().end(), [&](const Entry& each) { return each.path == map; });
    return entry == reference().end() || !section.alternative.empty() ? "" : std::string_view(entry->sentence);
  };
  const std::string_view first = sentence(section.maps.front());
  const bool is_common = std::all_of(section.maps.begin(), section.maps.end(), [&](const std::string& map) { return sentence(map) == first; });
  std::string out = is_common && !first.empty() ? fmt::format("{}\n\n", first) : "";
  for (const std::string& map : section.maps)
    out += fmt::format("{}`{}`{}{}\n", section.maps.size() > 1 ? "- " : "", map, is_common ? "" : ": ", is_common ? "" : sentence(map));
  return out + "\n";
}

/// The keys of the page as they nest, with the form of their values.
std::string syntax_of(const PageText& page, std::span<const Section> sections) {
  std::string out = "```yaml\n";
  std::vector<std::string> above;  // maps that enclose the last line
  std::vector<std::string_view> written;
  const auto open = [&](std::string_view map) {
    const std::vector<std::string_view> keys = keys_of(map);
    const std::vector<std::string> wanted(keys.begin(), keys.end());
    std::size_t common = 0;
    while (common < above.size() && common < wanted.size() && above[common] == wanted[common]) ++common;
    for (std::size_t level = common; level < wanted.size(); ++level) out += fmt::format("{:{}}{}:\n", "", 2 * level, wanted[level]);
    above = wanted;
  };
  for (const Entry& entry : reference()) {
    const std::string map(entry.parent());
    const auto section = std::find_if(sections.begin(), sections.end(), [&](const Section& each) {
      return each.maps.front() == map && std::any_of(each.rows.begin(), each.rows.end(), [&](const Row& row) { return row.entry == &entry; });
    });
    if (section == sections.end() || entry.key() == any_name || std::find(written.begin(), written.end(), entry.path) != written.end()) continue;
    written.push_back(entry.path);
    const bool is_here = entry.is_map && page_of(entry.path) == &page;
    const bool is_shown_below =
        is_here && std::any_of(sections.begin(), sections.end(), [&](const Section& each) {
          return !each.rows.empty() && (each.maps.front() == entry.path || each.maps.front() == fmt::format("{}.{}", entry.path, any_name));
        });
    if (is_shown_below) continue;  // opened by its first key
    open(map);
    const std::string note = entry.need == "required" ? "  # required" : "";
    out += fmt::format("{:{}}{}: {}{}\n", "", 2 * above.size(), entry.key(), entry.is_map ? "{…}" : entry.form, note);
  }
  return out + "```\n";
}

/// "key.path=value" as the deck has it.
std::string as_setting(const std::string& override_text) {
  const std::size_t equals = override_text.find('=');
  return fmt::format("`{}: {}`", override_text.substr(0, equals), override_text.substr(equals + 1));
}

std::string refusal(const PageText& page, std::span<const std::string> overrides) {
  read_example(page.examples.front());  // alone it is accepted
  try {
    read_example(page.examples.front(), {}, overrides);
  } catch (const fccda::InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find(": ") + 2);  // after its place
  }
  throw std::logic_error(fmt::format("the page {} lists as refused what the reader accepts: {}", page.name, fmt::join(overrides, ", ")));
}

std::string restrictions_of(const PageText& page) {
  std::string out;
  for (const std::string& sentence : page.restrictions) out += fmt::format("- {}\n", sentence);
  if (page.refused.empty()) return out.empty() ? "None.\n" : out;
  out += fmt::format("{}The reader refuses contradictions. With the {}example above:\n\n| setting | message |\n|---|---|\n", out.empty() ? "" : "\n",
                     page.examples.size() > 1 ? "first " : "");
  for (const std::vector<std::string>& overrides : page.refused) {
    std::vector<std::string> settings;
    for (const std::string& each : overrides) settings.push_back(as_setting(each));
    out += fmt::format("| {} | {} |\n", in_table(fmt::format("{}", fmt::join(settings, ", "))), in_table(refusal(page, overrides)));
  }
  return out;
}

std::string examples_of(const PageText& page) {
  std::string out;
  for (const Example& example : page.examples) {
    if (!example.caption.empty()) out += fmt::format("{}{}\n\n", out.empty() ? "" : "\n", example.caption);
    out += fmt::format("```yaml\n{}```\n", example.fragment);
    for (const auto& [name, contents] : example.files)
      if (!contents.empty()) out += fmt::format("\n`{}`:\n\n```\n{}```\n", name, contents);
  }
  return out;
}

std::string page_as_markdown(const PageText& page) {
  const std::vector<Section> sections = sections_of(&page);
  std::string out =
      fmt::format("# {}\n\n{}\n\n## Syntax\n\n{}\n## Examples\n\n{}\n## Keys\n", page.title, page.text, syntax_of(page, sections), examples_of(page));
  for (const Section& section : sections) out += fmt::format("\n### {}\n\n{}{}", section.heading, introduction(section), table_of(section, &page, sections));
  out += fmt::format("\n## Restrictions\n\n{}\n## Related\n\n", restrictions_of(page));
  for (const std::string& link : page.related) out += fmt::format("- {}\n", link);
  return out + "- [Deck reference](index.md): all blocks\n";
}

std::string_view first_sentence(std::string_view text) {
  const std::size_t end = text.find(". ");
  return end == std::string_view::npos ? text : text.substr(0, end + 1);
}

std::string index() {
  std::string out =
      "# Deck reference\n\nA page for each block of the deck. `perimpact describe --markdown` generates these pages from the tables that also read the deck; "
      "a test keeps them up to date. On the terminal, `perimpact describe KEY` explains one key.\n\nPlain numbers are in the unit in brackets; text with "
      "another unit is converted (`0.5 mm`, `191 GPa`, `3 kn`, `30 rpm`). `<name>` is a name of your choice.\n\n## Blocks\n\n| page | keys | "
      "|\n|---|---|---|\n";
  for (const PageText& page : page_texts()) {
    std::vector<std::string> maps;
    for (const std::string& map : page.maps) maps.push_back(fmt::format("`{}`", map));
    out += fmt::format("| [{}]({}.md) | {} | {} |\n", page.title, page.name, fmt::join(maps, ", "), in_table(first_sentence(page.text)));
  }
  out += "\n## The deck\n\n";
  const std::vector<Section> sections = sections_of(nullptr);
  out += table_of(sections.front(), nullptr, sections);
  return out +
         "\n## Related\n\n- [Units and axes](../units_and_axes.md): which units are converted, and to what positions are relative\n- "
         "[Errors](../errors.md): messages of the reader\n- [JSON Schema](../deck.schema.json): for editors that complete keys\n";
}

}  // namespace

std::vector<Page> reference_pages() {
  std::vector<Page> pages = {{"index.md", index()}};
  for (const PageText& page : page_texts()) pages.push_back({page.name + ".md", page_as_markdown(page)});
  return pages;
}

}  // namespace perimpact::deck
