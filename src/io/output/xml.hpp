/// The one thing that both XML formats of VTK need.
#pragma once

#include <string>
#include <string_view>

namespace perimpact::output {

/// Words as they may stand between the quotes of an attribute.
std::string xml_attribute(std::string_view words);

}  // namespace perimpact::output
