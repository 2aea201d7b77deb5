/// Sentences for the user, of which those of one kind become one where there are many.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fccda {

class GroupedSentences {
 public:
  static constexpr std::size_t most = 3;  ///< sentences of one kind that are not grouped

  /// `subject`: what the sentence is about, to be named where its sentence is omitted.
  void add(std::string_view kind, std::string subject, std::string sentence);

  /// In the order in which each kind was first added. More than `most` of a kind become the first one with the other subjects.
  std::vector<std::string> sentences() const;

 private:
  struct Kind {
    std::string name;
    std::vector<std::string> subjects, sentences;
  };
  std::vector<Kind> kinds_;
};

inline void GroupedSentences::add(std::string_view kind, std::string subject, std::string sentence) {
  auto found = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& one) { return one.name == kind; });
  if (found == kinds_.end()) found = kinds_.insert(kinds_.end(), Kind{std::string(kind), {}, {}});
  found->subjects.push_back(std::move(subject));
  found->sentences.push_back(std::move(sentence));
}

inline std::vector<std::string> GroupedSentences::sentences() const {
  constexpr std::size_t most_named = 5;
  std::vector<std::string> all;
  for (const Kind& kind : kinds_) {
    if (kind.sentences.size() <= most) {
      all.insert(all.end(), kind.sentences.begin(), kind.sentences.end());
      continue;
    }
    const std::size_t others = kind.subjects.size() - 1, named = std::min(others, most_named);
    std::string text = kind.sentences.front() + " The same applies to " + std::to_string(others) + " others: ";
    for (std::size_t k = 1; k <= named; ++k) text += (k == 1 ? "" : ", ") + kind.subjects[k];
    all.push_back(text + (named < others ? ", …" : "."));
  }
  return all;
}

}  // namespace fccda
