# pmreport_add_mechanism(NAME SOURCE...): a plugin library NAME.so that exports one symbol, pm_plugin, and shares nothing else with its host.
function(pmreport_add_mechanism name)
  set(exports ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/plugin.map)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE $<IF:$<TARGET_EXISTS:pmreport::sdk>,pmreport::sdk,pmreport_sdk>)
  target_compile_features(${name} PRIVATE cxx_std_20)
  # No errno and no floating-point traps: square roots and selections then stay single instructions. The geometry is small loops over small
  # matrices, which -O3 unrolls: partials take 0.4 of the time that they take with -O2.
  target_compile_options(${name} PRIVATE -fno-math-errno -fno-trapping-math -ffp-contract=off $<$<NOT:$<CONFIG:Debug>>:-O3>)
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX ".so" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_link_options(${name} PRIVATE LINKER:--version-script=${exports})
  set_property(TARGET ${name} APPEND PROPERTY LINK_DEPENDS ${exports})
endfunction()
