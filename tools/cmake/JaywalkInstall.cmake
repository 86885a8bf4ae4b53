# The files that `cmake --install` installs, all below one prefix that may be moved:
#
#   bin/jaywalk                 the command; it finds what it ships with beside itself
#   bin/jaywalk-draw            the program that the command runs to draw pictures
#   include/jaywalk/            the public headers, those of */include/jaywalk in the project
#   lib/libjaywalk_*.a          the libraries
#   lib/cmake/jaywalk/          find_package(jaywalk): jaywalk::interpreter, ::env, ::experiment, ::search
#   share/jaywalk/              agents, scenarios and examples, with their documents; jason/, the host of Java classes
#   share/doc/jaywalk/          the other documents, in the project's folders, and the licence
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(JAYWALK_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/jaywalk)
set(JAYWALK_DATA_DIR ${CMAKE_INSTALL_DATADIR}/jaywalk)

# The command's own libraries are not exported: no other program can use them.
get_property(libraries GLOBAL PROPERTY JAYWALK_LIBRARIES)
list(REMOVE_ITEM libraries jaywalk_command jaywalk_programs jaywalk_picture)
install(TARGETS ${libraries} EXPORT jaywalk-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
foreach(library interpreter env experiment search)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${library}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          FILES_MATCHING PATTERN "*.h")
endforeach()
install(EXPORT jaywalk-targets NAMESPACE jaywalk:: DESTINATION ${JAYWALK_PACKAGE_DIR})
install(TARGETS jaywalk jaywalk-draw RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/jaywalk-config.cmake.in
                              ${PROJECT_BINARY_DIR}/jaywalk-config.cmake
                              INSTALL_DESTINATION ${JAYWALK_PACKAGE_DIR}
                              PATH_VARS JAYWALK_DATA_DIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/jaywalk-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/jaywalk-config.cmake
              ${PROJECT_BINARY_DIR}/jaywalk-config-version.cmake
        DESTINATION ${JAYWALK_PACKAGE_DIR})

install(CODE "set(JAYWALK_SOURCE_DIR \"${PROJECT_SOURCE_DIR}\")
              set(JAYWALK_BINARY_DIR \"${PROJECT_BINARY_DIR}\")
              set(JAYWALK_INCLUDE_DIR \"${CMAKE_INSTALL_INCLUDEDIR}\")
              set(JAYWALK_DATA_DIR \"${JAYWALK_DATA_DIR}\")
              set(JAYWALK_DOC_DIR \"${CMAKE_INSTALL_DOCDIR}\")")

install(DIRECTORY ${PROJECT_SOURCE_DIR}/agents ${PROJECT_SOURCE_DIR}/examples ${PROJECT_SOURCE_DIR}/scenarios
        DESTINATION ${JAYWALK_DATA_DIR} USE_SOURCE_PERMISSIONS
        FILES_MATCHING PATTERN "*.asl" PATTERN "*.mas2j" PATTERN "*.py" PATTERN "*.yaml" PATTERN "*.csv"
        PATTERN "*.json" PATTERN "*.svg" PATTERN "*.xml" PATTERN "*.sh" PATTERN "*.cpp" PATTERN "*.txt"
        PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/jason DESTINATION ${JAYWALK_DATA_DIR} FILES_MATCHING PATTERN "*.java")
install(FILES ${PROJECT_SOURCE_DIR}/docs/crossing.gif ${PROJECT_SOURCE_DIR}/docs/paper.svg
        DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/install_documents.cmake)
