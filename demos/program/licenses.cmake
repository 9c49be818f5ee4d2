# Joins the notices of all that is compiled in or embedded, taken from the copyright files of its
# Debian packages. `impulse --licenses` prints them, and the package's copyright file holds them.
set(IMPULSE_COPYRIGHT_FILES /usr/share/doc CACHE PATH "where Debian keeps PACKAGE/copyright")
set(notices_of
  "fonts-inter: Inter, the font of pictures"
  "fonts-dejavu-core: DejaVu Sans, its letters for pictures"
  "python3-glad: the OpenGL loader that glad writes"
  "libstb-dev: stb_image_write, stb_truetype" "libeigen3-dev: Eigen" "libcli11-dev: CLI11"
  "libfmt-dev: {fmt}, its headers" "nlohmann-json3-dev: JSON for Modern C++"
  "libtomlplusplus-dev: toml++, its headers" "libtinyobjloader-dev: tinyobjloader, its header")
if(IMPULSE_SLIDES)
  list(APPEND notices_of "libjs-katex: KaTeX, for the formulas of slides")
  if(math_font)
    list(APPEND notices_of "fonts-texgyre-math: TeX Gyre Pagella Math, a part of it, for the formulas of slides")
  endif()
endif()

string(CONCAT text "impulse ${PROJECT_VERSION}\n\n"
  "No licence has been chosen for impulse itself: that is left to its owner.\n\n"
  "The program contains the works below. Their notices are Debian's. The shared libraries that it\n"
  "calls are not part of it and come with their own notices.\n")
foreach(row IN LISTS notices_of)
  string(REGEX MATCH "^([^:]+): (.*)$" matched "${row}")
  set(package ${CMAKE_MATCH_1})
  set(heading "${CMAKE_MATCH_2} (${package})")
  string(LENGTH "${heading}" width)
  string(REPEAT "=" ${width} line)
  string(APPEND text "\n\n${heading}\n${line}\n\n")
  set(file ${IMPULSE_COPYRIGHT_FILES}/${package}/copyright)
  if(EXISTS ${file})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} notice)
    string(APPEND text "${notice}")
  else()
    message(STATUS "No ${file}: impulse --licenses refers to the package ${package}")
    string(APPEND text "See the copyright file of Debian's package ${package}.\n")
  endif()
endforeach()
set(impulse_notices ${CMAKE_CURRENT_BINARY_DIR}/licenses.txt)
file(CONFIGURE OUTPUT ${impulse_notices} CONTENT "@text@" @ONLY)
configure_file(program/licenses.cpp.in licenses.cpp @ONLY)
set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/licenses.cpp PROPERTIES
  OBJECT_DEPENDS ${impulse_notices} SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
target_sources(demos_program PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/licenses.cpp)
