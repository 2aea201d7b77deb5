/// The two kinds of errors reported to the user. Libraries throw them; only the command line prints and exits.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace fccda {

/// A remedy in an error message whose wording depends on the interface (library, input file, Python).
enum class Advice : std::uint8_t { none, declare_orientation, cut_open, clip };

/// The wording of each remedy in one interface, such as "with `orientation: normals`" in an input file.
struct AdviceWords {
  std::string_view declare_orientation, cut_open, clip;  ///< of the remedies of the same names in Advice

  /// The wording of one remedy; empty for none.
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

/// The wording for C++ programs.
constexpr AdviceWords library_words{
    .declare_orientation = "with Surface::Options::orientation, Orientation::normals (the one that the normals point to) or Orientation::reversed",
    .cut_open = "with Surface::Options::orientation, Orientation::normals (the side that the normals point to)",
    .clip = "pass Beyond::clip"};

/// Unusable input. The text states where, what, why and the remedy. Exit code 2.
///
/// `{}` in the sentence is the placeholder of the remedy, which defaults to the wording of the library. A program with another interface
/// inserts its own (`in_words_of`).
class InputError : public std::runtime_error {
 public:
  /// `sentence`: where, what, why, remedy; `advice`: the remedy inserted for `{}`.
  explicit InputError(const std::string& sentence, Advice advice = Advice::none)
      : std::runtime_error(filled(sentence, advice, library_words)), sentence_(sentence), advice_(advice) {}

  /// The message with the remedy in the words of another interface.
  std::string in_words_of(const AdviceWords& words) const { return filled(sentence_, advice_, words); }

 private:
  static std::string filled(std::string sentence, Advice advice, const AdviceWords& words) {
    const std::size_t place = advice == Advice::none ? std::string::npos : sentence.rfind("{}");
    return place == std::string::npos ? sentence : sentence.replace(place, 2, words.of(advice));
  }

  std::string sentence_;
  Advice advice_;
};

/// The simulation cannot continue (not a number, energy growth, disk full). Exit code 3.
class RunError : public std::runtime_error {
 public:
  /// `sentence`: where, what, why, remedy.
  explicit RunError(const std::string& sentence) : std::runtime_error(sentence) {}
};

}  // namespace fccda
