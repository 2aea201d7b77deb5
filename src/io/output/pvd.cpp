#include "io/output/pvd.hpp"

#include <fmt/format.h>

#include <system_error>

#include "io/output/file.hpp"
#include "io/output/xml.hpp"

namespace perimpact::output {

std::string Series::frame_file() const { return fmt::format("{}_{:05}.vtp", name_, frames_); }

void Series::list(double time, const std::string& file) {
  entries_ += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", time, xml_attribute(file));
  ++frames_;
  try {
    write_whole_file(folder_ / (name_ + ".pvd"),
                     "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n" + entries_ + "  </Collection>\n</VTKFile>\n");
  } catch (...) {  // a picture that no list names would never be seen
    std::error_code ignored;
    std::filesystem::remove(folder_ / file, ignored);
    throw;
  }
}

}  // namespace perimpact::output
