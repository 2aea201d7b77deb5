/// The embedded report page, built from report/ (report/dist/template.html).
#pragma once

#include <string_view>

namespace perimpact::report {

/// HTML that contains `data_mark` once, at the position of the data.
std::string_view page_template();

constexpr std::string_view data_mark = "<!--data of the run-->";

}  // namespace perimpact::report
