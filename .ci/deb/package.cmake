# `cpack` makes Debian packages: impulse, libimpulse-engine-dev and libimpulse-render-dev. Two builds
# of the same sources make the same bytes (.ci/package).
find_program(IMPULSE_DPKG dpkg-deb)
if(NOT IMPULSE_DPKG OR NOT TARGET impulse)
  return()
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME impulse)
set(CPACK_PACKAGE_CONTACT "The maintainers of impulse <maintainers@impulse.invalid>" CACHE STRING
    "the maintainer named in the packages")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
    GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE impulse)
set(CPACK_COMPONENTS_ALL engine render program)

# A part of .github/CHANGELOG.md, as Debian writes it, and its date, which all packed files get.
set(log ${PROJECT_SOURCE_DIR}/.github/CHANGELOG.md)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${log})
file(READ ${log} changes)
if(NOT changes MATCHES "\n## ${PROJECT_VERSION} \\(([-0-9]+)\\)\n")
  message(FATAL_ERROR "${log} has no part '## ${PROJECT_VERSION} (YEAR-MONTH-DAY)': add it")
endif()
set(date ${CMAKE_MATCH_1})
string(REGEX REPLACE "^.*\n## ${PROJECT_VERSION} [^\n]*\n+" "" changes "${changes}")
string(REGEX REPLACE "\n+(## .*)?$" "" changes "${changes}")
string(REPLACE "\n" "\n  " changes "  ${changes}")
function(date_as format out)  # as `date` takes a format
  execute_process(COMMAND date --utc --date=${date} ${format} OUTPUT_VARIABLE text
                  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(${out} "${text}" PARENT_SCOPE)
endfunction()
date_as(--rfc-email mail_date)
date_as(+%s seconds)
set(IMPULSE_CHANGES ${PROJECT_BINARY_DIR}/debian-changelog)
file(CONFIGURE OUTPUT ${IMPULSE_CHANGES} @ONLY CONTENT
     "impulse (@PROJECT_VERSION@) unstable; urgency=medium\n\n@changes@\n\n -- @CPACK_PACKAGE_CONTACT@  @mail_date@\n")

set(CPACK_DEBIAN_ENGINE_PACKAGE_NAME libimpulse-engine-dev)
set(CPACK_DEBIAN_ENGINE_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_ENGINE_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), libqhull-dev")
set(CPACK_DEBIAN_ENGINE_DESCRIPTION "rigid bodies by sequential impulses (C++ library)
Headers, static libraries, CMake and pkg-config files of a 3-D rigid-body
engine. A program gets the same bits with every compiler and any number of
threads.")
set(CPACK_DEBIAN_RENDER_PACKAGE_NAME libimpulse-render-dev)
set(CPACK_DEBIAN_RENDER_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_RENDER_PACKAGE_DEPENDS
    "libimpulse-engine-dev (= ${PROJECT_VERSION}), libeigen3-dev (>= 3.4), libdeflate-dev, libegl-dev")
set(CPACK_DEBIAN_RENDER_PACKAGE_RECOMMENDS "libosmesa6 | libgl1-mesa-dri, ffmpeg")
set(CPACK_DEBIAN_RENDER_DESCRIPTION "pictures and films without a display (C++ library)
Headers, a static library, CMake and pkg-config files of a renderer that draws
frames to PNG and film files without a display or a GPU.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME impulse)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# The driver is loaded with the first picture, where dpkg-shlibdeps does not see it.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libosmesa6 | libgl1-mesa-dri")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS ffmpeg)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "chromium, libimpulse-engine-dev (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "rigid bodies from a scene file, filmed without a display
One command turns a scene file (bodies, joints, a camera) into a film, on a
server or in a CI job, without a GPU. It draws impulses as arrows and charts
below the film, compares settings, exports motions, and tests simulations
against saved pictures and states.")
# All files get the date of the version, and CPack reads it where it packs.
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_BINARY_DIR}/cpack-settings.cmake)
file(WRITE ${CPACK_PROJECT_CONFIG_FILE} "if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  set(ENV{SOURCE_DATE_EPOCH} ${seconds})
endif()
set(IMPULSE_CHANGES ${IMPULSE_CHANGES})
set(IMPULSE_NOTICES ${PROJECT_BINARY_DIR}/demos/licenses.txt)
")
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/prepare.cmake)
include(CPack)
