/// All commands of `perimpact` with their options.
#pragma once

#include "cli/command.hpp"
#include "cli/commands.hpp"
#include "cli/report_command.hpp"
#include "cli/shape_command.hpp"
#include "cli/statistics_command.hpp"

namespace perimpact {

/// What the options of the commands set.
struct Arguments {
  RunArguments run;
  CheckArguments check;
  DescribeArguments describe;
  NewArguments starter;
  MeshArguments mesh;
  ShapeArguments shape;
  StatisticsArguments statistics;
  ReportArguments report;
  std::string shell;
  bool is_version = false, lists_shapes = false, is_markdown = false;
};

/// The table; its options set `arguments`, which must outlive it.
Command command_table(Arguments& arguments);

}  // namespace perimpact
