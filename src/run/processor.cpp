#include "run/processor.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "base/error.hpp"
#include "perimpact/device/emulated_device.hpp"
#include "run/plugin.hpp"

namespace perimpact {

namespace {

constexpr const char* library_name = "libperimpact_cuda.so";

std::unique_ptr<Device> open_gpu() {
  const std::filesystem::path file = plugin_file(library_name, "PERIMPACT_CUDA_LIBRARY");
  if (file.empty())
    throw fccda::InputError(
        fmt::format("--device cuda needs {}, which is not installed; build perimpact from source where nvcc is installed, or omit --device.", library_name));
  void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw fccda::InputError(fmt::format("--device cuda needs {}, which cannot be opened ({}); omit --device.", library_name, ::dlerror()));
  const auto open = reinterpret_cast<OpenDevice*>(::dlsym(library, open_device_name));
  std::string reason;
  std::unique_ptr<Device> device(open ? open(device_version, reason) : nullptr);
  if (device) return device;
  if (reason.empty()) throw fccda::InputError(fmt::format("{} is not of the version of this program; build both from the same sources.", file.string()));
  throw fccda::InputError(fmt::format("--device cuda: there is no usable GPU ({}); omit --device.", reason));
}

}  // namespace

Processor opened_processor(std::string_view word) {
  static std::unique_ptr<Device> device;
  if (word == "cpu-scalar") return {.is_scalar = true};
  if (word == "cuda" && !device) device = open_gpu();
  if (word == "emulated" && !device) device = std::make_unique<EmulatedDevice>();
  return {.device = device.get()};
}

}  // namespace perimpact
