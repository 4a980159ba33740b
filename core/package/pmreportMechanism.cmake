# How plugins are compiled, for one level, or for every processor when none is named.
function(pmreport_mechanism_options target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LEVEL" "")
  target_compile_features(${target} PRIVATE cxx_std_20)
  # No errno and no floating-point traps: square roots and selections then stay single instructions. The geometry is small loops over small
  # matrices, which -O3 unrolls: partials take 0.4 of the time that they take with -O2.
  target_compile_options(${target} PRIVATE -fno-math-errno -fno-trapping-math -ffp-contract=off $<$<NOT:$<CONFIG:Debug>>:-O3>)
  if(arg_LEVEL)
    # GCC 12 takes registers that its own AVX-512 intrinsics leave undefined on purpose for mistakes; the plain build has the warning.
    target_compile_options(${target} PRIVATE -march=${arg_LEVEL} -Wno-uninitialized $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON POSITION_INDEPENDENT_CODE ON)
endfunction()

# pmreport_add_mechanism(NAME SOURCE... [LEVELS LEVEL...]): a plugin library NAME.so that exports one symbol, pm_plugin, and shares nothing else
# with its host. It runs on every processor. For each level of the x86-64 psABI that is named, x86-64-v3 or x86-64-v4, a build with the wider
# vectors of such processors, NAME-LEVEL, is made in a folder of that name beside it, where the host looks for it.
function(pmreport_add_mechanism name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LEVELS")
  set(exports ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/plugin.map)
  foreach(level "" ${arg_LEVELS})
    string(JOIN "-" target ${name} ${level})
    add_library(${target} MODULE ${arg_UNPARSED_ARGUMENTS})
    target_link_libraries(${target} PRIVATE $<IF:$<TARGET_EXISTS:pmreport::sdk>,pmreport::sdk,pmreport_sdk>)
    pmreport_mechanism_options(${target} LEVEL ${level})
    set_target_properties(${target} PROPERTIES PREFIX "" SUFFIX ".so" OUTPUT_NAME ${name})
    target_link_options(${target} PRIVATE LINKER:--version-script=${exports})
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${exports})
  endforeach()
endfunction()
