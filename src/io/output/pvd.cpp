#include "io/output/pvd.hpp"

#include <fmt/format.h>

#include <system_error>

#include "io/output/file.hpp"
#include "io/output/xml.hpp"

namespace perimpact::output {

Series::Series(std::filesystem::path folder, std::string name, std::vector<double> times)
    : folder_(std::move(folder)), name_(std::move(name)), times_(std::move(times)) {
  if (!times_.empty()) write_list();
  std::error_code none_left;
  for (std::size_t frame = times_.size(); std::filesystem::remove(folder_ / frame_file(frame), none_left);) ++frame;
}

std::string Series::frame_file(std::size_t frame) const { return fmt::format("{}_{:05}.vtp", name_, frame); }

void Series::write_list() const {
  std::string entries;
  for (std::size_t frame = 0; frame < times_.size(); ++frame)
    entries += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", times_[frame], xml_attribute(frame_file(frame)));
  write_whole_file(folder_ / (name_ + ".pvd"),
                   "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n" + entries + "  </Collection>\n</VTKFile>\n");
}

void Series::list(double time, const std::string& file) {
  times_.push_back(time);
  try {
    write_list();
  } catch (...) {  // a picture that no list names would never be seen
    times_.pop_back();
    std::error_code ignored;
    std::filesystem::remove(folder_ / file, ignored);
    throw;
  }
}

}  // namespace perimpact::output
