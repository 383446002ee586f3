# The fleet-manager library for other people's programs: find_package(accord CONFIG REQUIRED) and
# target_link_libraries(app accord::fleet).
#
# One shared library with all of ours in it, so that who links it needs nothing of what it is made
# of, neither Fast DDS's headers nor FCL's. It exports what the headers below declare, and nothing
# else.

# What a fleet manager's or a robot's program includes, and what those include; nothing may be
# missing (tests/system/package/headers_test.py).
set(accord_fleet_headers
  client/fleet/cancellation.h
  client/fleet/fleet_manager.h
  client/fleet/request_file.h
  common/io/diagnostic.h
  common/io/wire/bytes.h
  common/io/wire/scene_hash.h
  common/io/words.h
  common/model/configuration.h
  common/model/ids.h
  common/model/plan.h
  common/model/plan_request.h
  common/model/request_state.h
  common/model/robot.h
  common/model/scene.h
  common/model/shape.h
  common/model/trajectory.h
  common/runtime/configuration.h
  common/runtime/notation.h
  common/runtime/settings.h
  common/transport/dds_options.h
  common/transport/dds_settings.h
  common/transport/fleet/dds_fleet.h
  common/transport/fleet/fleet_messages.h
  common/transport/fleet/fleet_port.h
  common/transport/fleet/fleet_traffic.h
  common/transport/fleet/path_assembly.h
  common/transport/fleet/plan_parts.h
  common/transport/fleet/robot_port.h
  common/transport/messages.h
  common/transport/ros/ros_options.h
  common/transport/traffic.h)
# Where what they declare is defined, where that is not the file of the same name.
set(accord_fleet_other_sources
  common/transport/fleet/dds_fleet_client.cpp
  common/transport/fleet/dds_fleet_service.cpp
  common/transport/fleet/dds_robot_port.cpp)

# All of it is position independent. Nobody replaces a function of ours by one of the same name, so
# the compiler may go on to inline them: planning takes at most 0.2 % more instructions than without.
set(accord_fleet_folders accord_model accord_geometry accord_planning accord_io accord_runtime
    accord_wire accord_transport accord_transport_dds accord_fleet)
foreach(folder ${accord_fleet_folders} accord_proto accord_idl accord_fleet_idl accord_ros_idl)
  set_target_properties(${folder} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${folder} PRIVATE -fno-semantic-interposition)
endforeach()

# Objects that are linked by themselves are exported, those from archives (the rest) are not. So it
# is made of the objects of what defines the headers' functions, and of archives.
set(exported ${accord_fleet_headers})
list(TRANSFORM exported REPLACE "\\.h$" ".cpp")
list(APPEND exported ${accord_fleet_other_sources})
add_library(accord_fleet_library SHARED)
foreach(folder ${accord_fleet_folders})
  get_target_property(path ${folder} SOURCE_DIR)
  file(RELATIVE_PATH path ${PROJECT_SOURCE_DIR} ${path})
  get_target_property(sources ${folder} SOURCES)
  set(objects "")
  foreach(source ${sources})
    if("${path}/${source}" IN_LIST exported)
      list(APPEND objects ${source})
    endif()
  endforeach()
  if(objects)
    list(JOIN objects "|" objects)
    target_sources(accord_fleet_library PRIVATE
      "$<FILTER:$<TARGET_OBJECTS:${folder}>,INCLUDE,/(${objects})\\.o$>")
  endif()
endforeach()
set(version_script ${PROJECT_SOURCE_DIR}/cmake/accord_fleet.map)
target_link_options(accord_fleet_library PRIVATE
  LINKER:--exclude-libs,ALL LINKER:--version-script,${version_script} LINKER:--no-undefined
  LINKER:--as-needed)
target_link_libraries(accord_fleet_library PRIVATE accord_fleet INTERFACE Eigen3::Eigen tl::expected)
target_include_directories(accord_fleet_library INTERFACE $<INSTALL_INTERFACE:include/accord>)
target_compile_features(accord_fleet_library INTERFACE cxx_std_20)
# Until 1.0, what it exports may change with every release.
set(accord_fleet_soversion ${PROJECT_VERSION_MAJOR})
set_target_properties(accord_fleet_library PROPERTIES
  OUTPUT_NAME accord-fleet EXPORT_NAME fleet LINKER_LANGUAGE CXX LINK_DEPENDS ${version_script}
  VERSION ${PROJECT_VERSION} SOVERSION ${accord_fleet_soversion}
  LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
