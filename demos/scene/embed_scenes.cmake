# cmake -DOUT=builtin.cpp -DDIR=demos/scenes -P embed_scenes.cmake
# Every *.toml of DIR as text in one source file, sorted by name. A compiler takes a literal of
# 64 KiB at most (C++ [implimits]), so the text is cut in pieces that are put together again.
file(GLOB names RELATIVE ${DIR} ${DIR}/*.toml)
list(TRANSFORM names REPLACE "\\.toml$" "")  # before sorting: "-" comes before "."
list(SORT names)
set(rows "")
foreach(name ${names})
  file(READ ${DIR}/${name}.toml text)
  set(pieces "")
  string(LENGTH "${text}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 8000 piece)
    string(APPEND pieces "\n     R\"toml(${piece})toml\"")
    math(EXPR at "${at} + 8000")
  endwhile()
  string(APPEND rows "    {\"${name}\",${pieces}},\n")
endforeach()
file(WRITE ${OUT} "// Made by embed_scenes.cmake of demos/scenes; change those.
#include \"demos/scene/builtin.h\"

namespace demos {

std::span<const BuiltinScene> builtinScenes() {
    static constexpr BuiltinScene kScenes[] = {
${rows}    };
    return kScenes;
}

}  // namespace demos
")
