/// What the restrictions of a part of the deck may ask beyond its own fields.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "perimpact/deck_model/motion_table.hpp"
#include "perimpact/deck_model/places.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

struct BodySetup;

/// A part of the deck with its key.
struct DeckContext {
  std::string key;  ///< "impactors.propeller.contact_bounds.box"
  const Places& places;

  /// True if the deck gives this key of the part.
  bool is_given(std::string_view own) const { return places.has(key + "." + std::string(own)); }

  /// Throw SetupError at the part, or at one of its keys.
  [[noreturn]] void refuse(const std::string& sentence) const { throw SetupError(key, sentence); }
  [[noreturn]] void refuse(std::string_view own, const std::string& sentence) const { throw SetupError(key + "." + std::string(own), sentence); }
};

/// The material or a boundary condition of a body.
struct BodyContext : DeckContext {
  BodySetup& body;
  std::string body_key;                                                  ///< "bodies.plate"
  bool is_quasi_static;                                                  ///< time.relax is given
  std::function<void(MotionTable&, const std::string& key)> read_table;  ///< fills the table from its file, if the deck names one

  [[noreturn]] void refuse_body(std::string_view key_of_body, const std::string& sentence) const {
    throw SetupError(body_key + "." + std::string(key_of_body), sentence);
  }
};

/// For materials that normalise each particle by its own family: throws SetupError if the deck asks for a surface correction.
void refuse_surface_correction(std::string_view model, const BodyContext& deck);

}  // namespace perimpact
