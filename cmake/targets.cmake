# Helpers for the targets of this package.
if(AGRID_ROS)
  set(AGRID_DEVEL_PREFIX ${CATKIN_DEVEL_PREFIX})
else()
  set(AGRID_DEVEL_PREFIX ${CMAKE_BINARY_DIR}/devel)
endif()

# Language, warnings and include folders of one of our targets.
function(agrid_configure target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion)
  if(AGRID_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
endfunction()
