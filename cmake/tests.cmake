# Tests, found by their titles: programs of *.test.cpp, one a library, and claims about programs, checked from outside with Python.
include_guard()
find_package(doctest REQUIRED)
include(doctest)

# add_claims(cli tests/cli/words.test.py $<TARGET_FILE:perimpact>): each claim of the script (tests/cli/claims.py) is a test. Python's
# standard library is enough, unless a claim says otherwise. NEEDS: a fixture of ctest. LABELS, TIMEOUT [s]: as elsewhere.
function(add_claims prefix script program)
  cmake_parse_arguments(ARG "" "NEEDS;LABELS;TIMEOUT" "" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script})
  file(STRINGS ${script} claims REGEX "^@claim\\(\".*\"\\)$")
  foreach(claim ${claims})
    string(REGEX REPLACE "^@claim\\(\"(.*)\"\\)$" "\\1" title "${claim}")
    add_test(NAME "${prefix}: ${title}" COMMAND /usr/bin/python3 ${script} ${program} "${title}")
    set_tests_properties("${prefix}: ${title}" PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT ${ARG_TIMEOUT} ENVIRONMENT PYTHONDONTWRITEBYTECODE=1 FIXTURES_REQUIRED "${ARG_NEEDS}" LABELS "${ARG_LABELS}")
  endforeach()
endfunction()

# The test runner's main, compiled once for all programs.
add_library(test_main OBJECT ${CMAKE_CURRENT_LIST_DIR}/../tests/main.cpp)
target_link_libraries(test_main PUBLIC doctest::doctest)
target_compile_definitions(test_main PUBLIC DOCTEST_CONFIG_SUPER_FAST_ASSERTS)

# add_tests(fccda LINK fccda): one program of all tests/fccda/**/*.test.cpp; with PERIMPACT_TESTS_ABOUT, of those files alone that have it, a
# regular expression, in their path or in a title, where the whole program would take long to build (sanitizers).
function(add_tests name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  get_filename_component(root "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/.." ABSOLUTE)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${root}/tests/${name}/*.test.cpp)
  if(PERIMPACT_TESTS_ABOUT)
    set(all ${sources})
    set(sources)
    foreach(source ${all})
      file(STRINGS ${source} titles REGEX "^TEST_CASE\\(\".*${PERIMPACT_TESTS_ABOUT}")
      if(titles OR source MATCHES "tests/.*(${PERIMPACT_TESTS_ABOUT})")
        list(APPEND sources ${source})
      endif()
    endforeach()
  endif()
  add_executable(${name}_tests ${sources})
  target_include_directories(${name}_tests PRIVATE ${root}/tests)
  target_compile_definitions(${name}_tests PRIVATE PROJECT_FOLDER="${root}")
  target_link_libraries(${name}_tests PRIVATE test_main ${ARG_LINK})
  doctest_discover_tests(${name}_tests TEST_PREFIX "${name}: ")
endfunction()
