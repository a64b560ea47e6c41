# Debian packages, `cpack -G DEB` in the folder of the build: libcounterpoint-dev with headers and archives, counterpoint with the
# program, its documents and its examples. Neither needs the other one.
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL library)
if(COUNTERPOINT_HOST)
  list(APPEND CPACK_COMPONENTS_ALL tool)
endif()
set(CPACK_PACKAGE_CONTACT "the Counterpoint authors <counterpoint@example.invalid>")
set(CPACK_PACKAGE_VENDOR "the Counterpoint authors")
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libcounterpoint-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS counterpoint)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "Headers and static libraries: kernel, channels, services of a device and of a manager, and
what a bench needs. CMake and pkg-config find them.")
set(CPACK_DEBIAN_TOOL_PACKAGE_NAME counterpoint)
set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_TOOL_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_TOOL_DESCRIPTION "The command counterpoint (simulator, signatures, node, manager, monitor) with its manual page,
completion, documents and examples.")
include(CPack)
