#include "mesh_io/file/contents.hpp"

#include <doctest/doctest.h>
#include <zlib.h>

#include "base/error.hpp"
#include "fixtures/surface_files.hpp"
#include "fixtures/temporary_folder.hpp"
#include "mesh_io/file/inflate.hpp"
#include "mesh_io/read_panels.hpp"

using namespace fccda;

namespace {

std::string packed(const std::string& contents, int window_bits) {
  z_stream stream{};
  REQUIRE(deflateInit2(&stream, 6, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string out(deflateBound(&stream, contents.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(contents.data()));
  stream.avail_in = static_cast<uInt>(contents.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}
std::string gzip(const std::string& contents) { return packed(contents, 15 + 16); }

}  // namespace

TEST_CASE("gzip: a compressed surface reads as the surface, in any case of its extensions") {
  const fixtures::TemporaryFolder folder;
  const std::string text = fixtures::stl_text(fixtures::unit_cube());
  fixtures::put(folder / "cube.stl.gz", gzip(text));
  fixtures::put(folder / "cube.STL.GZ", gzip(text));
  CHECK(read_panels(folder / "cube.stl.gz").panels.size() == 12);
  CHECK(read_panels(folder / "cube.STL.GZ").panels.size() == 12);
}

TEST_CASE("gzip: concatenated members are one file, and trailing zeros are ignored") {
  CHECK(gunzip(gzip("one ") + gzip("two") + std::string(512, '\0'), "f.gz") == "one two");
}

TEST_CASE("gzip: a truncated, damaged, empty or foreign file is refused in one sentence") {
  const std::string good = gzip(fixtures::stl_text(fixtures::unit_cube()));
  for (std::size_t length = 2; length < good.size(); ++length) {
    CHECK_THROWS_WITH_AS(gunzip(std::string_view(good).substr(0, length), "f.gz"), "f.gz: the gzip file is truncated; copy it again.", InputError);
  }
  std::string damaged = good;
  damaged[damaged.size() - 6] ^= 1;  // in the checksum
  CHECK_THROWS_WITH_AS(gunzip(damaged, "f.gz"), doctest::Contains("f.gz: the gzip file is damaged after "), InputError);
  CHECK_THROWS_WITH_AS(gunzip("solid cube", "f.gz"), "f.gz: this is not a gzip file, although its name ends in .gz; rename it or compress it again.",
                       InputError);
  CHECK_THROWS_WITH_AS(gunzip(gzip(""), "f.gz"), "f.gz: the gzip file has no contents; export it again.", InputError);
}

TEST_CASE("gzip: a file that decompresses to hundreds of times its size is refused before it fills the memory") {
  const std::string bomb = gzip(std::string(std::size_t{80} << 20, '\0'));
  CHECK_THROWS_WITH_AS(gunzip(bomb, "f.gz"),
                       "f.gz: the file decompresses to more than 64 MiB, the limit for a mesh file of its size; decompress it and inspect the contents.",
                       InputError);
}

TEST_CASE("zlib: a stream is decompressed only where its size is the expected one") {
  const std::string contents = "some bytes, some bytes, some bytes";
  const std::string stream = packed(contents, 15);
  CHECK(inflated(stream, contents.size()) == contents);
  CHECK_FALSE(inflated(stream, contents.size() - 1));
  CHECK_FALSE(inflated(stream, contents.size() + 1));
  CHECK_FALSE(inflated(std::string_view(stream).substr(0, stream.size() - 1), contents.size()));
  CHECK_FALSE(inflated("", 0));
  CHECK_FALSE(inflated(contents, contents.size()));
}
