# SPDX-License-Identifier: BSD-3-Clause
# What is installed, with the install components `runtime` (programs, shared libraries, plugins, data), `dev` (what
# another program is built with), `doc` and `python` (modules/python).
set(palpate_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Palpate)

# palpate_install_module(NAME): libraries, headers and palpate-NAME.pc of a module; called by palpate_module, whose M_...
# tell what the module needs.
function(palpate_install_module name)
  set(needs ${M_LIBRARIES})
  if(BUILD_SHARED_LIBS)
    set(targets palpate_${name}_headers palpate_${name}_component)
    set_target_properties(palpate_${name}_headers PROPERTIES EXPORT_NAME ${name}_headers)
    set_target_properties(palpate_${name}_component PROPERTIES EXPORT_NAME ${name})
    set(library ${M_LIBRARY})
    set(file palpate-${M_LIBRARY})
  else()
    set(targets palpate_${name})
    set_target_properties(palpate_${name} PROPERTIES EXPORT_NAME ${name})
    list(APPEND needs ${M_PRIVATE_LIBRARIES}) # a static library's user links them
    set(library)
    set(file palpate_${name})
  endif()
  install(TARGETS ${targets} EXPORT Palpate_${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
  install(EXPORT Palpate_${name} NAMESPACE palpate:: DESTINATION ${palpate_package_dir} COMPONENT dev)
  set(generated)
  if(EXISTS ${CMAKE_CURRENT_BINARY_DIR}/include)
    set(generated ${CMAKE_CURRENT_BINARY_DIR}/include/)
  endif()
  install(DIRECTORY include/ ${generated} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev PATTERN internal EXCLUDE)
  palpate_write_pc(${name} "${file}" "${M_USES}" "${needs}")

  list(JOIN M_USES " " used)
  set(config "set(palpate_uses_${name} ${used})\nset(palpate_library_${name} ${library})\n")
  foreach(package Qt6 VTK SQLite)
    set(parts ${needs})
    list(FILTER parts INCLUDE REGEX "^${package}::")
    list(TRANSFORM parts REPLACE ".*::" "")
    list(JOIN parts " " parts)
    string(APPEND config "set(palpate_${package}_${name} ${parts})\n")
  endforeach()
  set_property(GLOBAL APPEND_STRING PROPERTY PALPATE_COMPONENT_RULES "${config}")
endfunction()

# palpate_follow_vtk(OUTPUT TARGET ...) sets OUTPUT to these targets of VTK and to those that are linked with them. What a
# library of VTK inherits from or calls inline belongs to another one, which CMake adds, and pkg-config cannot.
function(palpate_follow_vtk output)
  set(all)
  set(open ${ARGN})
  while(open)
    list(POP_FRONT open target)
    if(NOT target IN_LIST all)
      list(APPEND all ${target})
      get_target_property(linked ${target} INTERFACE_LINK_LIBRARIES)
      string(REGEX MATCHALL "VTK::[A-Za-z0-9]+" linked "${linked}")
      list(APPEND open ${linked})
    endif()
  endwhile()
  set(${output} ${all} PARENT_SCOPE)
endfunction()

# palpate_write_pc(NAME FILE USES NEEDS) writes and installs palpate-NAME.pc: the library FILE, after the modules USES and
# with the imported targets NEEDS.
function(palpate_write_pc name file uses needs)
  list(TRANSFORM uses PREPEND palpate- OUTPUT_VARIABLE requires)
  set(libs "-l${file}")
  set(flags)
  set(vtk)
  foreach(need IN LISTS needs)
    if(need STREQUAL "Eigen3::Eigen")
      list(APPEND requires "eigen3 >= 3.4")
    elseif(need STREQUAL "Threads::Threads")
      string(APPEND libs " -pthread")
    elseif(need STREQUAL "SQLite::SQLite3")
      list(APPEND requires "sqlite3 >= 3.40")
    elseif(need STREQUAL "VTK::zlib")
      list(APPEND requires zlib)
    elseif(need MATCHES "^Qt6::(.+)")
      list(APPEND requires "Qt6${CMAKE_MATCH_1} >= 6.4")
    elseif(need MATCHES "^VTK::")
      list(APPEND vtk ${need})
    else()
      message(FATAL_ERROR "palpate-${name}.pc: found the library ${need}, expected one that palpate_write_pc knows")
    endif()
  endforeach()
  palpate_follow_vtk(vtk ${vtk})
  foreach(target IN LISTS vtk) # VTK has no .pc files
    get_target_property(type ${target} TYPE)
    if(NOT type STREQUAL "INTERFACE_LIBRARY")
      get_target_property(location ${target} LOCATION)
      string(REGEX REPLACE ".*/lib(.+)\\.(so|a)[.0-9]*$" "\\1" library "${location}")
      string(APPEND libs " -l${library}")
    endif()
  endforeach()
  if(vtk)
    get_target_property(folders VTK::CommonCore INTERFACE_INCLUDE_DIRECTORIES)
    list(JOIN folders " -I" folders)
    set(flags " -I${folders}")
  endif()
  list(JOIN requires ", " requires)
  file(RELATIVE_PATH up "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" /prefix)
  string(REGEX REPLACE "/$" "" up "${up}")
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/palpate-${name}.pc "prefix=\${pcfiledir}/${up}
libdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}
includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}

Name: palpate-${name}
Description: Component ${name} of Palpate, an engine that lets a hand feel surfaces
Version: ${PROJECT_VERSION}
Requires: ${requires}
Libs: -L\${libdir} ${libs}
Cflags: -I\${includedir}${flags}
")
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/palpate-${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
endfunction()

# palpate_install_package(): what find_package(Palpate) reads, and the documents.
function(palpate_install_package)
  include(CMakePackageConfigHelpers)
  get_property(palpate_component_rules GLOBAL PROPERTY PALPATE_COMPONENT_RULES)
  list(JOIN palpate_modules " " palpate_components)
  configure_package_config_file(resources/cmake/PalpateConfig.cmake.in PalpateConfig.cmake
    INSTALL_DESTINATION ${palpate_package_dir})
  configure_file(resources/cmake/PalpateConfigVersion.cmake.in PalpateConfigVersion.cmake @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/PalpateConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/PalpateConfigVersion.cmake
    resources/cmake/PalpatePlugin.cmake DESTINATION ${palpate_package_dir} COMPONENT dev)
  install(DIRECTORY resources/cohort resources/docs resources/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/palpate COMPONENT doc)
  install(FILES LICENSE CHANGELOG.md README.md DESTINATION ${CMAKE_INSTALL_DATADIR}/palpate COMPONENT doc)
endfunction()
