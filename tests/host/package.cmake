# Installs the SDK to a fresh prefix, builds a mechanism outside the project against it, and has the project's loader ask that mechanism.
#   cmake -DBINARY=<build folder> -DSOURCE=<folder of the consumer> -DCHECKER=<program> -DCXX=<compiler> -DNM=<nm> -DMAKE=<ninja or make>
#         -DGENERATOR=<name> -DLIBDIR=<lib> -DFLAGS=<compiler flags> -P package.cmake
set(work ${BINARY}/package-test)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(status)
    message(FATAL_ERROR "${ARGN}\nended with ${status}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()
function(expect seen expected what)
  if(NOT seen STREQUAL expected)
    message(FATAL_ERROR "${what}: expected '${expected}', seen '${seen}'")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BINARY} --prefix ${work}/prefix --component sdk)
foreach(file include/pmreport/plugin.h include/pmreport/mechanism.hpp ${LIBDIR}/cmake/pmreport/pmreportConfig.cmake
             ${LIBDIR}/cmake/pmreport/pmreportConfigVersion.cmake ${LIBDIR}/cmake/pmreport/plugin.map)
  if(NOT EXISTS ${work}/prefix/${file})
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()

# The installed package must not lead back to the source or the build tree.
file(GLOB_RECURSE installed ${work}/prefix/*)
get_filename_component(project ${SOURCE}/../../.. ABSOLUTE)
foreach(file ${installed})
  file(READ ${file} text)
  if(text MATCHES "${project}/(core|tests)")
    message(FATAL_ERROR "${file} names the source tree")
  endif()
endforeach()

# The prefix may be moved.
file(RENAME ${work}/prefix ${work}/moved)
run(${CMAKE_COMMAND} -G "${GENERATOR}" -S ${SOURCE} -B ${work}/consumer -DCMAKE_PREFIX_PATH=${work}/moved -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_MAKE_PROGRAM=${MAKE} -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${work}/consumer)
run(${NM} -D --defined-only --format=just-symbols ${work}/consumer/my.so)
expect("${output}" "pm_plugin\n" "symbols of the plugin")
run(${CHECKER} ${work}/consumer/my.so lift 1)
string(REGEX MATCHALL "\n" samples "${output}")
list(LENGTH samples count)
expect(${count} 85 "samples")
file(REMOVE_RECURSE ${work})
