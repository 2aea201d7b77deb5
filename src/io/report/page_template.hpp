/// The page that report/ is built to (report/dist/template.html), as it is embedded in the program.
#pragma once

#include <string_view>

namespace perimpact::report {

/// HTML in which `data_mark` stands once, where the data belong.
std::string_view page_template();

constexpr std::string_view data_mark = "<!--data of the run-->";

}  // namespace perimpact::report
