# What `cmake --install` puts in place besides the program and the plugins, which their own folders install: the SDK, as the CMake package
# `pmreport` with the target pmreport::sdk and the function pmreport_add_mechanism.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/pmreport)

set_target_properties(pmreport_sdk PROPERTIES EXPORT_NAME sdk)
# In the build tree the SDK stands in core/pmreport, installed in include/pmreport.
set_property(TARGET pmreport_sdk PROPERTY INTERFACE_INCLUDE_DIRECTORIES $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/core>
                                          $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
install(TARGETS pmreport_sdk EXPORT pmreportTargets COMPONENT sdk)
install(EXPORT pmreportTargets NAMESPACE pmreport:: DESTINATION ${package_folder} COMPONENT sdk)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/pmreport DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT sdk
        FILES_MATCHING PATTERN *.h PATTERN *.hpp)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/pmreportConfig.cmake.in ${PROJECT_BINARY_DIR}/package/pmreportConfig.cmake
                              INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# A plugin fits the program of the same major version: the ABI changes with it. Headers do not depend on the machine.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/pmreportConfigVersion.cmake COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/package/pmreportConfig.cmake ${PROJECT_BINARY_DIR}/package/pmreportConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/pmreportMechanism.cmake ${CMAKE_CURRENT_LIST_DIR}/plugin.map
        DESTINATION ${package_folder} COMPONENT sdk)
