# Debian packages of what AccordInstall.cmake installs: `cmake --build build --target deb`, or
# `cpack -G DEB` in the build folder once everything is built. What they depend on at run time is
# found by dpkg-shlibdeps in the programs themselves.

set(accord_debian ${PROJECT_SOURCE_DIR}/deploy/debian)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The authors of Accord <accord@localhost>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_OUTPUT_FILE_PREFIX ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_SET_DESTDIR ON)
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL programs service)
set(CPACK_COMPONENT_PROGRAMS_GROUP accord)
set(CPACK_COMPONENT_SERVICE_GROUP accord)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# /etc is configuration: what a person changed there survives an upgrade.
set(conffiles "")
foreach(service coordinator worker discovery)
  if(TARGET accord-${service})
    string(APPEND conffiles "/etc/accord/${service}.yaml\n")
  endif()
endforeach()
file(WRITE ${PROJECT_BINARY_DIR}/debian/conffiles "${conffiles}")

set(CPACK_DEBIAN_ACCORD_PACKAGE_NAME accord)
set(CPACK_COMPONENT_GROUP_ACCORD_DESCRIPTION
"planning service for fleets of robots
Accord plans collision-free motions for many robots at once, mobile robots
and arms alike, and proves every plan before it hands it out. In here: the
accord command, the coordinator and the worker of the planning service,
systemd units for them, and example scenes.")
set(CPACK_DEBIAN_ACCORD_DESCRIPTION ${CPACK_COMPONENT_GROUP_ACCORD_DESCRIPTION})
# Of the maintainer scripts: useradd.
set(CPACK_DEBIAN_ACCORD_PACKAGE_DEPENDS passwd)
set(CPACK_DEBIAN_ACCORD_PACKAGE_CONTROL_EXTRA
    "${PROJECT_BINARY_DIR}/debian/conffiles;${accord_debian}/postinst;${accord_debian}/prerm;${accord_debian}/postrm")

include(CPack)
add_custom_target(deb
  COMMAND ${CMAKE_CPACK_COMMAND} -G DEB
  DEPENDS ${accord_programs}
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
  USES_TERMINAL VERBATIM COMMENT "Debian packages, in packages/")
