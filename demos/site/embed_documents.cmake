# cmake -DOUT=documents.cpp -DROOT=... -DFILES=README.md,demos/README.md,... -P embed_documents.cmake
# Writes these files, paths below ROOT, into one source file, sorted by path.
include(${CMAKE_CURRENT_LIST_DIR}/../html/text_pieces.cmake)
string(REPLACE "," ";" files "${FILES}")
list(SORT files)
set(rows "")
foreach(path ${files})
  if(path MATCHES "\\.png$")
    file(READ ${ROOT}/${path} bytes HEX)
    string(LENGTH "${bytes}" size)
    math(EXPR size "${size} / 2")
    string(REGEX REPLACE "(........................................)" "\\1\"\n     \"" bytes "${bytes}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
    string(APPEND rows "    {\"${path}\", {\n     \"${bytes}\", ${size}}},\n")
  else()
    file(READ ${ROOT}/${path} text)
    pieces_of("${text}" "     " "" pieces)
    string(APPEND rows "    {\"${path}\",${pieces}},\n")
  endif()
endforeach()
file(WRITE ${OUT} "// Made by embed_documents.cmake of the READMEs; change those files.
#include \"demos/site/documents.h\"

namespace demos {

std::span<const SiteDocument> documents() {
    static constexpr SiteDocument kDocuments[] = {
${rows}    };
    return kDocuments;
}

}  // namespace demos
")
