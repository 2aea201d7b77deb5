# Tests, found by their titles: programs of *.test.cpp, one a library, and claims about programs, checked from outside with Python.
include_guard()
find_package(doctest REQUIRED)
include(doctest)

# add_claims(cli tests/cli/words.test.py $<TARGET_FILE:perimpact>): each claim of the script (tests/cli/claims.py) is a test. Python's
# standard library is enough, unless a claim says otherwise. NEEDS: a fixture of ctest. LABELS: as elsewhere.
function(add_claims prefix script program)
  cmake_parse_arguments(ARG "" "NEEDS;LABELS" "" ${ARGN})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script})
  file(STRINGS ${script} claims REGEX "^@claim\\(\".*\"\\)$")
  foreach(claim ${claims})
    string(REGEX REPLACE "^@claim\\(\"(.*)\"\\)$" "\\1" title "${claim}")
    add_test(NAME "${prefix}: ${title}" COMMAND /usr/bin/python3 ${script} ${program} "${title}")
    set_tests_properties("${prefix}: ${title}" PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300 ENVIRONMENT PYTHONDONTWRITEBYTECODE=1 FIXTURES_REQUIRED "${ARG_NEEDS}" LABELS "${ARG_LABELS}")
  endforeach()
endfunction()

# add_tests(fccda LINK fccda)
function(add_tests name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  get_filename_component(root "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/.." ABSOLUTE)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${root}/tests/${name}/*.test.cpp)
  add_executable(${name}_tests ${sources} ${root}/tests/main.cpp)
  target_include_directories(${name}_tests PRIVATE ${root}/tests)
  target_compile_definitions(${name}_tests PRIVATE PROJECT_FOLDER="${root}")
  target_link_libraries(${name}_tests PRIVATE doctest::doctest ${ARG_LINK})
  doctest_discover_tests(${name}_tests TEST_PREFIX "${name}: ")
endfunction()
