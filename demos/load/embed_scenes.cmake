# cmake -DOUT=builtin.cpp -DDIR=demos/scenes -P embed_scenes.cmake
# Writes every *.toml of DIR as text into one source file, sorted by name.
include(${CMAKE_CURRENT_LIST_DIR}/../html/text_pieces.cmake)
file(GLOB names RELATIVE ${DIR} ${DIR}/*.toml)
list(TRANSFORM names REPLACE "\\.toml$" "")  # before sorting: "-" comes before "."
list(SORT names)
set(rows "")
foreach(name ${names})
  file(READ ${DIR}/${name}.toml text)
  pieces_of("${text}" "     " "" pieces)
  string(APPEND rows "    {\"${name}\",${pieces}},\n")
endforeach()
file(WRITE ${OUT} "// Made by embed_scenes.cmake from demos/scenes; change those files.
#include \"demos/load/builtin.h\"

namespace demos {

std::span<const BuiltinScene> builtinScenes() {
    static constexpr BuiltinScene kScenes[] = {
${rows}    };
    return kScenes;
}

}  // namespace demos
")
