/// Channel width that a ship leaves in an ice sheet, in plan view.
///
/// The remaining sheet consists of all fragments with at least a given share of the particles: both halves of a split floe remain, broken floes and
/// single particles do not. A cell of one spacing is *broken through* where it has particles and none of them belongs to the remaining sheet. Across
/// each column of cells the channel is the widest contiguous run of such cells. All positions are those of the reference configuration, so floes
/// that drifted away leave a gap at their original position.
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
  double along;       ///< [m] centre of the column
  double low, high;   ///< [m] edges of the channel; both not-a-number without a channel
  double width;       ///< [m] distance between the edges; 0 without a channel
  double all_broken;  ///< [m] total width of the cells broken through in this column
};

/// Evaluates the channel per column. `axis`: direction of the channel, 0 or 1; its width is measured along the other. `places`: reference positions
/// of the particles [m], with their fragment numbers. `least_share`: minimum share of the particles for a fragment to remain.
std::vector<ChannelColumn> channel_columns(std::span<const Vec3d> places, std::span<const std::int32_t> fragments, double spacing, std::size_t axis,
                                           double least_share);

/// Statistics over the columns from `low` to `high` [m] that have a channel.
struct ChannelWidths {
  double length = 0;                       ///< [m] total length of these columns
  double mean = 0, deviation = 0;          ///< [m]
  double narrowest = 0, narrowest_at = 0;  ///< [m]
  double widest = 0, widest_at = 0;        ///< [m]
  double area = 0;                         ///< [m²] area of the channel
  double all_broken = 0;                   ///< [m²] total area broken through
};
ChannelWidths widths_of(std::span<const ChannelColumn> columns, double spacing, double low, double high);

/// Data of a results folder for the channel evaluation.
struct ChannelFrame {
  std::string name;           ///< of the frame that was read
  double time;                ///< [s]
  double spacing;             ///< [m]
  std::vector<Vec3d> places;  ///< [m] reference positions
  std::vector<std::int32_t> fragments;
};

/// The last frame of a body not later than `latest` [s]. Throws InputError where the folder has none, or the body has no failure criterion.
ChannelFrame read_channel_frame(const std::filesystem::path& results, const std::string& body, std::optional<double> latest);

}  // namespace perimpact
