# What another project takes: the rooms of the safety kernel and their headers. The host layer is not for a device: it needs
# no foreign library, and shows an application on a bench. Tools and examples come along where they were built.
#
# Two components, `library` and `tool`: a Debian package each (cpack -G DEB). Headers and archives stand in folders named counterpoint, since
# the names of the rooms are too common for those of a system.
include(CMakePackageConfigHelpers)
set(COUNTERPOINT_INCLUDES ${CMAKE_INSTALL_INCLUDEDIR}/counterpoint)
set(COUNTERPOINT_ARCHIVES ${CMAKE_INSTALL_LIBDIR}/counterpoint)

set(COUNTERPOINT_INSTALLED_ROOMS safety_core_contract safety_core_comparator hal_api safety_core_kernel safety_core_selftest
    safety_core_crosslink channel_a channel_b hal_absent hal_contract_test canopen_cia301
    canopen_cia302_network canopen_cia302_safety_gate canopen_cia302_flying_master canopen_start_up_cia302
    canopen_start_up_el6751 canopen_start_up_plc_designer canopen_manager
    canopen_cia305 canopen_device canopen_generated version names)
set(COUNTERPOINT_INSTALLED_FOLDERS safety_core hal/api hal/absent hal/contract_test channel_a channel_b canopen/cia301 canopen/cia302 canopen/start_up canopen/manager
    canopen/cia305
    canopen/device canopen/generated version)
if(TARGET hal_host)
  list(APPEND COUNTERPOINT_INSTALLED_ROOMS hal_host)
  list(APPEND COUNTERPOINT_INSTALLED_FOLDERS hal/host)
endif()
if(COUNTERPOINT_HOST)
  install(CODE "set(CMAKE_INSTALL_DO_STRIP TRUE)" COMPONENT tool) # Of the program alone: CMake strips no archive.
  install(TARGETS counterpoint RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tool OPTIONAL)
  install(FILES ${COUNTERPOINT_SHELL_TEXTS}/counterpoint.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tool OPTIONAL)
  install(FILES ${COUNTERPOINT_SHELL_TEXTS}/bash RENAME counterpoint DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT tool OPTIONAL)
  install(FILES ${COUNTERPOINT_SHELL_TEXTS}/zsh RENAME _counterpoint DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT tool OPTIONAL)
  install(FILES ${COUNTERPOINT_SHELL_TEXTS}/fish RENAME counterpoint.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT tool OPTIONAL)
endif()
set(COUNTERPOINT_PACKAGE_OPTIONS "" CACHE STRING "Options of rooms of the package: a preset keeps the place of the build out of them")
set(COUNTERPOINT_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/Counterpoint)

foreach(room IN LISTS COUNTERPOINT_INSTALLED_ROOMS)
  get_target_property(type ${room} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    target_include_directories(${room} INTERFACE $<INSTALL_INTERFACE:${COUNTERPOINT_INCLUDES}>)
  else()
    target_include_directories(${room} PUBLIC $<INSTALL_INTERFACE:${COUNTERPOINT_INCLUDES}>)
    target_compile_options(${room} PRIVATE ${COUNTERPOINT_PACKAGE_OPTIONS})
    # What ships is compiled without a compiler cache, which may rewrite paths, so that it is the same in any folder.
    get_target_property(launcher ${room} CXX_COMPILER_LAUNCHER)
    if(COUNTERPOINT_PACKAGE_OPTIONS AND NOT launcher MATCHES "compile_with")
      set_target_properties(${room} PROPERTIES CXX_COMPILER_LAUNCHER "")
    endif()
  endif()
endforeach()

# All that the package holds, in one target, so that nobody has to list it: what is built by it can be installed.
add_custom_target(counterpoint_package)
add_dependencies(counterpoint_package ${COUNTERPOINT_INSTALLED_ROOMS})
if(COUNTERPOINT_HOST)
  add_dependencies(counterpoint_package counterpoint counterpoint_shell_texts)
endif()

install(TARGETS ${COUNTERPOINT_INSTALLED_ROOMS} EXPORT CounterpointTargets ARCHIVE DESTINATION ${COUNTERPOINT_ARCHIVES} COMPONENT library)
foreach(folder IN LISTS COUNTERPOINT_INSTALLED_FOLDERS)
  install(DIRECTORY ${COUNTERPOINT_NAMES}/names/${folder}/ DESTINATION ${COUNTERPOINT_INCLUDES}/names/${folder} COMPONENT library OPTIONAL
          FILES_MATCHING PATTERN "*.hpp")
  install(DIRECTORY ${Counterpoint_SOURCE_DIR}/${folder}/ DESTINATION ${COUNTERPOINT_INCLUDES}/${folder} COMPONENT library
          FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(EXPORT CounterpointTargets NAMESPACE Counterpoint:: DESTINATION ${COUNTERPOINT_PACKAGE_FOLDER} COMPONENT library)

configure_package_config_file(${Counterpoint_SOURCE_DIR}/cmake/CounterpointConfig.cmake.in
    ${Counterpoint_BINARY_DIR}/CounterpointConfig.cmake INSTALL_DESTINATION ${COUNTERPOINT_PACKAGE_FOLDER})
write_basic_package_version_file(${Counterpoint_BINARY_DIR}/CounterpointConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${Counterpoint_BINARY_DIR}/CounterpointConfig.cmake ${Counterpoint_BINARY_DIR}/CounterpointConfigVersion.cmake
        DESTINATION ${COUNTERPOINT_PACKAGE_FOLDER} COMPONENT library)

# For builds without CMake. The archives need each other, so the linker searches them until nothing is found any more.
set(libraries ${COUNTERPOINT_INSTALLED_ROOMS})
list(REMOVE_ITEM libraries names safety_core_contract)
list(TRANSFORM libraries PREPEND -l)
list(JOIN libraries " " COUNTERPOINT_LIBRARIES)
file(RELATIVE_PATH COUNTERPOINT_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${Counterpoint_SOURCE_DIR}/cmake/counterpoint.pc.in ${Counterpoint_BINARY_DIR}/counterpoint.pc @ONLY)
install(FILES ${Counterpoint_BINARY_DIR}/counterpoint.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)

# Scenarios, devices as files, and the examples that are projects of their own; the others are rooms of the tree.
set(COUNTERPOINT_SHARE ${CMAKE_INSTALL_DATADIR}/counterpoint)
install(DIRECTORY ${Counterpoint_SOURCE_DIR}/examples DESTINATION ${COUNTERPOINT_SHARE} COMPONENT tool
        FILES_MATCHING PATTERN "*.yaml" PATTERN "*.dcf" PATTERN "examples/README.md" PATTERN firmware EXCLUDE PATTERN host EXCLUDE
        PATTERN common EXCLUDE PATTERN controller EXCLUDE PATTERN generated_actuator EXCLUDE PATTERN network_manager EXCLUDE)
foreach(project first_device whole_device port_skeleton port_fifo rtos_task)
  install(DIRECTORY ${Counterpoint_SOURCE_DIR}/examples/${project} DESTINATION ${COUNTERPOINT_SHARE}/examples COMPONENT tool)
endforeach()
install(FILES ${Counterpoint_SOURCE_DIR}/LICENSE ${Counterpoint_SOURCE_DIR}/CHANGELOG.md DESTINATION ${COUNTERPOINT_SHARE} COMPONENT tool)
install(DIRECTORY ${Counterpoint_SOURCE_DIR}/docs DESTINATION ${COUNTERPOINT_SHARE} COMPONENT tool FILES_MATCHING PATTERN "*.md" PATTERN decisions EXCLUDE
        PATTERN requirements EXCLUDE PATTERN facts EXCLUDE PATTERN charts EXCLUDE)
find_program(COUNTERPOINT_PYTHON python3 REQUIRED)
install(CODE "execute_process(COMMAND ${COUNTERPOINT_PYTHON} ${Counterpoint_SOURCE_DIR}/cmake/installed_links.py
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${COUNTERPOINT_SHARE}\" COMMAND_ERROR_IS_FATAL ANY)" COMPONENT tool)
# Where Debian looks for the licence of a package.
install(FILES ${Counterpoint_SOURCE_DIR}/LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libcounterpoint-dev COMPONENT library)
install(FILES ${Counterpoint_SOURCE_DIR}/LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/counterpoint COMPONENT tool)

include(cmake/Pack.cmake)
