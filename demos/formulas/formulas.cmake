# Dependencies of formulas: KaTeX, run by Duktape, and pugixml for its MathML.
pkg_check_modules(DUKTAPE REQUIRED IMPORTED_TARGET duktape)
set(IMPULSE_KATEX /usr/share/javascript/katex/katex.js CACHE FILEPATH
    "KaTeX as one script, built in for the formulas of slides and captions")
if(NOT EXISTS ${IMPULSE_KATEX})
  message(FATAL_ERROR "no KaTeX at ${IMPULSE_KATEX}: install libjs-katex, set IMPULSE_KATEX, or "
                      "build without slides: -DIMPULSE_SLIDES=OFF")
endif()
configure_file(formulas/katex_text.cpp.in katex_text.cpp @ONLY)
target_sources(demos_formulas PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/katex_text.cpp)
target_link_libraries(demos_formulas PRIVATE pugixml::pugixml PkgConfig::DUKTAPE)
