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
  configure_file(${CMAKE_CURRENT_LIST_DIR}/moc.sh.in ${CMAKE_BINARY_DIR}/moc.sh @ONLY FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endif()

# palpate_moc(TARGET) lets moc run over the target's sources.
function(palpate_moc target)
  set_target_properties(${target} PROPERTIES AUTOMOC ON AUTOMOC_EXECUTABLE ${CMAKE_BINARY_DIR}/moc.sh)
endfunction()

# palpate_module(NAME SOURCES ... [TIMED ...] [USES module ...] [LIBRARIES public ...] [PRIVATE_LIBRARIES ...] [ENGINE] [QT]
#                [O1])
# makes the static library palpate_NAME with the alias palpate::NAME. ENGINE modules are installed, each as a component NAME
# of find_package(Palpate); a module comes after those that it uses. O1: no servo tick waits for it (palpate_o1_flags), but
# for the TIMED sources, whose speed counts.
function(palpate_module name)
  cmake_parse_arguments(M "ENGINE;QT;O1" "" "SOURCES;TIMED;USES;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  set(timed ${M_TIMED})
  if(M_TIMED AND CMAKE_UNITY_BUILD)
    set(timed $<TARGET_OBJECTS:palpate_${name}_timed>)
  endif()
  add_library(palpate_${name} STATIC ${M_SOURCES} ${timed})
  add_library(palpate::${name} ALIAS palpate_${name})
  target_include_directories(palpate_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE src)
  target_compile_features(palpate_${name} PUBLIC cxx_std_20)
  list(TRANSFORM M_USES PREPEND palpate::)
  target_link_libraries(palpate_${name} PUBLIC ${M_USES} ${M_LIBRARIES}
    PRIVATE $<BUILD_INTERFACE:palpate_flags> ${M_PRIVATE_LIBRARIES})
  if(M_TIMED AND CMAKE_UNITY_BUILD)
    add_library(palpate_${name}_timed OBJECT ${M_TIMED})
    target_include_directories(palpate_${name}_timed PRIVATE include src)
    target_link_libraries(palpate_${name}_timed PRIVATE ${M_USES} ${M_LIBRARIES} ${M_PRIVATE_LIBRARIES} palpate_flags)
  endif()
  if(M_O1)
    target_link_libraries(palpate_${name} PRIVATE $<BUILD_INTERFACE:palpate_o1_flags>)
  endif()
  if(M_QT)
    palpate_moc(palpate_${name})
  endif()
  if(M_ENGINE)
    set_target_properties(palpate_${name} PROPERTIES EXPORT_NAME ${name})
    install(TARGETS palpate_${name} EXPORT Palpate_${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(EXPORT Palpate_${name} FILE Palpate_${name}.cmake NAMESPACE palpate::
      DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Palpate)
    install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} PATTERN internal EXCLUDE)
    set_property(GLOBAL APPEND PROPERTY PALPATE_COMPONENTS ${name})
    set_property(GLOBAL APPEND PROPERTY PALPATE_PUBLIC_HEADERS ${CMAKE_CURRENT_SOURCE_DIR}/include)
    string(REGEX MATCHALL "VTK::[A-Za-z0-9]+" vtk "${M_PRIVATE_LIBRARIES}")
    list(TRANSFORM vtk REPLACE "VTK::" "")
    set_property(GLOBAL APPEND PROPERTY PALPATE_VTK_COMPONENTS ${vtk})
    string(REPLACE "palpate::" "" uses "${M_USES}")
    set_property(GLOBAL APPEND_STRING PROPERTY PALPATE_COMPONENT_USES "set(palpate_uses_${name} ${uses})\n")
  endif()
endfunction()
