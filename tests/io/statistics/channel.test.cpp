#include "io/statistics/channel.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "base/error.hpp"
#include "fixtures/temporary_folder.hpp"
#include "fixtures/tolerance.hpp"
#include "io/output/pvd.hpp"
#include "io/output/vtp.hpp"

using namespace perimpact;

namespace {

constexpr double spacing = 0.5;

/// A sheet of 80 by 60 by 2 cells; `piece_of(i, j, k)` is the fragment of a cell, negative for an empty cell.
struct Sheet {
  std::vector<Vec3d> places;
  std::vector<std::int32_t> fragments;

  explicit Sheet(const std::function<int(int, int, int)>& fragment_of) {
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 60; ++j)
        for (int i = 0; i < 80; ++i) {
          if (fragment_of(i, j, k) < 0) continue;
          places.push_back({10 + spacing * (i + 0.5), -15 + spacing * (j + 0.5), spacing * k});
          fragments.push_back(fragment_of(i, j, k));
        }
  }
};

/// Two halves, numbers 0 and 1, on both sides of the channel, and floes of 4 cells in it, from number 2.
int of_channel(int i, int j, int low, int high) {
  if (j < low) return 0;
  if (j >= high) return 1;
  return 2 + i / 4;
}

}  // namespace

TEST_CASE("channel: a straight channel has a uniform width, along x and along y") {
  const Sheet sheet([](int i, int j, int) { return of_channel(i, j, 20, 44); });
  const auto columns = channel_columns(sheet.places, sheet.fragments, spacing, 0, 0.1);
  REQUIRE(columns.size() == 80);
  const double rounding = 1e-12;
  for (std::size_t c = 0; c < 80; ++c) {
    CHECK(std::abs(columns[c].along - (10.25 + 0.5 * static_cast<double>(c))) < rounding);
    CHECK(std::abs(columns[c].low - (-15 + 0.5 * 20)) < rounding);
    CHECK(std::abs(columns[c].high - (-15 + 0.5 * 44)) < rounding);
    CHECK(columns[c].width == 12);
    CHECK(columns[c].all_broken == 12);
  }
  const ChannelWidths widths = widths_of(columns, spacing, -1e9, 1e9);
  CHECK(widths.length == 40);
  CHECK(widths.mean == fixtures::relative(12, rounding));
  CHECK(widths.deviation < rounding);
  CHECK(widths.area == fixtures::relative(480, rounding));
  CHECK(widths.all_broken == fixtures::relative(480, rounding));

  // the same rotated by 90 degrees
  std::vector<Vec3d> turned;
  for (const Vec3d& place : sheet.places) turned.push_back({-place.y, place.x, place.z});
  const ChannelWidths of_turned = widths_of(channel_columns(turned, sheet.fragments, spacing, 1, 0.1), spacing, -1e9, 1e9);
  CHECK(of_turned.length == widths.length);
  CHECK(of_turned.mean == fixtures::relative(widths.mean, rounding));
}

TEST_CASE("channel: the extremes of a widening channel are given with their positions, within the given limits") {
  const auto high = [](int i) { return 22 + i / 4; };  // 2 cells at the lower end, 21 at the upper
  const Sheet sheet([&](int i, int j, int) { return of_channel(i, j, 20, high(i)); });
  const auto columns = channel_columns(sheet.places, sheet.fragments, spacing, 0, 0.1);
  const ChannelWidths all = widths_of(columns, spacing, -1e9, 1e9);
  CHECK(all.narrowest == 1);
  CHECK(all.narrowest_at == 10.25);
  CHECK(all.widest == 10.5);
  CHECK(all.widest_at == fixtures::relative(10 + 0.5 * 76.5, 1e-14));
  CHECK(all.mean == fixtures::relative(5.75, 1e-12));
  CHECK(all.deviation == fixtures::relative(0.5 * std::sqrt((20 * 20 - 1) / 12.0), 1e-12));  // of 20 equally likely integers
  const ChannelWidths middle = widths_of(columns, spacing, 20, 30);
  CHECK(middle.length == 10);
  CHECK(middle.narrowest == 3.5);
  CHECK(middle.widest == 5.5);
}

TEST_CASE("channel: broken cells outside it do not add to its width, but to the total broken through") {
  const Sheet sheet([](int i, int j, int k) {
    if (j == 3 && i < 40) return 100 + i;   // single particles along a crack in one half, through both layers
    if (j == 50 && k == 0) return 200 + i;  // spalled at the bottom only: the sheet remains above
    if (j == 52 && k == 1) return 300 + i;  // and vice versa
    return of_channel(i, j, 30, 40);
  });
  const auto columns = channel_columns(sheet.places, sheet.fragments, spacing, 0, 0.1);
  for (std::size_t c = 0; c < 80; ++c) {
    CHECK(columns[c].width == 5);
    CHECK(columns[c].all_broken == (c < 40 ? 5.5 : 5.0));
  }
}

TEST_CASE("channel: empty cells neither end nor widen it, and without broken cells there is none") {
  const Sheet sheet([](int i, int j, int) {
    if (i >= 50) return j < 30 ? 0 : 1;             // a crack, but no floes
    if (i < 10 && (j == 25 || j == 40)) return -1;  // a hole in the channel, and one outside
    return of_channel(i, j, 20, 40);
  });
  const auto columns = channel_columns(sheet.places, sheet.fragments, spacing, 0, 0.1);
  for (std::size_t c = 0; c < 80; ++c) {
    CHECK(columns[c].width == (c < 50 ? 10 : 0));
    CHECK(std::isnan(columns[c].low) == (c >= 50));
  }
  const ChannelWidths widths = widths_of(columns, spacing, -1e9, 1e9);
  CHECK(widths.length == 25);
  CHECK(widths.narrowest == 10);
  CHECK(widths_of(columns, spacing, 40, 50).length == 0);
}

TEST_CASE("channel: the share determines which fragments form the remaining sheet") {
  const Sheet sheet([](int, int j, int) { return j < 20 ? 0 : j < 40 ? 1 : 2; });  // thirds
  const auto length = [&](double share) { return widths_of(channel_columns(sheet.places, sheet.fragments, spacing, 0, share), spacing, -1e9, 1e9).length; };
  CHECK(length(0.3) == 0);
  CHECK(length(0.35) == 40);  // nothing remains
}

TEST_CASE("channel: it is read from the last frame up to a time, with the positions of the first") {
  const fixtures::TemporaryFolder folder;
  const std::filesystem::path frames = folder / "frames";
  std::filesystem::create_directories(frames);
  fixtures::put(folder / "run.json", R"({"bodies": {"ice": {"spacing [m]": 0.5, "fragments": {"fragments": 3}}, "rock": {"spacing [m]": 0.5}}})");
  output::Series series(frames, "ice");
  const Sheet whole([](int, int, int) { return 0; }), half([](int i, int j, int) { return i < 40 ? of_channel(i, j, 20, 44) : 0; }),
      broken([](int i, int j, int) { return of_channel(i, j, 20, 44); });
  double time = 0;
  for (const Sheet* sheet : {&whole, &half, &broken}) {
    std::vector<float> points;
    for (const Vec3d& place : sheet->places)  // floes drift off
      for (std::size_t c = 0; c < 3; ++c) points.push_back(static_cast<float>(place[c] + 3 * time));
    series.add(time, [&](const std::filesystem::path& path) {
      output::write_vtp(
          path, {.points = std::span<const float>(points), .point_arrays = {{"fragment", 1, std::span<const std::int32_t>(sheet->fragments)}}, .time = time},
          output::Compression::zlib);
    });
    time += 0.25;
  }
  const auto length = [&](std::optional<double> latest) {
    const ChannelFrame frame = read_channel_frame(folder.path(), "ice", latest);
    CHECK(frame.spacing == 0.5);
    return widths_of(channel_columns(frame.places, frame.fragments, frame.spacing, 0, 0.1), frame.spacing, -1e9, 1e9).length;
  };
  CHECK(length({}) == 40);
  CHECK(length(0.49) == 20);
  CHECK(length(0.5) == 40);
  CHECK(length(0.1) == 0);
  CHECK(read_channel_frame(folder.path(), "ice", 0.3).time == 0.25);

  const auto message = [&](const std::string& body, std::optional<double> latest = {}) {
    try {
      read_channel_frame(folder.path(), body, latest);
    } catch (const fccda::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(message("snow") == "--channel: " + folder.path().string() + " has no body snow; its bodies: ice, rock.");
  CHECK(message("rock") ==
        "--channel: body rock has no failure criterion, so it has no channel; set critical_stretch in its material, or failure in the body.");
  CHECK(message("ice", -1) == (frames / "ice.pvd").string() + " lists no frame up to -1 s; use a later --to.");
  const std::string report = fixtures::text_of(folder / "run.json");
  fixtures::put(folder / "run.json", R"({"bodies": {"ice": {"spacing [m]": "wide", "fragments": {"fragments": 3}}}})");
  CHECK(message("ice") ==
        (folder / "run.json").string() + ": the spacing of body ice is \"wide\", but a length in metres is needed; use the file as written by the run.");
  fixtures::put(folder / "run.json", report);
  Sheet wrong = whole;
  wrong.fragments[7] = -3;
  const std::vector<float> origin(3 * wrong.places.size(), 0.0f);
  series.add(time, [&](const std::filesystem::path& path) {
    output::write_vtp(
        path, {.points = std::span<const float>(origin), .point_arrays = {{"fragment", 1, std::span<const std::int32_t>(wrong.fragments)}}, .time = time},
        output::Compression::none);
  });
  CHECK(message("ice").find(": -3 is no number of a fragment; use the file as written by the run.") != std::string::npos);
  std::filesystem::remove(frames / "ice.pvd");
  CHECK(message("ice") == (frames / "ice.pvd").string() + " does not exist; the channel width is read from frames, so the run needs output.frames.");
  std::filesystem::remove(folder / "run.json");
  CHECK(message("ice") == (folder / "run.json").string() + " does not exist; the channel width is available once the run has ended or was interrupted.");
}
