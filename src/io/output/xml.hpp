/// XML escaping shared by the VTK XML formats.
#pragma once

#include <string>
#include <string_view>

namespace perimpact::output {

/// Escapes text for use as an attribute value.
std::string xml_attribute(std::string_view words);

}  // namespace perimpact::output
