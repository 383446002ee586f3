# The target accord::fleet, the fleet-manager library.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 NO_MODULE)
find_dependency(tl-expected)
include(${CMAKE_CURRENT_LIST_DIR}/accord-targets.cmake)
