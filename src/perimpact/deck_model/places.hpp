/// Origin of each value of a Setup, for messages of checks that run after the deck was read.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace perimpact {

class Places {
 public:
  /// `deck`: name of the deck in messages, usually its path.
  explicit Places(std::string deck = "deck") : deck_(std::move(deck)) {}

  void add(std::string path, std::string place) { by_path_.insert_or_assign(std::move(path), std::move(place)); }

  /// True if the deck or --set gave this key: "bodies.plate.family".
  bool has(std::string_view path) const { return by_path_.contains(path); }

  /// "deck.yaml:4:22" or "--set time.step"; for an absent key, the place of the innermost enclosing map; else the deck's name.
  std::string of(std::string_view path) const {
    for (;;) {
      if (const auto found = by_path_.find(path); found != by_path_.end()) return found->second;
      const std::size_t dot = path.rfind('.');
      if (dot == std::string_view::npos) return deck_;
      path = path.substr(0, dot);
    }
  }

 private:
  std::string deck_;
  std::map<std::string, std::string, std::less<>> by_path_;
};

}  // namespace perimpact
