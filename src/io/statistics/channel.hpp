/// The channel that a ship leaves in a sheet of ice, seen from above.
///
/// The sheet that remains is every fragment that holds a given share of the particles at least: two halves of a split floe remain both, broken floes
/// and single particles do not. A cell of one spacing is *broken through* where it has particles and none of them belongs to the sheet
/// that remains. Across each column of cells the channel is the widest row of such cells without a gap; all places are those of the undeformed sheet, so
/// floes that drifted off leave their gap where they were broken out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

/// One column of cells across the channel.
struct ChannelColumn {
  double along;       ///< [m] its middle
  double low, high;   ///< [m] edges of the channel; both not-a-number where nothing is broken through
  double width;       ///< [m] between them; 0 where nothing is broken through
  double all_broken;  ///< [m] of all cells that are broken through, wherever they are in this column
};

/// `axis` along which the channel runs, 0 or 1: its width is measured along the other. `places` [m] of the undeformed particles with their
/// numbers of fragments; `least_share` of the particles, of a fragment that remains.
std::vector<ChannelColumn> channel_columns(std::span<const Vec3d> places, std::span<const std::int32_t> fragments, double spacing, std::size_t axis,
                                           double least_share);

/// Over the columns from `low` to `high` [m] that have a channel.
struct ChannelWidths {
  double length = 0;                       ///< [m] of these columns
  double mean = 0, deviation = 0;          ///< [m]
  double narrowest = 0, narrowest_at = 0;  ///< [m]
  double widest = 0, widest_at = 0;        ///< [m]
  double area = 0;                         ///< [m²] of the channel
  double all_broken = 0;                   ///< [m²] of all that is broken through
};
ChannelWidths widths_of(std::span<const ChannelColumn> columns, double spacing, double low, double high);

/// Where a results folder tells of a channel.
struct ChannelFrame {
  std::filesystem::path file;  ///< the picture that was read
  double time;                 ///< [s]
  double spacing;              ///< [m]
  std::vector<Vec3d> places;   ///< [m] undeformed
  std::vector<std::int32_t> fragments;
};

/// The last picture of a body that is not after `latest` [s]. Throws InputError where the folder has none, or the body never breaks.
ChannelFrame read_channel_frame(const std::filesystem::path& results, const std::string& body, std::optional<double> latest);

}  // namespace perimpact
