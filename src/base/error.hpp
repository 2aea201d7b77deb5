/// The two kinds of errors that reach a user. Libraries throw them; only the command line prints and exits.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace fccda {

/// What a message advises to say in the interface of this library.
enum class Advice : std::uint8_t { none, declare_orientation, cut_open, clip };

/// How an interface calls that: "such as `outside: normals`" in an input file.
struct AdviceWords {
  std::string_view declare_orientation, cut_open, clip;

  constexpr std::string_view of(Advice advice) const {
    switch (advice) {
      case Advice::declare_orientation:
        return declare_orientation;
      case Advice::cut_open:
        return cut_open;
      case Advice::clip:
        return clip;
      case Advice::none:
        break;
    }
    return {};
  }
};

constexpr AdviceWords library_words{
    .declare_orientation = "with Surface::Options::outside, OutsideIs::normals (the one that the normals point to) or OutsideIs::reversed",
    .cut_open = "with Surface::Options::outside, OutsideIs::normals (the side that the normals point to)",
    .clip = "pass Beyond::clip"};

/// The user's input cannot be used. The text says where, what, why and what to do. Exit code 2.
///
/// Where it advises something that is said in the interface of the library, `{}` stands for it in the sentence given. A program with an
/// interface of its own puts its own words there (`in_words_of`).
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& sentence, Advice advice = Advice::none)
      : std::runtime_error(filled(sentence, advice, library_words)), sentence_(sentence), advice_(advice) {}

  std::string in_words_of(const AdviceWords& words) const { return filled(sentence_, advice_, words); }

 private:
  static std::string filled(std::string sentence, Advice advice, const AdviceWords& words) {
    const std::size_t place = advice == Advice::none ? std::string::npos : sentence.rfind("{}");
    return place == std::string::npos ? sentence : sentence.replace(place, 2, words.of(advice));
  }

  std::string sentence_;
  Advice advice_;
};

/// The simulation cannot go on (not-a-number, energy growth, no room to write). Exit code 3.
class RunError : public std::runtime_error {
 public:
  explicit RunError(const std::string& sentence) : std::runtime_error(sentence) {}
};

}  // namespace fccda
