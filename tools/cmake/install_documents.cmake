# Run by the installation, after everything else: copies the documents to JAYWALK_DOC_DIR, laid out as in the
# project; those of agents, examples and scenarios lie beside these in JAYWALK_DATA_DIR. Links lead to the installed targets,
# public headers in JAYWALK_INCLUDE_DIR among them; a link to a file that is not installed becomes plain text.
# JAYWALK_SOURCE_DIR is the project's folder, JAYWALK_BINARY_DIR has room for the documents with their new links;
# the other folders are below the prefix.
cmake_policy(VERSION 3.25)
file(GLOB documents RELATIVE ${JAYWALK_SOURCE_DIR} ${JAYWALK_SOURCE_DIR}/*.md)
foreach(folder agents docs env examples experiment interpreter scenarios search tools)
  file(GLOB_RECURSE found RELATIVE ${JAYWALK_SOURCE_DIR} ${JAYWALK_SOURCE_DIR}/${folder}/*.md)
  list(APPEND documents ${found})
endforeach()
list(APPEND documents CITATION.cff LICENSE NOTICE)

# The place of a file or folder of the project below the prefix.
function(find_place path result)
  if(path MATCHES "^(agents|examples|scenarios)(/|$)")
    set(${result} ${JAYWALK_DATA_DIR}/${path} PARENT_SCOPE)
  elseif(path MATCHES "^[a-z]+/include/(.*)")
    set(${result} ${JAYWALK_INCLUDE_DIR}/${CMAKE_MATCH_1} PARENT_SCOPE)
  else()
    set(${result} ${JAYWALK_DOC_DIR}/${path} PARENT_SCOPE)
  endif()
endfunction()

foreach(document IN LISTS documents)
  cmake_path(GET document PARENT_PATH folder)
  find_place(${document} place)
  cmake_path(GET place PARENT_PATH destination)
  file(READ ${JAYWALK_SOURCE_DIR}/${document} text)
  # Lists of CMake trip over a single bracket.
  string(REPLACE "](" "<link>(" marked "${text}")
  string(REGEX MATCHALL "<link>\\([^) #]+" links "${marked}")
  list(REMOVE_DUPLICATES links)
  list(FILTER links EXCLUDE REGEX "://")
  foreach(link IN LISTS links)
    string(REPLACE "<link>(" "" target "${link}")
    cmake_path(SET path NORMALIZE "${folder}/${target}")
    string(REGEX REPLACE "^/" "" path "${path}")
    find_place(${path} target_place)
    if(path IN_LIST documents OR EXISTS "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${target_place}")
      cmake_path(RELATIVE_PATH target_place BASE_DIRECTORY ${destination})
      string(REPLACE "](${target})" "](${target_place})" text "${text}")
      string(REPLACE "](${target}#" "](${target_place}#" text "${text}")
    else()
      string(REPLACE "." "\\." target "${target}")
      string(REGEX REPLACE "!?\\[([^]]*)\\]\\(${target}(#[^)]*)?\\)" "\\1" text "${text}")
    endif()
  endforeach()
  file(WRITE ${JAYWALK_BINARY_DIR}/documents/${document} "${text}")
  file(INSTALL ${JAYWALK_BINARY_DIR}/documents/${document}
       DESTINATION ${CMAKE_INSTALL_PREFIX}/${destination})
endforeach()
