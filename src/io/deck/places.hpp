/// Where each value of a Setup came from, for messages of checks that run long after the deck was read.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace perimpact::deck {

class Places {
 public:
  /// `deck`: how messages call the deck, usually its path.
  explicit Places(std::string deck = "deck") : deck_(std::move(deck)) {}

  void add(std::string path, std::string place) { by_path_.insert_or_assign(std::move(path), std::move(place)); }

  /// True where the deck or --set gave this key: "bodies.plate.family".
  bool has(std::string_view path) const { return by_path_.contains(path); }

  /// "deck.yaml:4:22" or "--set time.step"; of a key that was left out, the place of the nearest map around it; else the deck's name.
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

}  // namespace perimpact::deck
