#include "perimpact/simulation/state_hash.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "fixtures/threads.hpp"

using perimpact::StateHash;

namespace {

template <class T>
std::uint64_t hash_of(const std::string& name, const std::vector<T>& values, std::uint64_t first = 0) {
  StateHash hash;
  hash.add(name, first, std::span<const T>(values));
  return hash.value();
}

std::vector<double> some_numbers(std::size_t count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<double> numbers(count);
  for (double& one : numbers) one = number(random);
  return numbers;
}

}  // namespace

TEST_CASE("state hash: parts of an array, hashed apart with their indices and added in any order, give the hash of the array") {
  const std::vector<double> numbers = some_numbers(1000);
  std::vector<std::uint8_t> bytes(1000);
  for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<std::uint8_t>(k * k);
  StateHash whole, parts;
  whole.add("x", 0, std::span(numbers)), whole.add("bonds", 0, std::span(bytes));
  std::vector<std::size_t> begins{0, 1, 8, 400, 999};
  std::ranges::reverse(begins);
  for (const std::size_t begin : begins) {
    const std::size_t end = begin == 0 ? 1 : begin == 1 ? 8 : begin == 8 ? 400 : begin == 400 ? 999 : 1000;
    StateHash of_process;
    of_process.add("bonds", begin, std::span(bytes).subspan(begin, end - begin));
    of_process.add("x", begin, std::span(numbers).subspan(begin, end - begin));
    parts.add(of_process);
  }
  CHECK(parts.value() == whole.value());
}

TEST_CASE("state hash: any two values that are swapped change it") {
  std::vector<double> numbers = some_numbers(60);
  const std::uint64_t before = hash_of("x", numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      std::swap(numbers[i], numbers[j]);
      REQUIRE(hash_of("x", numbers) != before);
      std::swap(numbers[i], numbers[j]);
    }
  CHECK(hash_of("x", numbers) == before);
}

TEST_CASE("state hash: a single bit, an index, the length, and the name change it") {
  std::vector<double> numbers = some_numbers(100);
  std::set<std::uint64_t> hashes{hash_of("x", numbers)};
  for (const double last : {0.0, 5e-324, -0.0}) {
    std::vector<double> longer = numbers;
    longer.push_back(last);
    hashes.insert(hash_of("x", longer));
  }
  hashes.insert(hash_of("x", numbers, 1));
  hashes.insert(hash_of("y", numbers));
  hashes.insert(hash_of("", numbers));
  hashes.insert(hash_of("x", std::vector<double>(numbers.begin(), numbers.end() - 1)));
  hashes.insert(hash_of("x", std::vector<double>()));
  std::vector<double> turned = numbers;
  std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  hashes.insert(hash_of("x", turned));
  CHECK(hashes.size() == 10);
  std::vector<std::uint64_t> words(8, 0);
  for (std::size_t word = 0; word < words.size(); ++word)
    for (int bit = 0; bit < 64; ++bit) {
      words[word] = std::uint64_t{1} << bit;
      hashes.insert(hash_of("x", words));
      words[word] = 0;
    }
  CHECK(hashes.size() == 10 + 512);
}

TEST_CASE("state hash: zeros in arrays of different lengths differ, so that an array that grew is detected") {
  std::set<std::uint64_t> hashes;
  for (std::size_t length = 0; length < 100; ++length) hashes.insert(hash_of("x", std::vector<std::uint8_t>(length, 0)));
  CHECK(hashes.size() == 100);
}

TEST_CASE("state hash: the number of threads does not matter") {
  const std::vector<double> numbers = some_numbers(3'000'000);  // more than one thread hashes
  std::set<std::uint64_t> hashes;
  for (const int threads : {1, 2, 3}) {
    const fixtures::Threads with_several(threads);
    hashes.insert(hash_of("x", numbers));
  }
  CHECK(hashes.size() == 1);
}
