# Code generated from idl/ at build time, into the build folder only. Other people's generators make
# it, so it is compiled without warnings, and its headers are system headers to whoever includes
# them: only the sources of common/io/wire and common/transport may (tests/system/layering.py).

# accord_protobuf(NAME FILE.proto): a library of the messages; include as "FILE.pb.h".
function(accord_protobuf name proto)
  get_filename_component(stem ${proto} NAME_WE)
  get_filename_component(folder ${proto} DIRECTORY)
  set(out ${PROJECT_BINARY_DIR}/generated/${name})
  add_custom_command(
    OUTPUT ${out}/${stem}.pb.cc ${out}/${stem}.pb.h
    COMMAND ${CMAKE_COMMAND} -E make_directory ${out}
    COMMAND protobuf::protoc --cpp_out=${out} --proto_path=${folder} ${proto}
    DEPENDS ${proto} VERBATIM)
  accord_generated_library(${name} ${out} ${out}/${stem}.pb.cc)
  target_link_libraries(${name} PUBLIC protobuf::libprotobuf)
endfunction()

# accord_dds(NAME FILE.idl): a library of the types and their type supports; include as
# "FILEPubSubTypes.h".
function(accord_dds name idl)
  get_filename_component(stem ${idl} NAME_WE)
  set(out ${PROJECT_BINARY_DIR}/generated/${name})
  # -cs: names that differ in case only are different. -replace: else it fails where files exist.
  add_custom_command(
    OUTPUT ${out}/${stem}.cxx ${out}/${stem}.h ${out}/${stem}PubSubTypes.cxx
           ${out}/${stem}PubSubTypes.h
    COMMAND ${CMAKE_COMMAND} -E make_directory ${out}/tmp
    COMMAND ${FASTDDSGEN} -replace -cs -d ${out} -t ${out}/tmp ${idl}
    DEPENDS ${idl} VERBATIM)
  accord_generated_library(${name} ${out} ${out}/${stem}.cxx ${out}/${stem}PubSubTypes.cxx)
  target_link_libraries(${name} PUBLIC fastrtps fastcdr)
endfunction()

# Generated code is run under the sanitizers like any other: they look at what it does to our data.
function(accord_generated_library name folder)
  add_library(${name} STATIC ${ARGN})
  target_compile_options(${name} PRIVATE -w)
  target_include_directories(${name} SYSTEM PUBLIC ${folder})
  if(ACCORD_SANITIZE)
    target_compile_options(${name} PRIVATE -fsanitize=${ACCORD_SANITIZE} -fno-omit-frame-pointer)
  endif()
endfunction()
