/// Fills described structs from the maps of a deck, by their tables and the schema. One Reader reads one map; every error is an
/// InputError with its position.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/deck/did_you_mean.hpp"
#include "io/deck/schema.hpp"
#include "io/deck/value.hpp"
#include "io/deck/yaml_node.hpp"
#include "perimpact/deck_model/places.hpp"

namespace perimpact::deck {

class Reader {
 public:
  /// `path`: of the map, empty for the whole deck; `place`: of its key. Keeps references to the map and the places.
  Reader(const YamlNode& map, std::string path, std::string place, Places& places);

  /// Reads the whole struct and refuses unknown keys.
  template <class T>
  void read(T& into) {
    read_contents(into);
    finish();
  }

  // called by the schema
  template <class T>
  void section(std::string_view key, T& into, Presence presence, std::string_view sentence) {
    if (const YamlNode::Entry* entry = find(key, presence, sentence)) inner(*entry).read(into);
  }

  template <class T>
  void section(std::string_view key, std::optional<T>& into, Presence presence, std::string_view sentence) {
    if (const YamlNode::Entry* entry = find(key, presence, sentence)) inner(*entry).read(into.emplace());
  }

  template <class T>
  void named(std::string_view key, std::vector<T>& into, Presence presence, std::string_view sentence) {
    const YamlNode::Entry* entry = find(key, presence, sentence);
    if (!entry) return;
    Reader names = inner(*entry);
    names.refuse_bad_names(presence);
    for (const YamlNode::Entry& item : names.map_.entries) {
      T& element = into.emplace_back();
      element.name = item.key;
      names.places_.add(names.path_of(item.key), item.place);
      Reader contents = names.inner(item);
      contents.may_be_misnamed_ = item.place.starts_with(override_mark) ? names.other_names(item.key) : std::string();
      contents.read(element);
    }
  }

  template <class Variant>
  void one_of(std::string_view key, Variant& into, Presence presence, std::string_view sentence) {
    const YamlNode::Entry* entry = find(key, presence, sentence);
    if (!entry) return;
    Reader choice = inner(*entry);
    choice.alternatives(into);
    choice.finish();
  }

  template <class Variant>
  void alternatives(Variant& into) {
    constexpr bool may_be_absent = std::is_same_v<std::variant_alternative_t<0, Variant>, std::monostate>;
    const std::string_view chosen = only_one_of(alternative_names(into), may_be_absent ? Presence::optional : Presence::required);
    for_each_alternative(into, [&]<class T>(const T& alternative) {
      if (chosen != T::name) return;
      T& value = into.template emplace<T>(alternative);
      if (is_written_flat<T>()) return read_contents(value);
      inner(*map_.find(chosen)).read(value);
    });
  }

  template <class Variant>
  void by_word(std::string_view key, std::string_view selector, Variant& into, std::string_view sentence) {
    if (const YamlNode::Entry* entry = find(key, Presence::required, sentence)) inner(*entry).read_by_word(selector, into);
  }

 private:
  template <class T>
  void read_contents(T& into) {
    if constexpr (Described<T>) {
      for (const Field<T>& field : T::fields()) {
        const YamlNode::Entry* entry = find(field.name, field.presence, field.sentence, field.unit);
        if (!entry) continue;
        places_.add(path_of(field.name), entry->value.place);
        std::visit([&](auto member) { read_value(entry->value, {field.name, field.unit, field.range, field.sentence}, into.*member); }, field.member);
      }
    }
    sections(*this, into);
  }

  template <class Variant>
  void read_by_word(std::string_view selector, Variant& into) {
    const std::string word = word_of(selector, alternative_names(into));
    for_each_alternative(into, [&]<class T>(const T& alternative) {
      if (word == T::name) read_contents(into.template emplace<T>(alternative));
    });
    finish();
  }

  /// The entry of a known key, whose place is recorded; null if absent. finish() reports missing keys after unknown ones, because a
  /// misspelt key is also a missing one.
  const YamlNode::Entry* find(std::string_view key, Presence presence, std::string_view sentence, std::string_view unit = {});

  Reader inner(const YamlNode::Entry& entry) const { return {entry.value, path_of(entry.key), entry.place, places_}; }
  std::string path_of(std::string_view key) const { return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key); }
  std::string_view only_one_of(const std::vector<std::string>& words, Presence presence);
  std::string word_of(std::string_view selector, const std::vector<std::string>& words);
  [[noreturn]] void refuse_without(std::string_view selector) const;
  void refuse_bad_names(Presence presence) const;
  /// "the deck has no bodies.plat; did you mean plate?"
  std::string other_names(const std::string& name) const;
  void finish() const;

  const YamlNode& map_;
  std::string path_;
  std::string place_;
  Places& places_;
  std::vector<std::string> known_;
  std::string missing_;          // sentence about the first missing key
  std::string may_be_misnamed_;  // reported instead of missing_: a name that only --set gives is probably misspelt
};

}  // namespace perimpact::deck
