# SPDX-License-Identifier: BSD-3-Clause
# Run at build time: writes OUT from IN if the commit has changed. Recordings store this build id. Where the sources are no
# checkout of git, the environment variable PALPATE_COMMIT names the commit.
set(commit "unknown")
if(NOT "$ENV{PALPATE_COMMIT}" STREQUAL "")
  set(commit $ENV{PALPATE_COMMIT})
endif()
find_package(Git QUIET)
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE_DIR} describe --always --dirty --abbrev=12
    OUTPUT_VARIABLE described RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed)
    set(commit ${described})
  endif()
endif()
set(PALPATE_BUILD_ID "${commit} ${COMPILER}")
configure_file(${IN} ${OUT} @ONLY)
