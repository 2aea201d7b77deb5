# The contact library as others get it: one libfccda of the modules' object files, its headers and a CMake package.
#
#   find_package(fccda REQUIRED)
#   target_link_libraries(app PRIVATE fccda::fccda)
#
# Users compile the headers with flags of their own: nothing of build_flags is passed on, only C++20, OpenMP and the include folder.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# All modules declared so far are those of fccda. Inside the tree they go on linking one another, so that the include rules stay true.
get_property(modules GLOBAL PROPERTY MODULES)
set(objects "")
foreach(module ${modules})
  get_target_property(type ${module} TYPE)
  if(NOT type STREQUAL INTERFACE_LIBRARY)
    list(APPEND objects $<TARGET_OBJECTS:${module}>)
  endif()
endforeach()

add_library(fccda_library ${objects})  # static, or shared by BUILD_SHARED_LIBS
add_library(fccda::fccda ALIAS fccda_library)
set_target_properties(fccda_library PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME fccda EXPORT_NAME fccda VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_compile_features(fccda_library PUBLIC cxx_std_20)
target_include_directories(fccda_library INTERFACE $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/..>)
target_link_libraries(fccda_library PUBLIC OpenMP::OpenMP_CXX PRIVATE ZLIB::ZLIB)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/fccda)
# below include/fccda, so that names as general as mesh/ and base/ do not stand in everybody's include folder
set(include_folder ${CMAKE_INSTALL_INCLUDEDIR}/fccda)
install(TARGETS fccda_library EXPORT fccda_targets COMPONENT fccda INCLUDES DESTINATION ${include_folder})
foreach(folder base mesh mesh_io marine fccda)
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/../${folder} DESTINATION ${include_folder} COMPONENT fccda FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
endforeach()
install(EXPORT fccda_targets NAMESPACE fccda:: FILE fccdaTargets.cmake DESTINATION ${package_folder} COMPONENT fccda)

# For Fortran a source, which programs compile themselves: modules of one compiler cannot be read by another.
set(fortran_folder ${CMAKE_INSTALL_DATADIR}/fccda)
install(FILES ${CMAKE_CURRENT_SOURCE_DIR}/fortran/fccda.f90 DESTINATION ${fortran_folder} COMPONENT fccda)

# Paths from one installed folder to another, so that the whole can be moved
file(RELATIVE_PATH to_fortran ${CMAKE_INSTALL_PREFIX}/${package_folder} ${CMAKE_INSTALL_FULL_DATADIR}/fccda)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/fccdaConfig.cmake @ONLY CONTENT [=[
get_property(fccda_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if(NOT "CXX" IN_LIST fccda_languages)
  set(fccda_FOUND FALSE)
  set(fccda_NOT_FOUND_MESSAGE "fccda is linked with the libraries of C++: add CXX to the LANGUAGES of project().")
  return()
endif()
include(CMakeFindDependencyMacro)
find_dependency(OpenMP COMPONENTS CXX)
find_dependency(ZLIB)
include(${CMAKE_CURRENT_LIST_DIR}/fccdaTargets.cmake)
get_filename_component(fccda_FORTRAN_MODULE ${CMAKE_CURRENT_LIST_DIR}/@to_fortran@/fccda.f90 ABSOLUTE)
]=])
# before 1.0 a new minor version may change what callers see
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/fccdaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/fccdaConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/fccdaConfigVersion.cmake DESTINATION ${package_folder} COMPONENT fccda)
install(FILES ${CMAKE_CURRENT_SOURCE_DIR}/../../LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT fccda)

# For C and Fortran without CMake: fccda.pc. A static library is linked with what it needs in any case, so that `pkg-config --libs fccda` suffices.
set(needed ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(FILTER needed INCLUDE REGEX "^(stdc\\+\\+|c\\+\\+)$")
list(APPEND needed ${OpenMP_CXX_LIB_NAMES} z m)
list(REMOVE_DUPLICATES needed)
list(TRANSFORM needed PREPEND -l)
list(JOIN needed " " needed)
if(BUILD_SHARED_LIBS)
  set(libs_private "Libs.private: ${needed}\n")
else()
  set(libs_needed " ${needed}")
endif()
set(pc_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH to_prefix ${CMAKE_INSTALL_PREFIX}/${pc_folder} ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" to_prefix ${to_prefix})
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/fccda.pc @ONLY CONTENT [=[
prefix=${pcfiledir}/@to_prefix@
libdir=${prefix}/@CMAKE_INSTALL_LIBDIR@
includedir=${prefix}/@include_folder@
fortran_module=${prefix}/@fortran_folder@/fccda.f90

Name: fccda
Description: @PROJECT_DESCRIPTION@
Version: @PROJECT_VERSION@
Cflags: -I${includedir}
Libs: -L${libdir} -lfccda@libs_needed@
@libs_private@]=])
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/fccda.pc DESTINATION ${pc_folder} COMPONENT fccda)
