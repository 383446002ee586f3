# What `cmake --install` puts where, below the prefix; which of it belongs to which Debian package
# says the component (AccordPackage.cmake).

# As Debian has it, also below /usr/local; there, CMake and the loader look there by themselves.
if(CMAKE_LIBRARY_ARCHITECTURE AND EXISTS /etc/debian_version AND NOT DEFINED CMAKE_INSTALL_LIBDIR)
  set(CMAKE_INSTALL_LIBDIR lib/${CMAKE_LIBRARY_ARCHITECTURE} CACHE PATH "Libraries")
endif()
include(GNUInstallDirs)

# The component `programs`: what runs, with scenes to try it on and the manual.
set(accord_programs accord accord-fleet accord-coordinator accord-worker accord-discovery)
install(TARGETS ${accord_programs} COMPONENT programs)

# Scenes that show something, with all files that any of them names; the others are for measuring.
set(accord_scenes adaptive-manipulator adaptive-mobile carts-6 depot-map drones-12 high-manipulator-4
    high-mobile low-mobile-32 mixed-cell mixed-floor panda-four rack-drones ros-floor ur5e-pair)
list(TRANSFORM accord_scenes PREPEND ${PROJECT_SOURCE_DIR}/scenes/)
list(TRANSFORM accord_scenes APPEND .yaml)
set(accord_scenes_folder ${CMAKE_INSTALL_DATADIR}/accord/scenes)
install(FILES ${accord_scenes} DESTINATION ${accord_scenes_folder} COMPONENT programs)
install(DIRECTORY scenes/ DESTINATION ${accord_scenes_folder} COMPONENT programs
  FILES_MATCHING PATTERN "*.urdf" PATTERN "*.srdf" PATTERN "maps/*" PATTERN "meshes/*"
  PATTERN generate EXCLUDE PATTERN families EXCLUDE)

# /usr/share/doc/accord on Debian.
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs)

# The components `library` and `development`: the fleet-manager library, and what it takes to compile
# with it; the IDL is for those who speak DDS by themselves.
install(TARGETS accord_fleet_library EXPORT accord
  LIBRARY COMPONENT library NAMELINK_COMPONENT development)
foreach(header ${accord_fleet_headers})
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header} DESTINATION include/accord/${folder} COMPONENT development)
endforeach()
set(accord_cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/accord)
install(EXPORT accord NAMESPACE accord:: FILE accord-targets.cmake
  DESTINATION ${accord_cmake_folder} COMPONENT development)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(accord-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/accord-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/accord-config-version.cmake
  DESTINATION ${accord_cmake_folder} COMPONENT development)
install(FILES idl/fleet.idl idl/ros.idl DESTINATION ${CMAKE_INSTALL_DATADIR}/accord/idl
  COMPONENT development)
install(FILES client/example/fleet_manager_example.cpp deploy/example/CMakeLists.txt
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libaccord-fleet-dev/examples COMPONENT development)

# The component `service`: units, and configuration for them. Only in a package, since it has places
# of its own, which no prefix moves.
install(DIRECTORY deploy/systemd/ DESTINATION /usr/lib/systemd/system
  COMPONENT service EXCLUDE_FROM_ALL)
install(DIRECTORY deploy/etc/ DESTINATION /etc/accord COMPONENT service EXCLUDE_FROM_ALL)
