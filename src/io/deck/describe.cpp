#include "io/deck/describe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "io/deck/did_you_mean.hpp"
#include "io/deck/key_path.hpp"
#include "io/deck/reference.hpp"
#include "io/deck/yaml_node.hpp"

namespace perimpact::deck {

namespace {

using Keys = std::span<const std::string_view>;

/// <name> in the path matches any name in the query, or none.
bool matches(Keys path, Keys query) {
  if (path.empty()) return query.empty();
  if (path.front() == any_name) return matches(path.subspan(1), query) || (!query.empty() && matches(path.subspan(1), query.subspan(1)));
  return !query.empty() && query.front() == path.front() && matches(path.subspan(1), query.subspan(1));
}

bool ends_in(Keys path, Keys query) {
  for (std::size_t first = 0; first < path.size(); ++first) {
    if (path[first] != any_name && matches(path.subspan(first), query)) return true;
  }
  return false;
}

bool is_below(const Entry& entry, const Entry& map) { return entry.path.starts_with(map.path + "."); }

std::string suggested_key(std::string_view key) {
  std::vector<std::string> keys;
  for (const Entry& entry : reference()) keys.emplace_back(entry.key());
  return std::string(nearest_word(key, keys));
}

/// Entries that the query matches: by the whole path, else by the end of the path, else the map of a name ("bodies.plate"). Entries
/// below another match are left out.
std::vector<const Entry*> named_by(std::string_view key_path) {
  const std::vector<std::string_view> query = keys_of(key_path);
  const auto found_by = [&](const auto& is_meant) {
    std::vector<const Entry*> found;
    for (const Entry& entry : reference()) {
      const bool is_shown = !found.empty() && is_below(entry, *found.back());
      if (!is_shown && is_meant(keys_of(entry.path))) found.push_back(&entry);
    }
    return found;
  };
  const auto is_key = [&](Keys path) { return path.back() == query.back(); };
  auto found = found_by([&](Keys path) { return is_key(path) && matches(path, query); });
  if (found.empty()) found = found_by([&](Keys path) { return is_key(path) && ends_in(path, query); });
  const bool may_be_name = query.back().size() <= 5 || suggested_key(query.back()).empty();  // short names resemble some key by chance
  if (found.empty() && may_be_name) found = found_by([&](Keys path) { return path.back() == any_name && matches(path, query); });
  return found;
}

std::ptrdiff_t depth(const Entry& entry) { return std::count(entry.path.begin(), entry.path.end(), '.'); }

std::string as_text(std::string_view name, const Entry& entry, std::ptrdiff_t level) {
  std::vector<std::string> facts = {entry.form};
  if (!entry.range.empty()) facts.push_back(entry.range);
  if (entry.key() != any_name) facts.push_back(entry.need);
  if (!entry.condition.empty()) facts.push_back(entry.condition);
  const std::string indent(static_cast<std::size_t>(2 * level), ' ');
  const std::string line = fmt::format("{}{}: {}\n", indent, name, fmt::join(facts, ", "));
  return entry.sentence.empty() ? line : fmt::format("{}{}    {}\n", line, indent, entry.sentence);
}

/// All entries below one, which follow it in the reference.
std::string text_below(const Entry& root) {
  const std::span<const Entry> all(reference());
  std::string out;
  for (auto entry = all.begin() + (&root - all.data()) + 1; entry != all.end() && is_below(*entry, root); ++entry)
    out += as_text(entry->key(), *entry, depth(*entry) - depth(root));
  return out;
}

/// A key as it is described: several entries, if they differ in their condition alone.
struct DescribedKey {
  Entry entry;
  std::string below;
};

/// "with model: a" and "with model: b" give "with model: a, b".
void add_condition(std::string& condition, const std::string& other) {
  const std::size_t begin = other.find(": ") + 2;
  if (condition != other) condition += ", " + (condition.starts_with(other.substr(0, begin)) ? other.substr(begin) : other);
}

std::vector<DescribedKey> merged(std::span<const Entry* const> roots) {
  std::vector<DescribedKey> all;
  for (const Entry* root : roots) {
    const std::string below = text_below(*root);
    const auto same = std::ranges::find_if(all, [&](const DescribedKey& one) {
      return one.entry.path == root->path && one.entry.form == root->form && one.entry.range == root->range && one.entry.need == root->need &&
             one.entry.sentence == root->sentence && one.entry.condition.empty() == root->condition.empty() && one.below == below;
    });
    if (same == all.end())
      all.push_back({*root, below});
    else
      add_condition(same->entry.condition, root->condition);
  }
  return all;
}

}  // namespace

std::string describe(std::string_view key_path) {
  std::string out;
  if (key_path.empty()) {
    for (const Entry& entry : reference()) out += as_text(entry.key(), entry, depth(entry));
    return out;
  }
  const std::vector<const Entry*> roots = named_by(key_path);
  if (roots.empty()) {
    const std::string meant = suggested_key(keys_of(key_path).back());
    refuse(key_path, meant.empty() ? "a deck has no such key; perimpact describe lists all." : fmt::format("a deck has no such key; did you mean {}?", meant));
  }
  for (const auto& [entry, below] : merged(roots)) out += as_text(entry.path, entry, 0) + below;
  return out;
}

}  // namespace perimpact::deck
