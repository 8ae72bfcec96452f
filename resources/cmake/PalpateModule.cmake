# SPDX-License-Identifier: BSD-3-Clause
# Flags that every target shares, and the one way to declare a module.

add_library(palpate_flags INTERFACE)
# No contraction: a replay gives back the same bits on one build (resources/docs/god-object.md).
target_compile_options(palpate_flags INTERFACE -ffp-contract=off -fno-math-errno -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  -Woverloaded-virtual $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi> $<$<BOOL:${PALPATE_WARNINGS_AS_ERRORS}>:-Werror>)
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # A source is then an included file, in which GCC takes a class with a member from an unnamed namespace for a header's.
  target_compile_options(palpate_flags INTERFACE -Wno-subobject-linkage)
  # GCC collects its garbage first at 512 MiB instead of 128: so long a source takes a twentieth less time.
  cmake_host_system_information(RESULT palpate_memory_MiB QUERY TOTAL_PHYSICAL_MEMORY)
  if(palpate_memory_MiB GREATER 7000) # two compilers at once, and a desktop
    target_compile_options(palpate_flags INTERFACE --param=ggc-min-heapsize=524288)
  endif()
endif()

# For what no servo tick waits for: at -O3 half of the time to compile is the optimiser's. Saved where the whole tree is built.
add_library(palpate_o1_flags INTERFACE)
if(CMAKE_UNITY_BUILD AND CMAKE_BUILD_TYPE STREQUAL "Release")
  target_compile_options(palpate_o1_flags INTERFACE -O1)
endif()

if(NOT PALPATE_SANITIZER STREQUAL "none")
  target_compile_options(palpate_flags INTERFACE -fsanitize=${PALPATE_SANITIZER} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(palpate_flags INTERFACE -fsanitize=${PALPATE_SANITIZER})
endif()

if(PALPATE_BUILD_FUZZERS)
  target_compile_options(palpate_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

if(TARGET Qt6::moc)
  get_target_property(palpate_qt_moc Qt6::moc LOCATION)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/moc.sh.in ${PROJECT_BINARY_DIR}/moc.sh @ONLY FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endif()

# palpate_moc(TARGET) lets moc run over the target's sources.
function(palpate_moc target)
  set_target_properties(${target} PROPERTIES AUTOMOC ON AUTOMOC_EXECUTABLE ${PROJECT_BINARY_DIR}/moc.sh)
endfunction()

# palpate_module(NAME [LIBRARY engine|vtk|qt] SOURCES ... [TIMED ...] [USES module ...] [LIBRARIES public ...]
#                [PRIVATE_LIBRARIES ...] [QT] [O1])
# makes palpate::NAME. With LIBRARY the module is a component NAME of find_package(Palpate), and where BUILD_SHARED_LIBS is
# on, part of the shared library libpalpate-LIBRARY; it is a static library otherwise. A module comes after those that it
# uses. QT: moc runs over its sources. O1: no servo tick waits for it (palpate_o1_flags), but for the TIMED sources, whose
# speed counts; TIMED is for modules without LIBRARY.
function(palpate_module name)
  cmake_parse_arguments(M "QT;O1" "LIBRARY" "SOURCES;TIMED;USES;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  set(timed ${M_TIMED})
  if(M_TIMED AND CMAKE_UNITY_BUILD)
    set(timed $<TARGET_OBJECTS:palpate_${name}_timed>)
  endif()
  list(TRANSFORM M_USES PREPEND palpate:: OUTPUT_VARIABLE uses)

  set(main palpate_${name}) # what others link
  set(kind PUBLIC)
  if(BUILD_SHARED_LIBS AND M_LIBRARY)
    # The sources are compiled as an object library, which sees the headers of the modules that it uses: were it to link
    # their shared library, which may be its own, the two would wait for each other.
    set(main palpate_${name}_component)
    set(kind INTERFACE)
    list(TRANSFORM M_USES REPLACE "(.+)" "palpate_\\1_headers" OUTPUT_VARIABLE used_headers)
    add_library(palpate_${name} OBJECT ${M_SOURCES})
    target_compile_options(palpate_${name} PRIVATE -fno-semantic-interposition) # inlines as a static library's sources do
    add_library(palpate_${name}_headers INTERFACE)
    target_link_libraries(palpate_${name}_headers INTERFACE ${used_headers} ${M_LIBRARIES})
    target_link_libraries(palpate_${name} PRIVATE palpate_${name}_headers ${M_PRIVATE_LIBRARIES})
    add_library(${main} INTERFACE)
    target_link_libraries(${main} INTERFACE palpate_${name}_headers palpate_${M_LIBRARY}_library ${uses})
    set(headers palpate_${name}_headers)
    palpate_add_to_library(${M_LIBRARY} ${name} ${M_LIBRARIES} ${M_PRIVATE_LIBRARIES})
  else()
    add_library(palpate_${name} STATIC ${M_SOURCES} ${timed})
    target_link_libraries(palpate_${name} PUBLIC ${uses} ${M_LIBRARIES} PRIVATE ${M_PRIVATE_LIBRARIES})
    set(headers palpate_${name})
  endif()
  add_library(palpate::${name} ALIAS ${main})
  target_include_directories(${headers} ${kind}
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  if(EXISTS ${CMAKE_CURRENT_BINARY_DIR}/include) # of configure_file
    target_include_directories(${headers} ${kind} $<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}/include>)
  endif()
  target_compile_features(${headers} ${kind} cxx_std_20)
  target_include_directories(palpate_${name} PRIVATE src)
  palpate_apply_flags(palpate_${name} palpate_flags)
  if(M_LIBRARY)
    set_target_properties(palpate_${name} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  endif()
  if(M_TIMED AND CMAKE_UNITY_BUILD)
    add_library(palpate_${name}_timed OBJECT ${M_TIMED})
    target_include_directories(palpate_${name}_timed PRIVATE include src)
    target_link_libraries(palpate_${name}_timed PRIVATE ${uses} ${M_LIBRARIES} ${M_PRIVATE_LIBRARIES} palpate_flags)
  endif()
  if(M_O1)
    palpate_apply_flags(palpate_${name} palpate_o1_flags)
  endif()
  if(M_QT)
    palpate_moc(palpate_${name})
  endif()
  if(M_LIBRARY AND PALPATE_INSTALL)
    palpate_install_module(${name})
  endif()
endfunction()

# palpate_apply_flags(TARGET FLAGS) compiles TARGET with the options of FLAGS, which installed targets do not name.
function(palpate_apply_flags target flags)
  target_compile_options(${target} PRIVATE $<TARGET_PROPERTY:${flags},INTERFACE_COMPILE_OPTIONS>)
endfunction()

# palpate_add_to_library(LIBRARY MODULE [library ...]) puts the objects of MODULE, which need these other libraries, into
# libpalpate-LIBRARY.
function(palpate_add_to_library library module)
  set(target palpate_${library}_library)
  if(NOT TARGET ${target})
    add_library(${target} SHARED)
    # While the first number is 0, the second counts incompatible changes.
    set(compatible ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    set_target_properties(${target} PROPERTIES OUTPUT_NAME palpate-${library} EXPORT_NAME ${library}_library
      VERSION ${PROJECT_VERSION} SOVERSION ${compatible} LINKER_LANGUAGE CXX
      INSTALL_RPATH_USE_LINK_PATH ON) # finds VTK and Qt where they are not in the system's folders
    # Symbols carry the version, so that two versions in one process stay apart, and calls within the library are direct.
    # Hidden besides what visibility hides: functions with target_clones, which GCC 12 exports, instances of templates
    # for internal types, and those of the standard library.
    file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${target}.map
      "PALPATE_${compatible} { global: *; local: extern \"C++\" { *palpate::haptics::internal*; std::*; }; };\n")
    target_link_options(${target} PRIVATE -Wl,--version-script=${CMAKE_CURRENT_BINARY_DIR}/${target}.map
      -Wl,--no-undefined -Wl,-Bsymbolic-functions
      $<TARGET_PROPERTY:palpate_flags,INTERFACE_LINK_OPTIONS>)
    # Each library uses those before it.
    foreach(before engine vtk)
      if(TARGET palpate_${before}_library AND NOT before STREQUAL library)
        target_link_libraries(${target} PRIVATE palpate_${before}_library)
      endif()
    endforeach()
    if(PALPATE_INSTALL)
      install(TARGETS ${target} EXPORT Palpate_${library}_library
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT dev)
      install(EXPORT Palpate_${library}_library NAMESPACE palpate:: COMPONENT dev
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Palpate)
    endif()
  endif()
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:palpate_${module}>)
  # Libraries of VTK as files: the package would name targets, and a program that links the library would have to find all
  # that VTK needs for these as well.
  set(vtk ${ARGN})
  list(FILTER vtk INCLUDE REGEX "^VTK::")
  palpate_follow_vtk(vtk ${vtk})
  set(linked ${ARGN})
  foreach(part IN LISTS vtk)
    get_target_property(type ${part} TYPE)
    if(NOT type STREQUAL "INTERFACE_LIBRARY")
      list(REMOVE_ITEM linked ${part})
      list(APPEND linked $<TARGET_LINKER_FILE:${part}>)
    endif()
  endforeach()
  target_link_libraries(${target} PRIVATE ${linked})
endfunction()
