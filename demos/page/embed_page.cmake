# cmake -DOUT=report_page_text.cpp -DDIR=demos/regression/page -DPAGE=report -DSCRIPTS=a,b,c
#       -P embed_page.cmake
# report.html with report.css and the scripts put in where it says @style@ and @script@, as text
# before and after @data@: reportPageText(). Scripts in the order in which they build on each other.
# A compiler takes a literal of 64 KiB at most (C++ [implimits]), so the text is cut in pieces.
cmake_policy(VERSION 3.25)  # "@style@" is text, no variable
string(REPLACE "," ";" scripts "${SCRIPTS}")
file(READ ${DIR}/${PAGE}.html page)
file(READ ${DIR}/${PAGE}.css style)
set(script "")
foreach(name ${scripts})
  file(READ ${DIR}/${name}.js text)
  string(APPEND script "${text}\n")
endforeach()
string(REPLACE "@style@" "${style}" page "${page}")
string(REPLACE "@script@" "${script}" page "${page}")

function(pieces_of text out)
  set(pieces "")
  string(LENGTH "${text}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 8000 piece)
    string(APPEND pieces "\n                             R\"page(${piece})page\",")
    math(EXPR at "${at} + 8000")
  endwhile()
  set(${out} "${pieces}" PARENT_SCOPE)
endfunction()

string(FIND "${page}" "@data@" mark)
string(SUBSTRING "${page}" 0 ${mark} head)
math(EXPR mark "${mark} + 6")
string(SUBSTRING "${page}" ${mark} -1 tail)
pieces_of("${head}" head)
pieces_of("${tail}" tail)
file(WRITE ${OUT} "// Made by embed_page.cmake of the page's sources; change those.
#include \"demos/page/page_text.h\"

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
