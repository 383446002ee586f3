# What `cmake --install` puts where, below the prefix; which of it belongs to which Debian package
# says the component (AccordPackage.cmake).

# As Debian has it, also below /usr/local; there, CMake and the loader look there by themselves.
if(CMAKE_LIBRARY_ARCHITECTURE AND EXISTS /etc/debian_version AND NOT DEFINED CMAKE_INSTALL_LIBDIR)
  set(CMAKE_INSTALL_LIBDIR lib/${CMAKE_LIBRARY_ARCHITECTURE} CACHE PATH "Libraries")
endif()
include(GNUInstallDirs)

# The component `programs`: what runs, with scenes to try it on and the manual.
set(accord_programs accord accord-fleet accord-coordinator accord-worker)
if(TARGET accord-discovery)
  list(APPEND accord_programs accord-discovery)
endif()
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

# The component `service`: units, and configuration for them. Only in a package, since it has places
# of its own, which no prefix moves.
foreach(service coordinator worker discovery)
  if(TARGET accord-${service})
    install(FILES deploy/systemd/accord-${service}.service DESTINATION /usr/lib/systemd/system
      COMPONENT service EXCLUDE_FROM_ALL)
    install(FILES deploy/etc/${service}.yaml DESTINATION /etc/accord
      COMPONENT service EXCLUDE_FROM_ALL)
  endif()
endforeach()
install(FILES deploy/systemd/accord-.service.d/10-accord.conf
  DESTINATION /usr/lib/systemd/system/accord-.service.d COMPONENT service EXCLUDE_FROM_ALL)
