#include "io/deck/reference.hpp"

#include <fmt/format.h>

#include "io/deck/schema.hpp"
#include "io/deck/units.hpp"
#include "io/deck/value.hpp"

namespace perimpact::deck {

using fccda::Vec3d;

namespace {

struct Description {
  std::string form;
  std::string default_text;
};

/// Throws std::logic_error if the unit of numbers is none that the reader knows.
std::string with_unit(std::string_view form, std::string_view unit) {
  return kind_of(unit).unit == "1" ? std::string(form) : fmt::format("{} [{}]", form, unit);
}

Description describe_value(double value, std::string_view unit) { return {with_unit("number", unit), fmt::format("{}", value)}; }
Description describe_value(int value, std::string_view unit) { return {with_unit("whole number", unit), fmt::format("{}", value)}; }
Description describe_value(bool value, std::string_view) { return {"true or false", value ? "true" : "false"}; }
Description describe_value(const std::string& value, std::string_view) { return {"text", value}; }
Description describe_value(const Choice& value, std::string_view) {
  return {fmt::format("one of {}", fmt::join(value.words, ", ")), std::string(value.word())};
}
Description describe_value(const Vec3d& value, std::string_view unit) {
  return {with_unit("three numbers", unit), fmt::format("[{}, {}, {}]", value.x, value.y, value.z)};
}
Description describe_value(const std::vector<double>&, std::string_view unit) { return {with_unit("list of numbers", unit), "[]"}; }
Description describe_value(const std::vector<std::string>& value, std::string_view) { return {"list of words", fmt::format("[{}]", fmt::join(value, ", "))}; }
Description describe_value(const std::vector<Vec3d>&, std::string_view unit) { return {with_unit("list of points", unit), "[]"}; }
template <class T>
Description describe_value(const std::optional<T>&, std::string_view unit) {
  return {describe_value(T{}, unit).form, ""};
}

class Lister {
 public:
  explicit Lister(std::vector<Entry>& entries) : entries_(entries) {}

  template <class T>
  void contents(T& defaults) {
    // GCC 12 warns about reading fields of empty structs.
    if constexpr (Described<T> && !std::is_empty_v<T>) {
      for (const Field<T>& field : T::fields()) list(field, defaults);
    }
    sections(*this, defaults);
  }

  template <class T>
  void section(std::string_view key, T& defaults, Presence presence, std::string_view sentence) {
    add_map(key, presence, sentence);
    inside(key, [&](Lister& inner) { inner.contents(defaults); });
  }

  template <class T>
  void section(std::string_view key, std::optional<T>&, Presence presence, std::string_view sentence) {
    static T defaults;  // static: see alternatives()
    section(key, defaults, presence, sentence);
  }

  template <class T>
  void named(std::string_view key, std::vector<T>&, Presence presence, std::string_view sentence) {
    add_map(key, presence, "");
    T defaults;
    inside(key, [&](Lister& names) { names.section(any_name, defaults, Presence::optional, sentence); });
  }

  template <class Variant>
  void one_of(std::string_view key, Variant& variant, Presence presence, std::string_view sentence) {
    add_map(key, presence, sentence);
    inside(key, [&](Lister& inner) { inner.alternatives(variant); });
  }

  template <class Variant>
  void alternatives(Variant& variant) {
    const std::vector<std::string> words = alternative_names(variant);
    constexpr bool may_be_absent = std::is_same_v<std::variant_alternative_t<0, Variant>, std::monostate>;
    const std::string need = may_be_absent ? "optional" : words.size() == 1 ? "required" : fmt::format("one of {}", fmt::join(words, ", "));
    for_each_alternative(variant, [&]<class T>(const T&) {
      static T defaults;  // static: GCC 12 warns about an uninitialised optional otherwise
      if (is_written_flat<T>()) {
        under(fmt::format("with {}", T::name), [&](Lister& inner) { inner.contents(defaults); });
        for (Entry& entry : entries_) {
          if (entry.path == path_of(T::name)) entry.need = need, entry.condition = "";
        }
      } else {
        add({.path = path_of(T::name), .form = "map", .need = need, .is_map = true});
        inside(T::name, [&](Lister& inner) { inner.contents(defaults); });
      }
    });
  }

  template <class Variant>
  void by_word(std::string_view key, std::string_view selector, Variant& variant, std::string_view sentence) {
    add_map(key, Presence::required, sentence);
    const std::vector<std::string> words = alternative_names(variant);
    inside(key, [&](Lister& inner) {
      inner.add({.path = inner.path_of(selector),
                 .form = fmt::format("one of {}", fmt::join(words, ", ")),
                 .need = "required",
                 .sentence = "Selects the alternative."});
      for_each_alternative(variant, [&]<class T>(const T&) {
        static T defaults;  // as above
        inner.under(fmt::format("with {}: {}", selector, T::name), [&](Lister& fields) { fields.contents(defaults); });
      });
    });
  }

 private:
  template <class T>
  void list(const Field<T>& field, const T& defaults) {
    const Description description = std::visit([&](auto member) { return describe_value(defaults.*member, field.unit); }, field.member);
    const bool is_required = field.presence == Presence::required;
    const bool has_range = field.range.low > -1e300 || field.range.high < 1e300;
    add({.path = path_of(field.name),
         .form = description.form,
         .range = has_range ? in_words(field.range) : "",
         .need = is_required                        ? "required"
                 : description.default_text.empty() ? "optional"
                                                    : "default " + description.default_text,
         .sentence = std::string(field.sentence)});
  }

  void add(Entry entry) {
    entry.condition = condition_;
    entries_.push_back(std::move(entry));
  }

  void add_map(std::string_view key, Presence presence, std::string_view sentence) {
    add({.path = path_of(key),
         .form = "map",
         .need = presence == Presence::required ? "required" : "optional",
         .is_map = true,
         .sentence = std::string(sentence)});
  }

  std::string path_of(std::string_view key) const { return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key); }

  template <class Visit>
  void inside(std::string_view key, const Visit& visit) {
    Lister inner(entries_);
    inner.path_ = path_of(key);
    visit(inner);
  }

  template <class Visit>
  void under(std::string condition, const Visit& visit) {
    Lister inner(entries_);
    inner.path_ = path_;
    inner.condition_ = std::move(condition);
    visit(inner);
  }

  std::vector<Entry>& entries_;
  std::string path_;
  std::string condition_;
};

}  // namespace

std::string_view Entry::key() const { return std::string_view(path).substr(path.rfind('.') + 1); }

std::string_view Entry::parent() const {
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos ? top_level : std::string_view(path).substr(0, dot);
}

const std::vector<Entry>& reference() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> entries;
    Setup defaults;
    Lister(entries).contents(defaults);
    return entries;
  }();
  return all;
}

}  // namespace perimpact::deck
