# cmake -DOUT=mjcf.dict -DDIR=demos/mjcf -P mjcf_dictionary.cmake
# Writes MJCF's words for the fuzzer: all words of vocabulary.cpp, and XML syntax.
file(STRINGS ${DIR}/vocabulary.cpp lines REGEX "\"[a-z]")
set(words "")
foreach(line IN LISTS lines)
  string(REGEX MATCHALL "[a-z][a-z0-9_]+" found "${line}")
  list(APPEND words ${found})
endforeach()
list(REMOVE_DUPLICATES words)
list(SORT words)
list(LENGTH words count)
if(count LESS 100)
  message(FATAL_ERROR "only ${count} words of MJCF found in ${DIR}; has the vocabulary moved?")
endif()
list(TRANSFORM words REPLACE "(.+)" "\"\\1\"")
list(JOIN words "\n" text)
file(WRITE ${OUT} "${text}
\"='\"
\"='0 0 1'\"
\"='1'\"
\"/>\"
\"</\"
\"<!--\"
\"<![CDATA[\"
\"&lt;\"
\"1e999\"
\"nan\"
\"1e-320\"
\"-0.0\"
\"hinge\"
\"slide\"
\"ball\"
\"capsule\"
\"cylinder\"
\"ellipsoid\"
\"plane\"
\"\\xff\\xfe\"
\"\\x00\"
")
