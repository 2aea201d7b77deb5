/// Lists of distinct words in a deck: directions, fields, names of particle sets.
#pragma once

#include <fmt/format.h>

#include <set>
#include <span>
#include <string>
#include <string_view>

namespace perimpact {

/// Calls check(word) for each word in order, and refuse(sentence) at the first that has come before. `key`: of the list.
template <class Check, class Refuse>
void check_distinct(std::string_view key, std::span<const std::string> words, const Check& check, const Refuse& refuse) {
  std::set<std::string> seen;
  for (const std::string& word : words) {
    check(word);
    if (!seen.insert(word).second) refuse(fmt::format("{} contains {} twice; keep one.", key, word));
  }
}

}  // namespace perimpact
