/// The command `perimpact`.
#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <system_error>

#include "base/error.hpp"
#include "cli/command_table.hpp"
#include "cli/messages.hpp"
#include "cli/parse_command_line.hpp"
#include "run/launch.hpp"

namespace {

using namespace perimpact;

/// Reports the error and ends the other ranks of the run, if any.
int fail(int exit_code, const std::string& sentence) {
  end_failed(exit_code, [&] {
    std::fprintf(stderr, "error: %s\n", sentence.c_str());
    std::fflush(stdout);
  });
  return exit_code;
}

/// Detects output lost on a full disk.
void expect_printed() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  const int reason = lost_output() != 0 ? lost_output() : errno;
  throw fccda::RunError(fmt::format("the output cannot be printed: {}. Free disk space, or redirect it elsewhere.", std::strerror(reason)));
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // lines appear at once, also through a pipe
  std::signal(SIGXFSZ, SIG_IGN);                  // reaching `ulimit -f` then is a write error like a full disk, instead of ending the program
  try {
    Arguments arguments;
    const int code = parse_command_line(command_table(arguments), argc, argv)();
    expect_printed();
    close_ranks();
    return code;
  } catch (const fccda::InputError& error) {
    return fail(2, error.what());
  } catch (const fccda::RunError& error) {
    return fail(3, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(2, fmt::format("{} cannot be accessed: {}; check its permissions and those of its folders.", error.path1().string(), error.code().message()));
  } catch (const std::system_error& error) {  // from fmt on a failed print
    return fail(3, fmt::format("the output cannot be printed: {}. Free disk space, or redirect it elsewhere.", error.code().message()));
  } catch (const std::bad_alloc&) {
    return fail(3, "there is not enough memory for this set-up; use a larger spacing or fewer panels.");
  }
}
