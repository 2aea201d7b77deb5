#include "io/deck/setup_to_text.hpp"

#include <fmt/format.h>

#include "io/deck/consistency.hpp"
#include "io/deck/json_text.hpp"
#include "io/deck/schema.hpp"

namespace perimpact::deck {

namespace {

/// Writes one map; a walker of the schema.
class Writer {
 public:
  explicit Writer(std::size_t depth) : depth_(depth) {}

  template <class T>
  void contents(T& from) {
    if constexpr (Described<T>) {
      for (const Field<T>& field : T::fields()) {
        if constexpr (std::is_same_v<T, BodySetup>) {
          if (from.published && std::find(set_by_published.begin(), set_by_published.end(), field.name) != set_by_published.end()) continue;
        }
        std::visit([&](auto member) { value(field.name, from.*member); }, field.member);
      }
    }
    sections(*this, from);
  }

  template <class T>
  void section(std::string_view key, T& from, Presence, std::string_view) {
    map(key, [&](Writer& inner) { inner.contents(from); });
  }

  template <class T>
  void section(std::string_view key, std::optional<T>& from, Presence presence, std::string_view sentence) {
    if (from) section(key, *from, presence, sentence);
  }

  template <class T>
  void named(std::string_view key, std::vector<T>& from, Presence, std::string_view) {
    map(key, [&](Writer& names) {
      for (T& element : from) names.map(element.name, [&](Writer& inner) { inner.contents(element); });
    });
  }

  template <class Variant>
  void one_of(std::string_view key, Variant& from, Presence, std::string_view) {
    map(key, [&](Writer& inner) { inner.alternatives(from); });
  }

  template <class Variant>
  void alternatives(Variant& from) {
    std::visit(
        [&]<class T>(T& chosen) {
          if constexpr (Described<T>) {
            if (is_written_flat<T>()) return contents(chosen);
            map(T::name, [&](Writer& inner) { inner.contents(chosen); });
          }
        },
        from);
  }

  template <class Variant>
  void by_word(std::string_view key, std::string_view selector, Variant& from, std::string_view) {
    map(key, [&](Writer& inner) {
      std::visit(
          [&]<class T>(T& chosen) {
            inner.line(selector, json_string(T::name));
            inner.contents(chosen);
          },
          from);
    });
  }

  std::string text() const {
    if (lines_.empty()) return "{}";
    const std::string indent(2 * depth_, ' ');
    return fmt::format("{{\n{}  {}\n{}}}", indent, fmt::join(lines_, ",\n  " + indent), indent);
  }

 private:
  void line(std::string_view key, const std::string& json_text) { lines_.push_back(fmt::format("{}: {}", json_string(key), json_text)); }

  template <class T>
  void value(std::string_view key, const T& from) {
    line(key, json(from));
  }
  template <class T>
  void value(std::string_view key, const std::optional<T>& from) {
    if (from) line(key, json(*from));
  }

  template <class Fill>
  void map(std::string_view key, const Fill& fill) {
    Writer inner(depth_ + 1);
    fill(inner);
    line(key, inner.text());
  }

  std::size_t depth_;
  std::vector<std::string> lines_;
};

}  // namespace

std::string setup_to_text(const Setup& setup) {
  Setup copy = setup;  // walkers take mutable references
  Writer writer(0);
  writer.contents(copy);
  return writer.text() + "\n";
}

}  // namespace perimpact::deck
