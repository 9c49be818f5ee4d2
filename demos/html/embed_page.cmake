# cmake -DOUT=report_page_text.cpp -DDIR=demos/regression/page -DPAGE=report -DTITLE="impulse test"
#       -DSCRIPTS=a,b,c [-DIMAGES="data: file:"] -P embed_page.cmake
# Writes a source file with reportPageText(): the page's text before and after @data@. The page is page.html
# with report.html as its body, page.css and report.css as its style, and make.js and then the scripts in the
# given order, which is that of their dependencies.
# IMAGES: allowed sources of pictures (Content-Security-Policy: img-src); default: none.
# If the page's html begins with <!doctype, it is the whole page, and its own style the only one.
cmake_policy(VERSION 3.25)  # "@style@" is text, not a variable
include(${CMAKE_CURRENT_LIST_DIR}/text_pieces.cmake)
if(NOT IMAGES)
  set(IMAGES "'none'")
endif()
string(REPLACE "," ";" scripts "${SCRIPTS}")
file(READ ${CMAKE_CURRENT_LIST_DIR}/page.html page)
file(READ ${CMAKE_CURRENT_LIST_DIR}/page.css style)
file(READ ${DIR}/${PAGE}.css own)
file(READ ${DIR}/${PAGE}.html body)
string(STRIP "${body}" body)
if(body MATCHES "^<!doctype")
  set(page "${body}")
  set(style "")
endif()
file(READ ${CMAKE_CURRENT_LIST_DIR}/make.js script)
string(APPEND script "\n")
foreach(name ${scripts})
  file(READ ${DIR}/${name}.js text)
  string(APPEND script "${text}\n")
endforeach()
if(TITLE)
  string(REPLACE "@title@" "${TITLE}" page "${page}")
endif()
string(REPLACE "@images@" "${IMAGES}" page "${page}")
string(REPLACE "@style@" "${style}${own}" page "${page}")
string(REPLACE "@body@" "${body}" page "${page}")
string(REPLACE "@script@" "${script}" page "${page}")

string(FIND "${page}" "@data@" mark)
string(SUBSTRING "${page}" 0 ${mark} head)
math(EXPR mark "${mark} + 6")
string(SUBSTRING "${page}" ${mark} -1 tail)
pieces_of("${head}" "                             " "," head)
pieces_of("${tail}" "                             " "," tail)
file(WRITE ${OUT} "// Made by embed_page.cmake of the page's sources; change those.
#include \"demos/text/page_text.h\"

namespace demos {

PageText ${PAGE}PageText() {
    PageText text;
    for (const char* piece : {${head}
                             \"\"})
        text.before += piece;
    for (const char* piece : {${tail}
                             \"\"})
        text.after += piece;
    return text;
}

}  // namespace demos
")
