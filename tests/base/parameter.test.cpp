// The words of a choice, compared with the enum that they select.
#include "base/parameter.hpp"

#include <doctest/doctest.h>

#include "base/typelist.hpp"

using namespace fccda;

namespace {

enum class Metal { iron, lead_tin, zinc };
constexpr std::string_view whole[] = {"iron", "lead-tin", "zinc"}, swapped[] = {"iron", "zinc", "lead-tin"}, misspelt[] = {"iron", "lead-tin", "zink"};
constexpr std::string_view fewer[] = {"iron", "lead-tin"}, more[] = {"iron", "lead-tin", "zinc", "gold"};

}  // namespace

TEST_CASE("words agree with an enum only if they are its enumerators, all of them and in their order") {
  CHECK(are_enumerators<Metal>(whole));
  CHECK(!are_enumerators<Metal>(swapped));
  CHECK(!are_enumerators<Metal>(misspelt));
  CHECK(!are_enumerators<Metal>(fewer));
  CHECK(!are_enumerators<Metal>(more));
  CHECK(Choice{whole, 1}.as<Metal, whole>() == Metal::lead_tin);
}

TEST_CASE("a joined variant has every type once, in the order of their first mention") {
  CHECK(std::is_same_v<JoinedVariant<std::variant<int, char>, double, std::variant<char, int, bool>>, std::variant<int, char, double, bool>>);
  CHECK(std::is_same_v<JoinedVariant<int>, std::variant<int>>);
}
