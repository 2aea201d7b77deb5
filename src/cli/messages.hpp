/// What `run` and `check` print: text on standard output, or JSON for programs, and a log file. Everything is printed at once, also through a pipe. On a
/// terminal the progress line is redrawn in place, within the width, and other lines are printed above it.
///
/// Lost output (a full disk, a closed pipe) never ends a run; main.cpp reports it at the end.
#pragma once

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/output/json.hpp"

namespace perimpact {

/// Version of what --json and --progress json print. It changes if a member is renamed, removed or gets another meaning.
constexpr int messages_schema = 1;

struct MessageArguments {
  bool quiet = false;    ///< warnings and errors only
  bool verbose = false;  ///< details too
  std::filesystem::path log;
  bool has_terminal = true;  ///< if standard output is one; not through mpirun, whose own output may go to a file
};

class Messages {
 public:
  enum class Form {
    text,
    json_lines,  ///< an object with the member "event" for each message
    none         ///< warnings are only collected
  };

  /// Throws InputError where the log file cannot be written.
  Messages(const MessageArguments& arguments, Form form);
  ~Messages();
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  Form form() const { return form_; }
  bool is_verbose() const { return arguments_.verbose; }

  /// Lines of text that end in a new line; as JSON, an event with these members.
  void print(std::string_view event, const output::Json& members, const std::string& text);
  /// Text that JSON does not contain, since other events have its content.
  void print(const std::string& text);
  void note(const std::string& sentence);
  void warn(const std::string& sentence);
  const std::vector<std::string>& warnings() const { return warnings_; }  ///< so far

  /// The progress line: parts in order, of which the least important are omitted where the terminal is too narrow.
  struct Part {
    std::string text;
    int importance;
  };
  bool is_progress_due() const;  ///< four times a second on a terminal, every second as JSON, otherwise every ten seconds
  void progress(const output::Json& members, const std::vector<Part>& parts);
  /// A stage of the set-up, as progress: always on a terminal, elsewhere only in set-ups longer than two seconds. `of`: a body or impactor.
  void stage(std::string_view stage, std::string_view of = {});
  void end_progress(const output::Json& members, const std::vector<Part>& parts);  ///< a last time; the line remains, and what follows begins below it
  void end_progress();                                                             ///< as it is, if there is one

  /// What a handler of signals prints when it ends the program, in this form.
  std::string last_words(const std::string& sentence) const;
  /// Writes to the log file only: the sentence that ends the program, which main.cpp prints.
  void log_error(std::string_view sentence);

 private:
  void write(std::string_view text);
  void write_line(std::string_view event, const output::Json& members);
  void write_log(std::string_view text);
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
  void draw(const output::Json& members, const std::vector<Part>& parts, bool is_logged);

  MessageArguments arguments_;
  Form form_;
  bool is_terminal_;
  bool has_line_ = false;  // the progress line is where the next character is printed
  std::vector<std::string> warnings_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double drawn_ = 0, logged_ = 0;  // [s] when progress was last drawn, and written to the log file
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> log_;
};

/// Calls f(); the sentence of an exception is also written to the log file, and below the progress line.
template <class F>
auto logged(Messages& messages, const F& f) {
  try {
    return f();
  } catch (const std::exception& error) {
    messages.end_progress();
    messages.log_error(error.what());
    throw;
  }
}

/// The reason why output was lost, as errno has it; 0 if none was.
int lost_output();

/// Columns of the terminal of standard output at this moment; without one, or where it does not say, COLUMNS, or 80.
std::size_t terminal_width();

/// The parts in one line of at most `width` columns, two spaces between them.
std::string line_within(std::size_t width, const std::vector<Messages::Part>& parts);

}  // namespace perimpact
