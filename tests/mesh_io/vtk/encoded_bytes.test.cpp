#include "mesh_io/vtk/encoded_bytes.hpp"

#include <doctest/doctest.h>

#include <random>

#include "fixtures/polygon_files.hpp"

using namespace fccda;

namespace {
std::optional<std::string> decoded(std::string_view text, std::size_t count) { return EncodedBytes(text, Encoding::base64).next(count); }
}  // namespace

TEST_CASE("base64: the examples of RFC 4648 are decoded, at once and byte by byte") {
  const std::pair<const char*, const char*> examples[] = {{"Zg==", "f"},        {"Zm8=", "fo"},        {"Zm9v", "foo"},
                                                          {"Zm9vYg==", "foob"}, {"Zm9vYmE=", "fooba"}, {"Zm9vYmFy", "foobar"}};
  for (const auto& [text, expected] : examples) {
    const std::string bytes = expected;
    CHECK(decoded(text, bytes.size()) == bytes);
    CHECK_FALSE(decoded(text, bytes.size() + 1));
    EncodedBytes source(text, Encoding::base64);
    for (const char byte : bytes) CHECK(source.next(1) == std::string(1, byte));
  }
}

TEST_CASE("base64: all bytes are decoded, across white space and after padding") {
  std::string bytes;
  for (int k = 0; k < 256; ++k) bytes += static_cast<char>(k);
  std::string text = fixtures::base64(bytes.substr(0, 100)) + fixtures::base64(bytes.substr(100));
  for (std::size_t at = 10; at < text.size(); at += 33) text.insert(at, "\r\n \t");
  CHECK(decoded(text, 256) == bytes);
}

TEST_CASE("base64: invalid characters, a wrong end and too many requested bytes give nothing") {
  for (const char* text : {"Zm9", "Zm9*", "Z===", "====", "Zm=v", "Zg=", "Zg=g", "Z===Zg==", ""}) {
    CAPTURE(text);
    CHECK_FALSE(decoded(text, 1));
  }
  CHECK_FALSE(decoded("Zm9v", std::size_t{1} << 60));
  CHECK(decoded("", 0) == std::string());
}

TEST_CASE("raw bytes: are returned unchanged until the end") {
  EncodedBytes source("abc", Encoding::raw);
  CHECK(source.next(2) == std::string("ab"));
  CHECK_FALSE(source.next(2));
  CHECK(source.next(1) == std::string("c"));
}
