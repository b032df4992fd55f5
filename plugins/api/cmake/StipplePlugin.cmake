# stipple_add_plugin(name SOURCES a.cpp... [LIBRARIES lib...]): a plugin for Stipple, in its own tree and after
# find_package(Stipple). It lands in ${STIPPLE_PLUGIN_DIR} below the build folder of the project, where programs built in
# the tree of Stipple look and others can be told to (STIPPLE_PLUGIN_PATH), and is installed into ${STIPPLE_PLUGIN_DIR}.
function(stipple_add_plugin name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  set(target stipple_plugin_${name})
  add_library(${target} MODULE ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE Stipple::plugin_api ${ARG_LIBRARIES})
  target_compile_features(${target} PRIVATE cxx_std_20)
  set_target_properties(${target} PROPERTIES
    PREFIX "" OUTPUT_NAME ${name} CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${STIPPLE_PLUGIN_DIR} INSTALL_RPATH "$ORIGIN/../..")
  if(TARGET stipple_build_hash)
    add_dependencies(${target} stipple_build_hash)
    target_link_libraries(${target} PRIVATE stipple_warnings)
  endif()
  install(TARGETS ${target} LIBRARY DESTINATION ${STIPPLE_PLUGIN_DIR})
endfunction()
