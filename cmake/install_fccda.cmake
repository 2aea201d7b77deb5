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

file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/fccdaConfig.cmake @ONLY CONTENT [=[
include(CMakeFindDependencyMacro)
find_dependency(OpenMP COMPONENTS CXX)
find_dependency(ZLIB)
include(${CMAKE_CURRENT_LIST_DIR}/fccdaTargets.cmake)
]=])
# before 1.0 a new minor version may change what callers see
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/fccdaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/fccdaConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/fccdaConfigVersion.cmake DESTINATION ${package_folder} COMPONENT fccda)
install(FILES ${CMAKE_CURRENT_SOURCE_DIR}/../../LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT fccda)
