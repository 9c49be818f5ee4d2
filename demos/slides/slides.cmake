# Additional dependencies of `impulse slides`: CommonMark, its page, a math font.
pkg_check_modules(CMARK REQUIRED IMPORTED_TARGET libcmark)
embed_page(slides slides "" "" state,fit,film,show,speaker,keys,pointer,start)

# A font for the formulas of slides, reduced to what formulas use. Without it they are drawn in the
# reader's own mathematical font.
set(IMPULSE_MATH_FONT /usr/share/texmf/fonts/opentype/public/tex-gyre-math/texgyrepagella-math.otf
    CACHE FILEPATH "the OpenType math font embedded in pages of slides")
find_program(IMPULSE_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(IMPULSE_PYTHON NAMES python3)
if(NOT EXISTS ${IMPULSE_MATH_FONT})
  message(STATUS "No font at ${IMPULSE_MATH_FONT} (fonts-texgyre-math): slides embed none for formulas")
else()
  execute_process(COMMAND ${IMPULSE_PYTHON} -c "import brotli, fontTools.subset"
                  RESULT_VARIABLE no_font_tools OUTPUT_QUIET ERROR_QUIET)
  if(no_font_tools)
    message(STATUS "No fontTools (python3-fonttools, python3-brotli): slides embed no font for formulas")
  else()
    set(math_font ${CMAKE_CURRENT_BINARY_DIR}/math_font.cpp)
    target_compile_definitions(demos_slides PRIVATE IMPULSE_HAVE_MATH_FONT)
    add_custom_command(
      OUTPUT ${math_font}
      COMMAND ${IMPULSE_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/slides/embed_math_font.py
              ${IMPULSE_MATH_FONT} ${math_font}
      DEPENDS slides/embed_math_font.py ${IMPULSE_MATH_FONT})
    impulse_made(slides ${math_font})
  endif()
endif()
target_link_libraries(demos_slides PRIVATE pugixml::pugixml PkgConfig::CMARK)
