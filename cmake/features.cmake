# Materials, boundary conditions and contact bounds: a folder each, known to the program by one line of src/perimpact/CMakeLists.txt.
#
#   add_material(bond_based BondBased DEPENDS perimpact/materials/ordinary_state)
#       src/perimpact/materials/bond_based: BondBasedSetup in setup.hpp, Material<BondBasedSetup> in material.hpp
#   add_boundary_condition(pressure Pressure DEPENDS perimpact/boundary_conditions/load)
#       src/perimpact/boundary_conditions/pressure: PressureSetup in setup.hpp, make_boundary(PressureSetup, …) in boundary.hpp
#   add_contact_bounds(box_union BoxUnionBounds DEPENDS perimpact/contact_bounds perimpact/deck_model)
#       src/perimpact/contact_bounds/box_union: BoxUnionBoundsSetup in setup.hpp, make_bounds(BoxUnionBoundsSetup, …) in bounds.hpp
#
# The line declares the module and puts the type on the lists from which deck, schema, construction and memory estimate are compiled. The order of
# the lines is that of the deck reference. setup.hpp and setup.cpp are part of perimpact/deck_model and see no particles (tests/quality/include_rules.py).
include_guard()

function(add_material name type)
  add_module(perimpact/materials/${name} ${ARGN})
  set_property(GLOBAL APPEND PROPERTY FEATURES_OF_materials ${name}:${type})
endfunction()

function(add_boundary_condition name type)
  add_module(perimpact/boundary_conditions/${name} ${ARGN})
  set_property(GLOBAL APPEND PROPERTY FEATURES_OF_boundary_conditions ${name}:${type})
endfunction()

function(add_contact_bounds name type)
  add_module(perimpact/contact_bounds/${name} ${ARGN})
  set_property(GLOBAL APPEND PROPERTY FEATURES_OF_contact_bounds ${name}:${type})
endfunction()

# list_features(materials MaterialSetup material): writes perimpact/materials/all_setups.hpp, with the variant MaterialSetup, and all_materials.hpp,
# which includes every material.hpp; types after the name of the variant come first in it. Sets `materials_modules`. Unchanged files keep their time, so that nothing is recompiled.
function(list_features kind variant header)
  list(POP_FRONT variant variant_name)
  set(types ${variant})
  get_property(features GLOBAL PROPERTY FEATURES_OF_${kind})
  set(origin "// Written by cmake/features.cmake from the lines of src/perimpact/CMakeLists.txt.\n#pragma once\n\n")
  foreach(feature ${features})
    string(REGEX REPLACE "(.*):(.*)" "\\1;\\2" feature ${feature})
    list(GET feature 0 name)
    list(GET feature 1 type)
    string(APPEND setups "#include \"perimpact/${kind}/${name}/setup.hpp\"\n")
    string(APPEND parts "#include \"perimpact/${kind}/${name}/${header}.hpp\"\n")
    list(APPEND types ${type}Setup)
    list(APPEND modules perimpact/${kind}/${name})
  endforeach()
  list(JOIN types ", " types)
  set(folder ${PROJECT_BINARY_DIR}/features)
  file(CONFIGURE OUTPUT ${folder}/perimpact/${kind}/all_setups.hpp @ONLY CONTENT
    "${origin}#include <variant>\n\n${setups}\nnamespace perimpact {\nusing ${variant_name} = std::variant<${types}>;\n}\n")
  file(CONFIGURE OUTPUT ${folder}/perimpact/${kind}/all_${kind}.hpp @ONLY CONTENT "${origin}${parts}")
  target_include_directories(perimpact_deck_model PUBLIC ${folder})
  set(${kind}_modules ${modules} PARENT_SCOPE)
endfunction()
