# SPDX-License-Identifier: BSD-3-Clause
# Debian packages, made by CPack from a build with the prefix /usr (preset `packages`, .ci/run packages):
#   palpate          install components `runtime` and `doc`
#   libpalpate-dev   install component `dev`
#   python3-palpate  install component `python`, where one is built
set(PALPATE_MAINTAINER "The Palpate authors <palpate@example.org>" CACHE STRING "Maintainer of the Debian packages: name and address of whoever builds them")

# palpate_add_packages(): called after all install().
function(palpate_add_packages)
  get_cmake_property(all COMPONENTS)
  set(disclaimer "For research, training and planning rehearsal. Not a medical device.")
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_NAME palpate)
  set(CPACK_PACKAGE_VENDOR "The Palpate authors")
  set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_STRIP_FILES ON)
  set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${PALPATE_MAINTAINER}")
  set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
  set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
  set(CPACK_COMPONENTS_ALL runtime doc dev)

  # Names of groups are upper case in the names of variables. The first line of a description is the summary.
  set(CPACK_COMPONENT_RUNTIME_GROUP program)
  set(CPACK_COMPONENT_DOC_GROUP program)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME palpate)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libgl1-mesa-dri")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "xvfb, xauth")
  set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "feel segmented anatomy before an operation
Palpate lets a clinician feel segmented anatomy before an operation: which
lump a hand will find, where, and how hard it has to press. It opens surface
meshes and label maps, shows them in three dimensions and computes the force
on a hand at 1 kHz, for haptic devices and for the mouse. Sessions are
recorded, replayed, measured and reported.

${disclaimer}

This package has the program, plugins for devices with rules of udev, a
phantom and the documents.")

  set(CPACK_COMPONENT_DEV_GROUP development)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libpalpate-dev)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SOURCE palpate)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), libsqlite3-dev (>= 3.40), qt6-base-dev (>= 6.4)")
  # The components of the engine need no VTK.
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "libvtk9-dev (>= 9.1)")
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "libqt6opengl6-dev, libgl-dev, qt6-multimedia-dev, cmake, pkgconf")
  set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "engine that lets a hand feel surfaces - development files
The engine of Palpate lets a hand feel surfaces: a god-object on a spatially
indexed mesh, tissue, a servo loop at 1 kHz, device drivers and recordings.

${disclaimer}

This package has the headers and static libraries of the engine, which needs
neither VTK nor a window, and of the components that read meshes and draw
(libvtk9-dev), with files for CMake and pkg-config.")

  if("python" IN_LIST all)
    # A module for one version of Python, that of the system's `python3`.
    set(Python3_EXECUTABLE /usr/bin/python3)
    find_package(Python3 REQUIRED COMPONENTS Interpreter)
    math(EXPR next "${Python3_VERSION_MINOR} + 1")
    list(APPEND CPACK_COMPONENTS_ALL python)
    set(CPACK_COMPONENT_PYTHON_GROUP bindings)
    set(CPACK_DEBIAN_BINDINGS_PACKAGE_NAME python3-palpate)
    set(CPACK_DEBIAN_BINDINGS_PACKAGE_SOURCE palpate)
    set(CPACK_DEBIAN_BINDINGS_PACKAGE_SECTION python)
    set(CPACK_DEBIAN_BINDINGS_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_BINDINGS_PACKAGE_DEPENDS
      "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), python3 (<< ${Python3_VERSION_MAJOR}.${next}), python3-numpy")
    set(CPACK_DEBIAN_BINDINGS_DESCRIPTION "engine that lets a hand feel surfaces - Python module
The engine of Palpate lets a hand feel surfaces: a god-object on a spatially
indexed mesh, tissue, and recordings.

${disclaimer}

This package has the module for Python 3.")
    palpate_install_package_documents(python3-palpate python)
  endif()
  palpate_install_package_documents(palpate runtime)
  palpate_install_package_documents(libpalpate-dev dev)
  include(CPack)
endfunction()

# palpate_install_package_documents(PACKAGE COMPONENT) installs the copyright and the changelog that a Debian package must
# have. The changelog is a pointer to the one that all packages share.
function(palpate_install_package_documents package component)
  find_program(PALPATE_GZIP gzip REQUIRED)
  string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
  set(folder ${PROJECT_BINARY_DIR}/package-documents/${package})
  file(WRITE ${folder}/changelog "palpate (${PROJECT_VERSION}) unstable; urgency=medium

  * Release ${PROJECT_VERSION}. The package palpate lists the changes in
    /usr/share/palpate/CHANGELOG.md.

 -- ${PALPATE_MAINTAINER}  ${now}
")
  execute_process(COMMAND ${PALPATE_GZIP} -9nf ${folder}/changelog COMMAND_ERROR_IS_FATAL ANY)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME copyright COMPONENT ${component})
  install(FILES ${folder}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endfunction()
