#include "io/deck/deprecated_keys.hpp"

#include <fmt/format.h>

#include <span>
#include <string_view>

#include "base/grouped_sentences.hpp"

namespace perimpact::deck {

namespace {

/// A key in the map at `path`. In paths `*` matches any key, and thus names chosen in the deck.
struct RenamedKey {
  std::string_view path, old_name, name;
};

/// A word that is the value of the key at `path`.
struct RenamedWord {
  std::string_view path, old_word, word;
};

// Paths use current names, because keys are renamed from the top down.
constexpr RenamedKey renamed_keys[] = {
    {"time.relax", "most_iterations", "max_iterations"},
    {"bodies.*", "parts", "add"},
    {"bodies.*", "regions", "particle_sets"},
    {"bodies.*", "boundaries", "boundary_conditions"},
    {"bodies.*.boundary_conditions.*.*", "region", "particle_set"},
    {"bodies.*.shape.*", "parts", "file_parts"},
    {"bodies.*.shape", "parts", "file_parts"},
    {"bodies.*.shape", "complete", "mirror_merge"},
    {"bodies.*.*.*.shape", "parts", "file_parts"},
    {"bodies.*.*.*.shape", "complete", "mirror_merge"},
    {"impactors.*", "free", "free_dofs"},
    {"impactors.*", "region", "contact_bounds"},
    {"impactors.*.contact_bounds", "outside", "on_exceed"},
    {"impactors.*.surface", "parts", "file_parts"},
    {"impactors.*.surface", "complete", "mirror_merge"},
    {"impactors.*.surface", "outside", "orientation"},
    {"impactors.*.surface.*", "panel", "edge_length"},
    {"impactors.*.surface.*", "panels", "panel_shape"},
    {"impactors.*.surface.hull", "bow_panel", "bow_edge_length"},
    {"impactors.*.surface.propeller", "edge_panel", "blade_edge_length"},
    {"impactors.*.coarsen", "distance", "max_deviation"},
    {"impactors.*.coarsen", "panel", "max_edge_length"},
    {"impactors.*.refine.*", "panel", "edge_length"},
    {"impactors.*.refine.*", "part", "surface_part"},
    {"impactors.*.gauges.*", "parts", "surface_parts"},
    {"contact.impactors", "reading", "variant"},
    {"contact.impactors", "starting_inside", "initial_overlap"},
    {"output", "history", "history_interval"},
    {"output", "checkpoint_every", "checkpoint_interval"},
};
constexpr RenamedWord renamed_words[] = {
    {"bodies.*.material.influence", "one", "constant"},
    {"contact.impactors.variant", "repaired", "corrected"},
    {"contact.impactors.variant", "letter", "literal"},
};

bool matches(std::string_view pattern, std::span<const std::string> path) {
  for (const std::string& key : path) {
    const std::size_t dot = pattern.find('.');
    if (const std::string_view step = pattern.substr(0, dot); step != "*" && step != key) return false;
    if (dot == std::string_view::npos) return &key == &path.back();
    pattern.remove_prefix(dot + 1);
  }
  return false;
}

/// True where `--set` gave the value itself, not only something inside it.
bool is_whole_override(const YamlNode& node, std::string_view name) { return node.is_override() && node.place.ends_with("." + std::string(name)); }

class Renamer {
 public:
  void visit(YamlNode& node) {
    if (node.kind == YamlNode::Kind::map) {
      for (const RenamedKey& key : renamed_keys)
        if (matches(key.path, path_)) rename(node, key);
      for (YamlNode::Entry& entry : node.entries) {
        path_.push_back(entry.key);
        visit(entry.value);
        path_.pop_back();
      }
    } else if (node.kind == YamlNode::Kind::word) {
      for (const RenamedWord& word : renamed_words)
        if (node.text == word.old_word && matches(word.path, path_)) {
          warn(node.place, word.old_word, word.word);
          node.text = word.word;
        }
    }
  }

  fccda::GroupedSentences warnings;

 private:
  void rename(YamlNode& map, const RenamedKey& key) {
    YamlNode::Entry* const old = map.find(key.old_name);
    if (!old) return;
    warn(old->place, key.old_name, key.name);
    YamlNode::Entry* const current = map.find(key.name);
    if (!current) {
      old->key = key.name;
      return;
    }
    YamlNode value = std::move(old->value);
    const std::string place = old->place;
    map.entries.erase(map.entries.begin() + (old - map.entries.data()));
    merge(map.find(key.name)->value, std::move(value), place, key);
  }

  void merge(YamlNode& into, YamlNode from, const std::string& place, const RenamedKey& key) {
    if (is_whole_override(into, key.name)) return;
    if (is_whole_override(from, key.old_name)) {
      into = std::move(from);
      return;
    }
    if (into.kind == YamlNode::Kind::map && from.kind == YamlNode::Kind::map) {
      for (YamlNode::Entry& entry : from.entries) {
        if (YamlNode::Entry* const same = into.find(entry.key))
          merge(same->value, std::move(entry.value), entry.place, key);
        else
          into.entries.push_back(std::move(entry));
      }
      return;
    }
    if (into.is_override()) return;
    if (!from.is_override())
      refuse(place, fmt::format("`{}` is the former name of `{}`, and the deck gives both; keep `{}`.", key.old_name, key.name, key.name));
    into = std::move(from);
  }

  void warn(const std::string& place, std::string_view old_name, std::string_view name) {
    warnings.add(old_name, place, fmt::format("{}: `{}` is now called `{}`; the former name is accepted until release 0.2.0.", place, old_name, name));
  }

  std::vector<std::string> path_;
};

}  // namespace

std::vector<std::string> rename_deprecated_keys(YamlNode& deck) {
  Renamer renamer;
  renamer.visit(deck);
  return renamer.warnings.sentences();
}

}  // namespace perimpact::deck
