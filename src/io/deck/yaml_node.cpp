#include "io/deck/yaml_node.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <sstream>

#include "base/error.hpp"

namespace perimpact::deck {

namespace {

/// Position from yaml-cpp's line and column (from 0, column in bytes).
using PlaceOf = std::function<std::string(int line, int column)>;

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// Continuation byte in UTF-8.
bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

/// Editors count characters, yaml-cpp counts bytes.
std::ptrdiff_t characters(std::string_view text) {
  return std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation(c); });
}

/// yaml-cpp reports a tab in the indentation as "illegal map value" at a later position.
void refuse_tabs(std::string_view text, const PlaceOf& place_of) {
  int number = 0;
  for (const std::string_view line : lines_of(text)) {
    const std::size_t first = std::min(line.find_first_not_of(" \t\r"), line.size());
    const std::size_t tab = line.substr(0, first).find('\t');
    if (tab != std::string_view::npos && first < line.size() && line[first] != '#')
      refuse(place_of(number, static_cast<int>(tab)), "this line is indented with a tab, which YAML forbids; use spaces.");
    ++number;
  }
}

/// Length of the UTF-8 sequence at the beginning of the text, which is not empty (RFC 3629); 0 if there is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned>(static_cast<unsigned char>(text[k])); };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  if (length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if (!is_continuation(text[k])) return 0;
  const bool is_overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool is_outside = (first == 0xED && byte(1) >= 0xA0) || (first == 0xF4 && byte(1) >= 0x90);  // surrogates, beyond U+10FFFF
  return is_overlong || is_outside ? 0 : length;
}

/// Titles and names go to JSON and to the report, which are UTF-8.
void refuse_other_encodings(std::string_view text, const PlaceOf& place_of) {
  int number = 0;
  for (const std::string_view line : lines_of(text)) {
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t length = utf8_length(line.substr(at));
      if (length == 0)
        refuse(
            place_of(number, static_cast<int>(at)),
            fmt::format("the character here, byte 0x{:02X}, is not UTF-8, perhaps Latin-1; save the text as UTF-8, or convert it by iconv -f latin1 -t utf8.",
                        static_cast<unsigned>(static_cast<unsigned char>(line[at]))));
      at += length;
    }
    ++number;
  }
}

class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(const PlaceOf& place_of) : place_of_(place_of) {}

  YamlNode root;

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { attach({.kind = YamlNode::Kind::nothing, .place = place(mark)}); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse(place(mark), "YAML anchors and aliases (& and *) are not supported in decks; write the value out.");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t, const std::string& text) override {
    refuse_tag(mark, tag);
    attach({.kind = YamlNode::Kind::word, .place = place(mark), .text = text});
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t, YAML::EmitterStyle::value) override {
    open(mark, tag, YamlNode::Kind::list);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t, YAML::EmitterStyle::value) override { open(mark, tag, YamlNode::Kind::map); }
  void OnMapEnd() override { close(); }

 private:
  struct Level {
    YamlNode node;
    std::optional<YamlNode> key;  // read, with the value still to come
  };

  std::string place(const YAML::Mark& mark) const { return place_of_(mark.line, mark.column); }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {  // yaml-cpp has "?" for plain and "!" for quoted text
    if (tag.size() > 1) refuse(place(mark), "YAML tags (!…) are not supported in decks; remove the tag.");
  }

  bool expects_key() const { return !open_.empty() && open_.back().node.kind == YamlNode::Kind::map && !open_.back().key; }

  void open(const YAML::Mark& mark, const std::string& tag, YamlNode::Kind kind) {
    refuse_tag(mark, tag);
    if (expects_key()) refuse(place(mark), "a list or map is given where a key is expected; keys are single words, and every bracket must be closed.");
    open_.push_back({.node = {.kind = kind, .place = place(mark)}, .key = {}});
  }

  void close() {
    YamlNode node = std::move(open_.back().node);
    open_.pop_back();
    attach(std::move(node));
  }

  void attach(YamlNode node) {
    if (open_.empty()) {
      root = std::move(node);
      return;
    }
    Level& level = open_.back();
    if (level.node.kind == YamlNode::Kind::list) {
      level.node.items.push_back(std::move(node));
    } else if (!level.key) {
      take_key(level, std::move(node));
    } else {
      // yaml-cpp gives the position of the next token for an empty value
      if (node.kind == YamlNode::Kind::nothing) node.place = level.key->place;
      level.node.entries.push_back({.key = level.key->text, .place = level.key->place, .value = std::move(node)});
      level.key.reset();
    }
  }

  void take_key(Level& level, YamlNode key) {
    if (key.kind != YamlNode::Kind::word) refuse(key.place, "a key is missing before the colon.");
    if (const YamlNode::Entry* first = level.node.find(key.text))
      refuse(key.place, fmt::format("{} is given twice in the same map, first at {}; keep one of the two.", key.text, first->place));
    level.key = std::move(key);
  }

  const PlaceOf& place_of_;
  std::vector<Level> open_;
};

/// A node of kind nothing if there is no document.
YamlNode parse(std::string_view text, const PlaceOf& place_of) {
  refuse_other_encodings(text, place_of);
  refuse_tabs(text, place_of);
  // With an end-of-document marker, yaml-cpp neither takes an open bracket for a key nor closes an open quote silently.
  std::istringstream stream(std::string(text) + (text.ends_with('\n') ? "...\n" : "\n...\n"));
  TreeBuilder builder(place_of);
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) return {.place = place_of(0, 0)};
    YamlNode root = std::move(builder.root);
    if (parser.HandleNextDocument(builder))
      refuse(builder.root.place, "a second YAML document begins here, but a deck is a single document; remove the line --- before it.");
    return root;
  } catch (const YAML::Exception& error) {
    const std::string place = place_of(error.mark.line, error.mark.column);
    if (error.msg == YAML::ErrorMsg::DOC_IN_SCALAR) refuse(place, "an opening quote before this position is not closed; close it.");
    refuse(place, fmt::format("this is not valid YAML ({}); check indentation, colons, quotes and brackets here and just before.", error.msg));
  }
}

}  // namespace

const YamlNode::Entry* YamlNode::find(std::string_view key) const {
  const auto entry = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
  return entry == entries.end() ? nullptr : &*entry;
}

YamlNode::Entry* YamlNode::find(std::string_view key) { return const_cast<Entry*>(std::as_const(*this).find(key)); }

std::string YamlNode::in_words() const {
  switch (kind) {
    case Kind::nothing:
      return "nothing";
    case Kind::list:
      return "a list";
    case Kind::map:
      return "a map";
    case Kind::word:
      break;
  }
  constexpr std::size_t longest = 60;
  std::size_t length = std::min(text.size(), longest);
  while (length < text.size() && is_continuation(text[length])) --length;
  const std::string start = length < text.size() ? text.substr(0, length) + "…" : text;
  const bool is_plain = !start.empty() && start.find_first_of(" ,:;\n") == std::string::npos;
  return is_plain ? start : '"' + start + '"';
}

YamlNode parse_document(std::string_view text, const std::string& file) {
  const std::vector<std::string_view> lines = lines_of(text);
  const PlaceOf place_of = [&](int line, int column) {
    const auto row = static_cast<std::size_t>(std::max(line, 0));
    const std::string_view before = row < lines.size() ? lines[row].substr(0, static_cast<std::size_t>(std::max(column, 0))) : std::string_view{};
    return fmt::format("{}:{}:{}", file, row + 1, characters(before) + 1);
  };
  if (text.find('\0') != std::string_view::npos) refuse(file, "this is not a text file; a deck is a YAML file.");
  YamlNode root = parse(text, place_of);
  if (root.kind == YamlNode::Kind::nothing) refuse(file, "the deck is empty; it needs at least time and bodies (perimpact describe lists all keys).");
  if (root.kind != YamlNode::Kind::map)
    refuse(root.place, fmt::format("a deck is a map (title: …, time: …, bodies: …), but this is {}; begin with a key and a colon.", root.in_words()));
  return root;
}

YamlNode parse_value(std::string_view text, const std::string& place) {
  return parse(text, [&](int, int) { return place; });
}

void refuse(std::string_view place, std::string_view sentence) {
  std::string line = fmt::format("{}: {}", place, sentence);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  throw fccda::InputError(line);
}

}  // namespace perimpact::deck
