# What `cmake --install` puts where, beside fccda (install_fccda.cmake) and the Python package (python/CMakeLists.txt), and the Debian packages that CPack makes of it:
#
#   bin/perimpact
#   lib/perimpact/libperimpact_ranks.so             opened in runs of several processes; where MPI was found
#   lib/perimpact/libperimpact_cuda.so              opened by --device cuda; where nvcc was found
#   share/perimpact/cases/                          to look at, copy and run
#   share/perimpact/scripts/results/                modules that scripts of the cases import
#   share/perimpact/docs/guide/deck.schema.json     where the first line of each case's deck says
#   share/perimpact/docs/guide/tutorials/           their decks
#   share/doc/perimpact/html/index.html             where scripts/build_docs.sh has been run before
#   share/man/man1/perimpact.1.gz
#   share/bash-completion/completions/perimpact, share/zsh/vendor-completions/_perimpact, share/fish/vendor_completions.d/perimpact.fish
include(GNUInstallDirs)

set(shared ${CMAKE_INSTALL_DATADIR}/perimpact)
install(TARGETS perimpact COMPONENT perimpact)
if(TARGET ranks_library)
  install(TARGETS ranks_library LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/perimpact COMPONENT mpi)
endif()
if(TARGET gpu_library)
  install(FILES ${CMAKE_BINARY_DIR}/libperimpact_cuda.so DESTINATION ${CMAKE_INSTALL_LIBDIR}/perimpact COMPONENT cuda)
endif()
install(DIRECTORY cases/ DESTINATION ${shared}/cases COMPONENT perimpact USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
install(DIRECTORY scripts/results/ DESTINATION ${shared}/scripts/results COMPONENT perimpact USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
install(FILES docs/guide/deck.schema.json DESTINATION ${shared}/docs/guide COMPONENT perimpact)
install(DIRECTORY docs/guide/tutorials/ DESTINATION ${shared}/docs/guide/tutorials COMPONENT perimpact FILES_MATCHING PATTERN "*.yaml")
set(documentation ${CMAKE_CURRENT_SOURCE_DIR}/build/docs)
install(DIRECTORY ${documentation}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/perimpact/html COMPONENT doc OPTIONAL
  PATTERN .buildinfo EXCLUDE PATTERN objects.inv EXCLUDE)

set(written ${CMAKE_CURRENT_BINARY_DIR}/share)  # by the program (src/cli/CMakeLists.txt)
install(FILES ${written}/perimpact.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT perimpact)
install(FILES ${written}/perimpact.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME perimpact COMPONENT perimpact)
install(FILES ${written}/perimpact.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions RENAME _perimpact COMPONENT perimpact)
install(FILES ${written}/perimpact.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT perimpact)

# Debian wants the changelog packed, without the time of packing in it.
find_program(GZIP gzip REQUIRED)
set(packed ${CMAKE_CURRENT_BINARY_DIR}/packed)
file(MAKE_DIRECTORY ${packed})
foreach(file packaging/changelog CHANGELOG.md)
  get_filename_component(name ${file} NAME)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  execute_process(COMMAND ${GZIP} -9nc ${CMAKE_CURRENT_SOURCE_DIR}/${file} OUTPUT_FILE ${packed}/${name}.gz COMMAND_ERROR_IS_FATAL ANY)
endforeach()
set(components perimpact fccda)
if(PERIMPACT_PYTHON)
  list(APPEND components python)
endif()
if(TARGET ranks_library)
  list(APPEND components mpi)
endif()
if(EXISTS ${documentation}/index.html)
  list(APPEND components doc)
endif()
foreach(component ${components})
  set(package ${component})
  string(REGEX REPLACE "^(mpi|doc)$" "perimpact-\\1" package ${package})
  string(REGEX REPLACE "^fccda$" libfccda-dev package ${package})
  string(REGEX REPLACE "^python$" python3-perimpact package ${package})
  install(FILES packaging/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
  install(FILES ${packed}/CHANGELOG.md.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME changelog.gz COMPONENT ${component})
  install(FILES ${packed}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME changelog.Debian.gz COMPONENT ${component})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME perimpact)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "peridynamic impact and ice-structure interaction, with a contact library")
set(CPACK_PACKAGE_VENDOR "the perimpact authors")
set(CPACK_PACKAGE_CONTACT "The perimpact authors <perimpact@localhost>")  # as in packaging/changelog; distributors give an address
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # what the program links, by dpkg-shlibdeps
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PERIMPACT_PACKAGE_NAME perimpact)
set(CPACK_DEBIAN_PERIMPACT_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PERIMPACT_PACKAGE_RECOMMENDS "python3, python3-numpy, python3-matplotlib")  # figures of the cases
set(CPACK_DEBIAN_PERIMPACT_PACKAGE_SUGGESTS "perimpact-doc, paraview, gmsh, libfccda-dev, perimpact-mpi, python3-perimpact")
set(CPACK_COMPONENT_PERIMPACT_DESCRIPTION "Impact of peridynamic bodies, ice first, with rigid bodies of any shape given
as surface meshes. Bonds between particles break. Contact is detected along the
whole path of every particle.
.
The program needs a processor with AVX2 (x86-64-v3).")
set(CPACK_DEBIAN_MPI_PACKAGE_NAME perimpact-mpi)
set(CPACK_DEBIAN_MPI_PACKAGE_SECTION science)
set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "perimpact (= ${PROJECT_VERSION}-1), openmpi-bin")
set(CPACK_COMPONENT_MPI_DESCRIPTION "Runs of perimpact as several processes, on one machine or many: mpirun perimpact run.
The program opens the library of this package, which uses Open MPI.
.
The library needs a processor with AVX2 (x86-64-v3).")
set(CPACK_DEBIAN_DOC_PACKAGE_NAME perimpact-doc)
set(CPACK_DEBIAN_DOC_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOC_PACKAGE_SHLIBDEPS OFF)  # which examines each of some thousand pages
set(CPACK_COMPONENT_DOC_DESCRIPTION "Documentation of perimpact as static pages that need no network: guide, theory,
cases, contact library and C++ reference.")
set(CPACK_DEBIAN_FCCDA_PACKAGE_NAME libfccda-dev)
set(CPACK_DEBIAN_FCCDA_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_FCCDA_PACKAGE_DEPENDS "zlib1g-dev, libc6-dev")
set(CPACK_COMPONENT_FCCDA_DESCRIPTION "fccda, the contact library of perimpact, for particle and finite-element codes:
points, each with a position at both ends of a time step, against moving rigid
surfaces of panels. Static library, headers for C++ and C, a module for Fortran,
CMake package and pkg-config file.
.
The library needs a processor with AVX2 (x86-64-v3).")
if(PERIMPACT_PYTHON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-perimpact)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${PERIMPACT_PYTHON_ABI}, python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib")  # figures of the examples
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "perimpact")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_SOURCE_DIR}/packaging/python3-perimpact/postinst;${CMAKE_CURRENT_SOURCE_DIR}/packaging/python3-perimpact/prerm")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Python package perimpact: simulations from decks or dicts, with particles and
impactors as NumPy arrays, user forces, and the contact library fccda alone.
.
The package needs a processor with AVX2 (x86-64-v3).")
endif()
include(CPack)
