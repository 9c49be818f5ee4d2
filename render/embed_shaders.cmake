# cmake -DOUT=shaders.cpp -DDIR=render/shaders -P embed_shaders.cmake
# Writes every file of DIR as text into one source file; included parts (.glsl) are inserted.
file(GLOB files ${DIR}/*.vert ${DIR}/*.frag)
list(SORT files)
set(cases "")
foreach(file ${files})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  foreach(depth RANGE 2)  # a part may include others
    string(REGEX MATCHALL "#include \"[a-z_]+\\.glsl\"" includes "${text}")
    foreach(include ${includes})
      string(REGEX REPLACE "#include \"(.*)\"" "\\1" part "${include}")
      file(READ ${DIR}/${part} body)
      string(REPLACE "${include}" "${body}" text "${text}")
    endforeach()
  endforeach()
  string(APPEND cases "    if (name == \"${name}\") return R\"glsl(${text})glsl\";\n")
endforeach()
file(WRITE ${OUT} "#include \"render/shaders.h\"\n\nnamespace render {\n\nconst char* shaderText(const std::string& name) {\n${cases}    return \"\";\n}\n\n}  // namespace render\n")
