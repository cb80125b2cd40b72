# SPDX-License-Identifier: GPL-3.0-or-later
# What `tools/package` puts into a Debian package: both programs with their manual pages, the examples, and what a
# desktop needs to know of them.
include(GNUInstallDirs)
set(package_files ${PROJECT_SOURCE_DIR}/resources/package)
set(made ${CMAKE_BINARY_DIR}/package)
# Without it a package builds the tests as well.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

# Each program writes its own manual page, from what its --help is made of.
add_custom_target(package_pages ALL)
foreach(program isoscope isoscope-cli)
  if(TARGET ${program})
    add_custom_command(OUTPUT ${made}/${program}.1.gz
      COMMAND ${CMAKE_COMMAND} -E make_directory ${made}
      COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C.UTF-8 $<TARGET_FILE:${program}> --manual > ${made}/${program}.1
      COMMAND gzip -9nf ${made}/${program}.1
      DEPENDS ${program} VERBATIM)
    add_custom_target(package_page_${program} DEPENDS ${made}/${program}.1.gz)
    add_dependencies(package_pages package_page_${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    install(FILES ${made}/${program}.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
  endif()
endforeach()
if(TARGET isoscope)
  install(FILES ${package_files}/isoscope.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES ${package_files}/org.example.Isoscope.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
  install(FILES resources/icons/isoscope.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()
install(FILES ${package_files}/isoscope.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES ${package_files}/isoscope.thumbnailer DESTINATION ${CMAKE_INSTALL_DATADIR}/thumbnailers)
install(FILES ${package_files}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/isoscope/examples FILES_MATCHING PATTERN "*.pov" PATTERN "*.vl")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME isoscope)
set(CPACK_PACKAGE_CONTACT "The Isoscope project <isoscope@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "instrument for isosurfaces in POV-Ray's language")
set(CPACK_PACKAGE_DESCRIPTION "Isoscope shows the surface of a function of x, y, z in POV-Ray's scene language
while it is typed. Every number is a slider. It says with proof whether
POV-Ray's picture has holes and what max_gradient has to be.
.
The package holds the desktop program and isoscope-cli, the same engine for
scripts.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt6svg6, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "breeze-icon-theme, qt6-translations-l10n, povray, povray-includes")
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/PackageDates.cmake)
set(CPACK_ISOSCOPE_CHANGES ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
include(CPack)
