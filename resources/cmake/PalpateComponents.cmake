# SPDX-License-Identifier: BSD-3-Clause
# Builds parts of the engine alone, for programs that embed them: cmake -DPALPATE_COMPONENTS=haptics

# palpate_add_components(MODULE ...) adds these modules and those they use (modules/layers.txt), and finds what they need.
function(palpate_add_components)
  set(all core geometry haptics device servo session vtk buried meshio) # each after the modules it uses
  foreach(module IN LISTS ARGN)
    if(NOT module IN_LIST all)
      list(JOIN all ", " known)
      message(FATAL_ERROR "PALPATE_COMPONENTS: found \"${module}\", expected some of ${known}")
    endif()
  endforeach()
  file(STRINGS modules/layers.txt rules REGEX "^[a-z]+:")
  foreach(rule IN LISTS rules)
    string(REGEX MATCHALL "[a-z]+" names "${rule}")
    list(POP_FRONT names module)
    set(uses_${module} ${names})
  endforeach()

  set(wanted ${ARGN})
  list(REVERSE all)
  foreach(module IN LISTS all)
    if(module IN_LIST wanted)
      list(APPEND wanted ${uses_${module}})
    endif()
  endforeach()
  list(REVERSE all)

  if("device" IN_LIST wanted OR "meshio" IN_LIST wanted)
    find_package(Qt6 6.4 REQUIRED COMPONENTS Core)
  endif()
  if("session" IN_LIST wanted)
    find_package(SQLite3 3.40 REQUIRED)
  endif()
  if("vtk" IN_LIST wanted OR "meshio" IN_LIST wanted)
    find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel CommonExecutionModel CommonMisc CommonSystem
      CommonTransforms FiltersCore FiltersGeneral FiltersGeometry FiltersModeling IOCore IOGeometry IOImage IOLegacy IOPLY
      IOXML zlib)
  endif()
  foreach(module IN LISTS all)
    if(module IN_LIST wanted)
      add_subdirectory(modules/${module})
    endif()
  endforeach()
endfunction()
