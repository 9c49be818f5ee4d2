# cmake -DOUT=scene.dict -DDIR=demos/scene -P dictionary.cmake
# Writes the format's words for the fuzzer: quoted words of the reader's sources, and TOML syntax.
file(GLOB files ${DIR}/read_*.cpp ${DIR}/repeat.cpp ${DIR}/reader.cpp ${DIR}/joint_kinds.cpp
     ${DIR}/expression.cpp)
set(words "")
foreach(file ${files})
  file(STRINGS ${file} lines REGEX "\"[a-z][a-z_-]*\"")
  foreach(line IN LISTS lines)
    string(REGEX MATCHALL "\"[a-z][a-z_-]*\"" found "${line}")
    list(APPEND words ${found})
  endforeach()
endforeach()
list(REMOVE_DUPLICATES words)
list(SORT words)
list(LENGTH words count)
if(count LESS 100)
  message(FATAL_ERROR "only ${count} words of the format found in ${DIR}; has the reader moved?")
endif()
list(JOIN words "\n" text)
file(WRITE ${OUT} "${text}
\"#--set \"
\" = \"
\"[[\"
\"]]\"
\"{i}\"
\"{i+1}\"
\"{j}\"
\"{2*i+j}\"
\"i * tau / n\"
\"hash(i)\"
\"values\"
\"include\"
\"inf\"
\"nan\"
\"1e999\"
\"-0.0\"
\"1e-320\"
\"9223372036854775807\"
\"0x7fffffff\"
\"true\"
\"1979-05-27\"
\"'''\"
\"\\\\u001b\"
\"\\x1b\"
\"\\xc2\\x9b\"
\"\\xff\\xfe\"
\"\\x00\"
")
