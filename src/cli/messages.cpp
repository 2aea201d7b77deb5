#include "cli/messages.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>

#include "base/error.hpp"
#include "cli/progress.hpp"
#include "io/output/file.hpp"

namespace perimpact {

using output::Json;

namespace {

int first_error = 0;  // of standard output

constexpr double terminal_interval = 0.25, json_interval = 1, file_interval = 10;  // [s]

bool has_redrawn_lines() {
  const char* const terminal = std::getenv("TERM");
  return isatty(STDOUT_FILENO) != 0 && (!terminal || std::string_view(terminal) != "dumb");
}

std::string joined(const std::vector<Messages::Part>& parts) {
  std::string line;
  for (const Messages::Part& part : parts) line += (line.empty() ? "" : "  ") + part.text;
  return line;
}

Json with_text(const std::string& sentence) {
  Json members = Json::object();
  members["text"] = sentence;
  return members;
}

}  // namespace

int lost_output() { return first_error; }

std::size_t terminal_width() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  std::size_t columns = 0;
  if (const char* const text = std::getenv("COLUMNS")) std::from_chars(text, text + std::strlen(text), columns);
  return columns > 0 ? columns : 80;
}

std::string line_within(std::size_t width, const std::vector<Messages::Part>& parts) {
  std::vector<Messages::Part> shown = parts;
  while (shown.size() > 1 && joined(shown).size() > width)
    shown.erase(std::min_element(shown.begin(), shown.end(), [](const auto& a, const auto& b) { return a.importance < b.importance; }));
  return joined(shown).substr(0, width);
}

Messages::Messages(const MessageArguments& arguments, Form form)
    : arguments_(arguments), form_(form), is_terminal_(form == Form::text && !arguments.quiet && arguments.has_terminal && has_redrawn_lines()) {
  if (arguments_.log.empty()) return;
  output::expect_place_for(arguments_.log);
  log_.reset(std::fopen(arguments_.log.c_str(), "ae"));
  if (!log_) throw fccda::InputError(fmt::format("--log {}: this file cannot be written: {}.", arguments_.log.string(), std::strerror(errno)));
}

Messages::~Messages() { end_progress(); }

void Messages::write(std::string_view text) {
  if (has_line_) std::fputs("\r\033[K", stdout);
  has_line_ = false;
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (std::fflush(stdout) != 0 && first_error == 0) first_error = errno;
}

void Messages::write_line(std::string_view event, const Json& members) {
  Json line = Json::object();
  line["event"] = event;
  line.append(members);
  write(line.line());
}

void Messages::write_log(std::string_view text) {
  if (!log_) return;
  std::fwrite(text.data(), 1, text.size(), log_.get());
  std::fflush(log_.get());
}

void Messages::print(std::string_view event, const Json& members, const std::string& text) {
  if (form_ == Form::json_lines) write_line(event, members);
  print(text);
}

void Messages::print(const std::string& text) {
  if (form_ == Form::text && !arguments_.quiet) write(text);
  write_log(text);
}

void Messages::note(const std::string& sentence) { print("note", with_text(sentence), sentence + '\n'); }

void Messages::warn(const std::string& sentence) {
  warnings_.push_back(sentence);
  const std::string text = fmt::format("warning: {}\n", sentence);
  if (form_ == Form::text) write(text);
  if (form_ == Form::json_lines) write_line("warning", with_text(sentence));
  write_log(text);
}

bool Messages::is_progress_due() const {
  return seconds() - drawn_ >= (is_terminal_ ? terminal_interval : form_ == Form::json_lines ? json_interval : file_interval);
}

void Messages::draw(const Json& members, const std::vector<Part>& parts, bool is_logged) {
  drawn_ = seconds();
  if (form_ == Form::json_lines) {
    write_line("progress", members);
  } else if (is_terminal_) {
    write(line_within(terminal_width() - 1, parts));  // in the last column some terminals already wrap
    has_line_ = true;
  } else if (form_ == Form::text && !arguments_.quiet) {
    write(joined(parts) + '\n');
  }
  if (is_logged) {
    logged_ = drawn_;
    write_log(joined(parts) + '\n');
  }
}

void Messages::progress(const Json& members, const std::vector<Part>& parts) { draw(members, parts, seconds() - logged_ >= file_interval); }

void Messages::stage(std::string_view stage, std::string_view of) {
  constexpr double is_long = 2;  // [s]
  const double now = seconds();
  if (!is_terminal_ && now < is_long) return;
  Json members = Json::object();
  members["stage"] = stage;
  if (!of.empty()) members["of"] = of;
  draw(members, {{fmt::format("set-up: {}{}{}", stage, of.empty() ? "" : " of ", of), 1}, {duration_in_words(now), 0}}, now - logged_ >= file_interval);
}

void Messages::end_progress(const Json& members, const std::vector<Part>& parts) {
  draw(members, parts, true);
  end_progress();
}

void Messages::end_progress() {
  if (!has_line_) return;
  has_line_ = false;
  write("\n");
}

std::string Messages::last_words(const std::string& sentence) const {
  if (form_ == Form::text) return arguments_.quiet ? "" : sentence + '\n';
  if (form_ == Form::none) return "";
  Json line = Json::object();
  line["event"] = "end";
  line["outcome"] = "interrupted";
  line["text"] = sentence;
  return line.line();
}

void Messages::log_error(std::string_view sentence) { write_log(fmt::format("error: {}\n", sentence)); }

}  // namespace perimpact
