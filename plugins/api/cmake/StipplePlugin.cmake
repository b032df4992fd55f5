# stipple_add_plugin(name SOURCES a.cpp... [LIBRARIES lib...]): a plugin for Stipple, in its own tree and after
# find_package(Stipple). In the tree of Stipple it lands where the built programs look; elsewhere it lands in the build
# folder of the caller and is installed into ${STIPPLE_PLUGIN_DIR}.
function(stipple_add_plugin name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  set(target stipple_plugin_${name})
  add_library(${target} MODULE ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE Stipple::plugin_api ${ARG_LIBRARIES})
  target_compile_features(${target} PRIVATE cxx_std_20)
  set_target_properties(${target} PROPERTIES
    PREFIX "" OUTPUT_NAME ${name} CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if(TARGET stipple_build_hash)
    add_dependencies(${target} stipple_build_hash)
    target_link_libraries(${target} PRIVATE stipple_warnings)
    set_target_properties(${target} PROPERTIES
      LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${STIPPLE_PLUGIN_DIR} INSTALL_RPATH "$ORIGIN/../..")
  endif()
  install(TARGETS ${target} LIBRARY DESTINATION ${STIPPLE_PLUGIN_DIR})
endfunction()
