# Run by the installation: copies the headers of worlds, experiments and searches and everything that they include, to
# JAYWALK_INCLUDE_DIR below the prefix. JAYWALK_SOURCE_DIR is the project's folder.
cmake_policy(VERSION 3.25)
set(pending "")
# All headers of the other layers, except for internals of reading scenarios and of searching.
foreach(layer env experiment search)
  file(GLOB_RECURSE headers RELATIVE ${JAYWALK_SOURCE_DIR} ${JAYWALK_SOURCE_DIR}/${layer}/*.h)
  list(APPEND pending ${headers})
endforeach()
list(FILTER pending EXCLUDE REGEX "/(scenario_reader|scenario_schema|scenario_yaml|trimmed)\\.h$")
list(FILTER pending EXCLUDE REGEX "^search/(evolve|generators|learn|model_based|store|suts)/")
list(FILTER pending EXCLUDE REGEX "^experiment/networks/(layer|network|product|root)\\.h$")

set(found "")
while(pending)
  list(POP_FRONT pending header)
  if(NOT header IN_LIST found AND EXISTS ${JAYWALK_SOURCE_DIR}/${header})
    list(APPEND found ${header})
    file(STRINGS ${JAYWALK_SOURCE_DIR}/${header} lines REGEX "^ *# *include \"")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE ".*\"(.*)\".*" "\\1" included "${line}")
      list(APPEND pending ${included})
    endforeach()
  endif()
endwhile()

foreach(header IN LISTS found)
  get_filename_component(folder ${header} DIRECTORY)
  file(INSTALL ${JAYWALK_SOURCE_DIR}/${header}
       DESTINATION ${CMAKE_INSTALL_PREFIX}/${JAYWALK_INCLUDE_DIR}/${folder})
endforeach()
