# How every module of the tree is compiled, and the one function that declares a module.
include_guard()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

set(PERIMPACT_ARCH "native" CACHE STRING "Instruction set the code is built for: the value of -march, or empty for the compiler's own default")
option(PERIMPACT_SCALAR_PACK "Kernels work on one particle at a time: for the sanitizers and as the oracle of the tests" OFF)
option(PERIMPACT_CONTRACTS "Check the contracts (EXPECTS) at run time" OFF)
option(PERIMPACT_WERROR "Treat warnings as errors" OFF)

option(PERIMPACT_GROUPED "Compile tests, and modules that say so, eight sources at a time: faster from scratch, slower after a change" OFF)

find_package(OpenMP REQUIRED)

# Results are promised to be bitwise the same for any number of threads, so no flag may let the compiler reorder or contract
# floating-point operations: kernels name their fused multiply-adds. math-errno and trapping-math change no result.
add_library(build_flags INTERFACE)
target_compile_options(build_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wno-psabi -Wno-missing-field-initializers $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -fno-math-errno -fno-trapping-math -ffp-contract=off
  $<$<BOOL:${PERIMPACT_ARCH}>:-march=${PERIMPACT_ARCH}> $<$<BOOL:${PERIMPACT_WERROR}>:-Werror>)
target_compile_definitions(build_flags INTERFACE
  $<$<BOOL:${PERIMPACT_SCALAR_PACK}>:FCCDA_SCALAR_PACK> $<$<BOOL:${PERIMPACT_CONTRACTS}>:FCCDA_CONTRACTS>)
target_link_libraries(build_flags INTERFACE OpenMP::OpenMP_CXX)

# In a release, a target that takes a third less time to compile and runs slower: for tests, and for what takes longer to compile than it will ever run.
# At -O1 alone g++ 12 loses what visitors of state write (base/state.hpp): restored states differed in tests. Without these two analyses it does not.
function(compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1> $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-fno-ipa-modref;-fno-ipa-pure-const>)
endfunction()

# add_module(mesh DEPENDS base): the sources of src/mesh (not of its sub-folders) as target mesh.
# The deck part of a material or boundary condition, setup.cpp in its folder, belongs to perimpact/deck_model (features.cmake).
# With PERIMPACT_GROUPED, GROUPED modules are compiled eight sources at a time: those that take long, have no kernels (what is inlined where
# depends on what is compiled with it) and name their helpers apart.
function(add_module path)
  cmake_parse_arguments(ARG "GROUPED" "" "DEPENDS;LINK" ${ARGN})
  string(REPLACE "/" "_" target ${path})
  get_filename_component(source_root "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../src" ABSOLUTE)
  file(GLOB sources CONFIGURE_DEPENDS ${source_root}/${path}/*.cpp)
  if(path STREQUAL "perimpact/deck_model")
    file(GLOB features CONFIGURE_DEPENDS ${source_root}/perimpact/materials/*/setup.cpp ${source_root}/perimpact/boundary_conditions/*/setup.cpp
      ${source_root}/perimpact/contact_bounds/*/setup.cpp)
    list(APPEND sources ${features})
  elseif(path MATCHES "^perimpact/(materials|boundary_conditions|contact_bounds)/")
    list(FILTER sources EXCLUDE REGEX "/setup\\.cpp$")
  endif()
  if(sources)
    add_library(${target} STATIC ${sources})
    set(scope PUBLIC)
    # inline functions hidden: a shared library keeps to its own copies of them, whatever flags a program compiles the headers with
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON VISIBILITY_INLINES_HIDDEN ON)
    if(ARG_GROUPED AND PERIMPACT_GROUPED)
      set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    endif()
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${source_root}>)
  target_link_libraries(${target} ${scope} $<BUILD_INTERFACE:build_flags>)
  foreach(dependency ${ARG_DEPENDS})
    string(REPLACE "/" "_" dependency_target ${dependency})
    target_link_libraries(${target} ${scope} ${dependency_target})
  endforeach()
  if(ARG_LINK)
    target_link_libraries(${target} ${scope} ${ARG_LINK})
  endif()
  set_property(GLOBAL APPEND PROPERTY MODULES ${target})
endfunction()
