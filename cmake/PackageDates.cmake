# SPDX-License-Identifier: GPL-3.0-or-later
# Before cpack packs the files that it has installed: writes the package's changelog, and gives every file the time
# SOURCE_DATE_EPOCH, so that the same sources make the same bytes.
set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY})
set(documents ${root}/usr/share/doc/isoscope)
# TIMESTAMP follows SOURCE_DATE_EPOCH.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${documents}/changelog "isoscope (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * What is new stands in NEWS.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
file(COPY_FILE ${CPACK_ISOSCOPE_CHANGES} ${documents}/NEWS)
execute_process(COMMAND gzip -9nf ${documents}/changelog ${documents}/NEWS COMMAND_ERROR_IS_FATAL ANY)
if(DEFINED ENV{SOURCE_DATE_EPOCH})
  execute_process(COMMAND find ${root} -exec touch -h -d @$ENV{SOURCE_DATE_EPOCH} {} +
    COMMAND_ERROR_IS_FATAL ANY)
endif()
