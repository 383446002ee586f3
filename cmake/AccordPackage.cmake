# Debian packages of what AccordInstall.cmake installs: `cmake --build build --target deb`, or
# `cpack -G DEB` in the build folder once everything is built. What they depend on at run time is
# found by dpkg-shlibdeps in the programs themselves.

set(accord_debian ${PROJECT_SOURCE_DIR}/deploy/debian)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The authors of Accord <authors@accord.example>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_SET_DESTDIR ON)
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL programs service library development)
set(CPACK_COMPONENT_PROGRAMS_GROUP accord)
set(CPACK_COMPONENT_SERVICE_GROUP accord)
set(CPACK_COMPONENT_LIBRARY_GROUP library)
set(CPACK_COMPONENT_DEVELOPMENT_GROUP development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# What Debian wants to know of each, next to what AccordInstall.cmake has put there.
set(library_package libaccord-fleet${accord_fleet_soversion})
set(out ${PROJECT_BINARY_DIR}/debian)
file(MAKE_DIRECTORY ${out})
find_program(GZIP gzip REQUIRED)
execute_process(COMMAND ${GZIP} -9 --no-name --stdout ${accord_debian}/changelog
  OUTPUT_FILE ${out}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${accord_debian}/changelog)
foreach(component_package programs/accord library/${library_package} development/libaccord-fleet-dev)
  get_filename_component(package ${component_package} NAME)
  get_filename_component(component ${component_package} DIRECTORY)
  install(FILES ${accord_debian}/copyright ${out}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()
install(FILES ${accord_debian}/lintian-overrides RENAME accord
  DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT programs EXCLUDE_FROM_ALL)

# /etc is configuration: what a person changed there survives an upgrade.
file(GLOB conffiles RELATIVE ${PROJECT_SOURCE_DIR}/deploy/etc CONFIGURE_DEPENDS
     ${PROJECT_SOURCE_DIR}/deploy/etc/*)
list(TRANSFORM conffiles PREPEND /etc/accord/)
list(JOIN conffiles "\n" conffiles)
file(WRITE ${out}/conffiles "${conffiles}\n")

set(CPACK_DEBIAN_ACCORD_PACKAGE_NAME accord)
set(CPACK_DEBIAN_ACCORD_DESCRIPTION "planning service for fleets of robots
Accord plans collision-free motions for many robots at once, mobile robots
and arms alike, and proves every plan before it hands it out. In here: the
accord command, the coordinator and the worker of the planning service,
systemd units for them, and example scenes.")
# Of the maintainer scripts: useradd.
set(CPACK_DEBIAN_ACCORD_PACKAGE_DEPENDS passwd)
set(CPACK_DEBIAN_ACCORD_PACKAGE_CONTROL_EXTRA ${out}/conffiles
    ${accord_debian}/postinst ${accord_debian}/prerm ${accord_debian}/postrm)

# A package of a program that is linked with this library wants this very version, until 1.0.
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY "=")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${library_package})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${accord_debian}/triggers)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "fleet managers' side of the Accord planning service
A library for C++ programs that have plans made for their robots by an
Accord service, over DDS. This is what such programs run with.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libaccord-fleet-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "fleet managers' side of the Accord planning service: development
A library for C++ programs that have plans made for their robots by an
Accord service, over DDS. This is what such programs are compiled with:
headers, a CMake package, an example, and the topics' IDL for those who
speak DDS without the library.")
# What its headers include.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "${library_package} (= ${PROJECT_VERSION}), libeigen3-dev, libexpected-dev")

include(CPack)
add_custom_target(deb
  COMMAND ${CMAKE_CPACK_COMMAND} -G DEB
  DEPENDS ${accord_programs} accord_fleet_library
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
  USES_TERMINAL VERBATIM COMMENT "Debian packages, in packages/")
