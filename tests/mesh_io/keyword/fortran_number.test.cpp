#include "mesh_io/keyword/fortran_number.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace fccda;

TEST_CASE("fortran: every notation of a real number gives the number of the C++ notation") {
  for (const char* word : {"1500", "1500.", "+1500.", "1.5e3", "1.5E+03", "1.5D+3", "1.5d3", "1.5+3", "15.+2", "150000-2", "+.15+4"}) {
    CAPTURE(word);
    CHECK(fortran_real(word) == 1500);
  }
  CHECK(fortran_real("-1.5-3") == -0.0015);
  CHECK(fortran_real("-.5") == -0.5);
  CHECK(fortran_real("0.1") == 0.1);
}

TEST_CASE("fortran: text other than a finite number is refused") {
  for (const char* word :
       {"", "x", "1 5", "1.5e", "1.5d", "1.5+", "1.5+-3", "+-1", "--1", "1,5", "nan", "inf", "-inf", "1e999", "1+999", "0x1", "1.5+3+3", "+", ".", "1.5e3 "}) {
    CAPTURE(word);
    CHECK_FALSE(fortran_real(word));
  }
  CHECK_FALSE(fortran_real(std::string(1000, '1') + "+5"));
}

TEST_CASE("fortran: integers have 64 bits") {
  CHECK(fortran_integer("9999999999") == 9999999999);
  CHECK(fortran_integer("+7") == 7);
  CHECK(fortran_integer("-7") == -7);
  CHECK(fortran_integer("9223372036854775807") == std::numeric_limits<std::int64_t>::max());
  for (const char* word : {"", "7.", "7e0", "9223372036854775808", "x", "7 8", "+-7"}) {
    CAPTURE(word);
    CHECK_FALSE(fortran_integer(word));
  }
}
