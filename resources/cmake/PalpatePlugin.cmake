# SPDX-License-Identifier: BSD-3-Clause
# The one way to declare a device plugin, in this tree and against the installed package.

# palpate_device_plugin(NAME SOURCES ... [LIBRARIES ...]) makes the loadable module NAME.so; one of the sources has
# Q_PLUGIN_METADATA with the file plugin.json beside it. See resources/docs/device-plugin.md.
function(palpate_device_plugin name)
  cmake_parse_arguments(P "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_library(palpate_plugin_${name} MODULE ${P_SOURCES})
  set_target_properties(palpate_plugin_${name} PROPERTIES AUTOMOC ON PREFIX "" OUTPUT_NAME ${name}
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  # What is not resolved here would only be missed when the plugin is loaded.
  target_link_options(palpate_plugin_${name} PRIVATE -Wl,--no-undefined)
  target_link_libraries(palpate_plugin_${name} PRIVATE palpate::device ${P_LIBRARIES})
endfunction()
