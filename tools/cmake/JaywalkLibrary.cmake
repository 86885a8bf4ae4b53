# How every target of the project is built.

# GCC 12 sees overlapping copies in std::string's own code where there are none (GCC bug 105329).
set(JAYWALK_FALSE_ALARMS "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  set(JAYWALK_FALSE_ALARMS -Wno-restrict)
endif()

# A class of a .cpp file may have members of types that are that file's own, in whatever is compiled
# with it.
set(JAYWALK_UNITY_ALARMS "")
if(JAYWALK_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(JAYWALK_UNITY_ALARMS -Wno-subobject-linkage)
endif()

# -fPIC, also of programs, which share precompiled headers with libraries: modules can be linked with
# the static libraries.
# Programs read files of strangers, so memory that a bug could overwrite is guarded. The standard
# library's checks of lengths need optimisation; sanitizers have their own. Its assertions
# (_GLIBCXX_ASSERTIONS) cost up to an eighth of the instructions, tests/bench/README.md.
set(JAYWALK_HARDENING "")
if(NOT JAYWALK_SANITIZERS AND CMAKE_BUILD_TYPE MATCHES "^Rel|^MinSizeRel$")
  set(JAYWALK_HARDENING -fstack-protector-strong -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2 -fPIC)
endif()

# Instrumented code without any optimisation is too slow for the scenario tests. A folder whose code is
# not run often sets a level that takes less time to compile.
set(JAYWALK_SANITIZED_LEVEL -O1)

# Warnings, sanitizers and the include root (the project's folder) for one target.
function(jaywalk_configure_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  # Designated initialisers leave fields at their defaults on purpose.
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                         -Wno-missing-field-initializers ${JAYWALK_FALSE_ALARMS}
                         ${JAYWALK_UNITY_ALARMS} $<$<BOOL:${JAYWALK_WERROR}>:-Werror>
                         ${JAYWALK_HARDENING})
  if(JAYWALK_HARDENING)
    target_link_options(${target} PRIVATE -pie -Wl,-z,relro,-z,now)
  endif()
  if(JAYWALK_SANITIZERS)
    # -g1: lines are all that a finding needs, and they compile in three quarters of the time.
    target_compile_options(${target} PRIVATE -fsanitize=${JAYWALK_SANITIZERS}
                           -fno-sanitize-recover=all -fno-omit-frame-pointer
                           ${JAYWALK_SANITIZED_LEVEL} -g1)
    # Without some checks GCC 12 warns of unset values of std::optional that are never read.
    if(JAYWALK_UNCHECKED)
      target_compile_options(${target} PRIVATE -fno-sanitize=${JAYWALK_UNCHECKED} -Wno-maybe-uninitialized)
    endif()
    target_link_options(${target} PUBLIC -fsanitize=${JAYWALK_SANITIZERS})
  endif()
endfunction()

# Libraries that are headers alone are needed to build a target, not to link with it once installed.
set(JAYWALK_HEADER_LIBRARIES Boost::headers Eigen3::Eigen nlohmann_json::nlohmann_json)
function(jaywalk_link_privately target)
  foreach(library IN LISTS ARGN)
    if(library IN_LIST JAYWALK_HEADER_LIBRARIES)
      set(library $<BUILD_INTERFACE:${library}>)
    endif()
    target_link_libraries(${target} PRIVATE ${library})
  endforeach()
endfunction()

# jaywalk_add_library(name SOURCES file... [PUBLIC lib...] [PRIVATE lib...])
# A static library jaywalk_<name> with the alias jaywalk::<name>.
function(jaywalk_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(jaywalk_${name} STATIC ${ARG_SOURCES})
  add_library(jaywalk::${name} ALIAS jaywalk_${name})
  target_include_directories(jaywalk_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  jaywalk_link_privately(jaywalk_${name} ${ARG_PRIVATE})
  target_link_libraries(jaywalk_${name} PUBLIC ${ARG_PUBLIC})
  set_property(GLOBAL APPEND PROPERTY JAYWALK_LIBRARIES jaywalk_${name})
  set_target_properties(jaywalk_${name} PROPERTIES EXPORT_NAME ${name})
  jaywalk_configure_target(jaywalk_${name})
endfunction()
