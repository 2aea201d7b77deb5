#include "mesh_io/keyword/lsdyna_keywords.hpp"

#include <algorithm>
#include <iterator>

namespace fccda {
namespace {

using Kind = LsdynaBlock::Kind;

/// Removes the option, such as `_OFFSET`, from the start of `rest`.
bool take(std::string_view& rest, std::string_view option) {
  const bool is_next = rest.starts_with(option) && (rest.size() == option.size() || rest[option.size()] == '_');
  if (is_next) rest.remove_prefix(option.size());
  return is_next;
}

/// The block, or Kind::other where unknown options remain.
LsdynaBlock known(LsdynaBlock block, std::string_view rest) { return rest.empty() ? block : LsdynaBlock{Kind::other}; }

LsdynaBlock shells(std::string_view rest) {
  LsdynaBlock out{Kind::shells};
  while (take(rest, "_THICKNESS") || take(rest, "_BETA") || take(rest, "_MCID")) out.has_thickness = true;  // all on one card
  if (take(rest, "_OFFSET")) ++out.more_cards;
  if (take(rest, "_DOF")) ++out.more_cards;
  return known(out, rest);
}

LsdynaBlock solids(std::string_view rest) {
  LsdynaBlock out{Kind::solids};
  take(rest, "_TET4TOTET10");  // the solver adds mid-side nodes: the geometry is the same
  if (take(rest, "_ORTHO")) out.more_cards += 2;
  if (take(rest, "_DOF")) ++out.more_cards;
  return known(out, rest);
}

LsdynaBlock thick_shells(std::string_view rest) {
  LsdynaBlock out{Kind::thick_shells};
  if (take(rest, "_BETA")) ++out.more_cards;
  return known(out, rest);
}

LsdynaBlock elements(std::string_view rest) {
  constexpr std::string_view without_surface[] = {"_BEAM",    "_BEARING", "_BLANKING", "_DIRECT",   "_DISCRETE", "_INERTIA",
                                                  "_LANCING", "_MASS",    "_PLOTEL",   "_SEATBELT", "_SPH",      "_TRIM"};
  if (take(rest, "_SHELL")) {
    // *ELEMENT_SHELL_SOURCE_SINK defines heat flow between shells, not shells
    return rest == "_SOURCE_SINK" ? LsdynaBlock{} : shells(rest);
  }
  if (take(rest, "_SOLID")) return solids(rest);
  if (take(rest, "_TSHELL")) return thick_shells(rest);
  const bool is_skipped = std::any_of(std::begin(without_surface), std::end(without_surface), [&](std::string_view one) { return take(rest, one); });
  return {is_skipped ? Kind::skipped : Kind::other};
}

LsdynaBlock parts(std::string_view rest) {
  if (rest.starts_with("_COMPOSITE")) return {Kind::part};
  for (const std::string_view maker : {"_DUPLICATE", "_MOVE", "_STACKED_ELEMENTS"})
    if (rest.starts_with(maker)) return {Kind::maker};
  LsdynaBlock out{Kind::parts};
  if (take(rest, "_INERTIA")) out.more_cards += 3, out.has_inertia = true;
  for (const std::string_view option : {"_REPOSITION", "_CONTACT", "_PRINT", "_ATTACHMENT_NODES", "_FIELD"})
    if (take(rest, option)) ++out.more_cards;
  return rest.empty() ? out : LsdynaBlock{};  // _ANNEAL, _MODES, _SENSOR …: of parts that are defined elsewhere
}

}  // namespace

LsdynaBlock lsdyna_block(std::string_view name) {
  if (name == "KEYWORD") return {Kind::usual_width};
  if (name == "END") return {Kind::end};
  if (name == "NODE") return {Kind::nodes};
  if (name == "NODE_TRANSFORM") return {Kind::maker};
  if (name.starts_with("INCLUDE") && !name.starts_with("INCLUDE_PATH")) return {Kind::include};
  if (name.starts_with("IGA_") || name.starts_with("MESH_SURFACE") || name.starts_with("COMPONENT_")) return {Kind::other};
  std::string_view rest = name;
  if (take(rest, "ELEMENT")) return elements(rest);
  if (take(rest, "PART")) return parts(rest);
  return {};
}

}  // namespace fccda
