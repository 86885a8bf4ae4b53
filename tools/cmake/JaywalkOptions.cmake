# The options of the build; all begin with JAYWALK_ and default to what a consumer wants.

option(JAYWALK_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
set(JAYWALK_TESTS "code;programs" CACHE STRING
    "Which tests: code (units, hostile input, style), programs (scenarios, the command, figures, package), or both")
foreach(part IN LISTS JAYWALK_TESTS)
  if(NOT part MATCHES "^(code|programs)$")
    message(FATAL_ERROR "JAYWALK_TESTS: expected code, programs or both (code;programs), found '${part}'")
  endif()
endforeach()
option(JAYWALK_WERROR "Treat warnings as errors" OFF)
option(JAYWALK_UNITY "Compile up to eight files at a time: a clean build takes half as long" ON)
set(JAYWALK_SANITIZERS "" CACHE STRING "Sanitizers to build with, as in -fsanitize= (address,undefined)")
set(JAYWALK_UNCHECKED "" CACHE STRING "Of these what all but the interpreter is built without")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# Hidden symbols are reached without a table where code is position-independent.
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_UNITY_BUILD ${JAYWALK_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8 CACHE STRING "Files compiled at a time; 0 for all of a target")

find_program(JAYWALK_CCACHE ccache)
if(JAYWALK_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${JAYWALK_CCACHE}")
endif()
