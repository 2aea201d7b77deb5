#include "io/deck/reader.hpp"

#include <algorithm>

#include "io/deck/reference.hpp"
#include "io/deck/units.hpp"

namespace perimpact::deck {

namespace {

std::string called(const std::string& path) { return path.empty() ? "the deck" : path; }

/// Length of the common prefix of two paths.
std::size_t common_prefix(std::string_view a, std::string_view b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

/// True if "bodies.plate.material" matches "bodies.<name>.material".
bool is_one_of(std::string_view path, std::string_view pattern) {
  for (;;) {
    const std::size_t end = path.find('.'), pattern_end = pattern.find('.');
    const std::string_view wanted = pattern.substr(0, pattern_end);
    if (wanted != any_name && wanted != path.substr(0, end)) return false;
    if (end == std::string_view::npos || pattern_end == std::string_view::npos) return end == pattern_end;
    path.remove_prefix(end + 1), pattern.remove_prefix(pattern_end + 1);
  }
}

/// "with model: ordinary-state, linear-peridynamic-solid": the alternatives with which this map has the key; empty if there are none.
std::string with_what(const std::string& key, const std::string& path) {
  std::string alternatives;
  for (const Entry& entry : reference()) {
    if (entry.key() != key || entry.condition.empty() || !is_one_of(path, entry.parent())) continue;
    const std::size_t colon = entry.condition.find(": ");
    alternatives += alternatives.empty() || colon == std::string::npos ? entry.condition : ", " + entry.condition.substr(colon + 2);
  }
  return alternatives;
}

/// End of the sentence about an unknown key: "did you mean …", or the map to which it belongs, or the known keys.
std::string remedy(const std::string& key, const std::vector<std::string>& known, const std::string& path) {
  if (key.find(':') != std::string::npos) return "write a space after the colon.";
  if (nearest_word(key, known).empty()) {
    if (const std::string alternatives = with_what(key, path); !alternatives.empty()) return fmt::format("it can be given only {}.", alternatives);
    const Entry* nearest = nullptr;
    for (const Entry& entry : reference())
      if (entry.key() == key && (!nearest || common_prefix(entry.path, path) > common_prefix(nearest->path, path))) nearest = &entry;
    if (nearest) return fmt::format("it belongs to {}.", nearest->parent());
  }
  return suggestion(key, known);
}

}  // namespace

Reader::Reader(const YamlNode& map, std::string path, std::string place, Places& places)
    : map_(map), path_(std::move(path)), place_(std::move(place)), places_(places) {
  if (map.kind == YamlNode::Kind::word || map.kind == YamlNode::Kind::list)
    refuse(map.place, fmt::format("{} is {}, but a map of keys is needed; perimpact describe {} lists them.", called(path_), map.in_words(), path_));
}

const YamlNode::Entry* Reader::find(std::string_view key, Presence presence, std::string_view sentence, std::string_view unit) {
  known_.emplace_back(key);
  const YamlNode::Entry* entry = map_.find(key);
  if (entry) {
    places_.add(path_of(key), entry->place);
  } else if (presence == Presence::required && missing_.empty()) {
    const bool is_number = !unit.empty();
    missing_ = is_number ? fmt::format("{} lacks {} [{}], {}; for example {}: {}. {}", called(path_), key, unit, kind_of(unit).what, key, kind_of(unit).example,
                                       sentence)
                         : fmt::format("{} lacks {}. {}", called(path_), key, sentence);
  }
  return entry;
}

std::string_view Reader::only_one_of(const std::vector<std::string>& words, Presence presence) {
  known_.insert(known_.end(), words.begin(), words.end());
  const YamlNode::Entry* chosen = nullptr;
  for (const std::string& word : words) {
    const YamlNode::Entry* entry = map_.find(word);
    if (entry && chosen) refuse(entry->place, fmt::format("{} is both {} and {}; keep one of the two.", called(path_), chosen->key, word));
    if (entry) chosen = entry;
  }
  if (!chosen && presence == Presence::required) missing_ = fmt::format("{} needs one of {}.", called(path_), fmt::join(words, ", "));
  if (!chosen) return {};
  places_.add(path_of(chosen->key), chosen->place);
  return chosen->key;
}

std::string Reader::word_of(std::string_view selector, const std::vector<std::string>& words) {
  const std::string sentence = fmt::format("It is one of {}.", fmt::join(words, ", "));
  const YamlNode::Entry* entry = find(selector, Presence::required, sentence);
  if (!entry) refuse_without(selector);
  places_.add(path_of(selector), entry->value.place);
  std::string word;
  read_value(entry->value, {selector, {}, {}, sentence}, word);
  if (std::find(words.begin(), words.end(), word) == words.end())
    refuse(entry->value.place, fmt::format("{} is {}, which is unknown; {}", selector, entry->value.in_words(), suggestion(word, words)));
  return word;
}

void Reader::refuse_without(std::string_view selector) const {
  std::vector<std::string> keys;
  for (const YamlNode::Entry& entry : map_.entries) keys.push_back(entry.key);
  if (const std::string_view misspelt = nearest_word(selector, keys); !misspelt.empty())
    refuse(map_.find(misspelt)->place, fmt::format("{} is not a key of {}; did you mean {}?", misspelt, called(path_), selector));
  refuse(place_, missing_);
}

void Reader::refuse_bad_names(Presence presence) const {
  if (presence == Presence::required && map_.entries.empty()) refuse(place_, fmt::format("{} is empty; it needs at least one name with its keys.", path_));
  constexpr std::string_view allowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
  for (const YamlNode::Entry& entry : map_.entries) {
    if (entry.key.empty() || entry.key.find_first_not_of(allowed) != std::string::npos)
      refuse(entry.place,
             fmt::format("\"{}\" cannot be a name in {}, because names become columns and files; use letters, digits, _ and -.", entry.key, path_));
    constexpr std::size_t longest = 200;  // file systems take 255; the names of files have up to 45 characters more
    if (entry.key.size() > longest)
      refuse(entry.place, fmt::format("a name in {} has {} characters, but names become files; use at most {}.", path_, entry.key.size(), longest));
  }
}

std::string Reader::other_names(const std::string& name) const {
  std::vector<std::string> others;
  for (const YamlNode::Entry& entry : map_.entries) {
    if (entry.key != name) others.push_back(entry.key);
  }
  return others.empty() ? "" : fmt::format("the deck has no {}; {}", path_of(name), suggestion(name, others));
}

void Reader::finish() const {
  for (const YamlNode::Entry& entry : map_.entries) {
    if (std::find(known_.begin(), known_.end(), entry.key) == known_.end())
      refuse(entry.place, fmt::format("{} is not a key of {}; {}", entry.key, called(path_), remedy(entry.key, known_, path_)));
  }
  if (!missing_.empty()) refuse(place_, may_be_misnamed_.empty() ? missing_ : may_be_misnamed_);
}

}  // namespace perimpact::deck
