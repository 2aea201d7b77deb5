#include <random>

#include "io/deck/fixtures.hpp"
#include "io/deck/setup_to_text.hpp"

namespace {

/// One to four small accidents: a stretch deleted, doubled, moved or overwritten.
std::string garbled(std::string text, std::mt19937_64& random) {
  constexpr std::string_view letters = "{}[]:,#&*!|>'\"%@`-?~ \n\t0123456789.eE+abcxyz_/()\\\x00\x7f\x80\xC3\xFF";
  for (std::size_t accident = 1 + random() % 4; accident > 0; --accident) {
    const std::size_t at = random() % text.size();
    const std::size_t length = 1 + random() % (random() % 8 == 0 ? 60 : 4);
    switch (random() % 4) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, text.substr(at, length));
        break;
      case 2:
        text.insert(random() % text.size(), text.substr(at, length));
        break;
      default:
        for (std::size_t i = at; i < std::min(at + length, text.size()); ++i) text[i] = letters[random() % letters.size()];
    }
  }
  return text;
}

}  // namespace

TEST_CASE("garbled: two thousand damaged decks are either read or refused with a position, without a crash or another exception") {
  std::mt19937_64 random(1);
  int refused = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const std::string text = garbled(fixtures::plate, random);
    std::string sentence;
    try {
      const auto deck = fixtures::read(text);
      CHECK(fixtures::complaint(perimpact::deck::setup_to_text(deck.setup)) == "");  // what is accepted can be written and read again
    } catch (const fccda::InputError& error) {
      sentence = error.what();
      ++refused;
    } catch (const std::exception& other) {
      FAIL_CHECK("deck:\n" << text << "\nthrows " << other.what());
    }
    if (!sentence.empty()) CHECK_MESSAGE((sentence.starts_with("deck.yaml:") && sentence.find('\n') == std::string::npos), sentence);
  }
  CHECK(refused > 1000);  // most accidents hurt; those in comments and in the title do not
}
