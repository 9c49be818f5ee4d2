# impulse_add_snapshot_test(NAME name SCENES scene... [BASELINES folder] [RESULTS folder]
#                           [UPDATE none|missing|changed|all] [REPRODUCIBLE] [SET key=value...]
#                           [LABELS label...])
#
# Adds a test, `name`, that runs the scenes and compares them with their baselines (`impulse test`).
#   SCENES        scene files, folders of scene files, names of built-in scenes
#   BASELINES     folder of the baselines; default: next to each scene
#   RESULTS       folder of report.html, report.json, junit.xml and the pictures;
#                 default: snapshots/NAME in the binary folder
#   UPDATE        which baselines it may write; default: none, as a test does not write into sources
#   REPRODUCIBLE  the same pixels on every x86-64 processor
#   SET           values to set in every scene
#   LABELS        for ctest -L, in addition to `snapshot`
# Scenes and baselines are relative to the current source folder, results to the binary folder. The
# test runs alone, as it uses all processors by itself.
function(impulse_add_snapshot_test)
  cmake_parse_arguments(PARSE_ARGV 0 ARG
    "REPRODUCIBLE" "NAME;BASELINES;RESULTS;UPDATE" "SCENES;SET;LABELS")
  _impulse_check_snapshot_test()
  set(options "")
  foreach(setting IN LISTS ARG_SET)
    list(APPEND options --set ${setting})
  endforeach()
  if(ARG_REPRODUCIBLE)
    list(APPEND options --reproducible)
  endif()
  if(DEFINED ARG_BASELINES)
    list(APPEND options --baselines ${ARG_BASELINES})
  endif()
  if(NOT DEFINED ARG_UPDATE)
    set(ARG_UPDATE none)
  endif()
  if(NOT DEFINED ARG_RESULTS)
    set(ARG_RESULTS snapshots/${ARG_NAME})
  endif()
  cmake_path(ABSOLUTE_PATH ARG_RESULTS BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)
  add_test(NAME ${ARG_NAME} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
           COMMAND impulse::impulse test ${ARG_SCENES} -o ${ARG_RESULTS} --update ${ARG_UPDATE}
                   ${options})
  list(PREPEND ARG_LABELS snapshot)
  set_tests_properties(${ARG_NAME} PROPERTIES LABELS "${ARG_LABELS}" RUN_SERIAL TRUE)
endfunction()

# Checks the caller's ARG_...: fails if one is missing or unknown, or if a scene does not exist.
function(_impulse_check_snapshot_test)
  if(NOT DEFINED ARG_NAME)
    _impulse_refuse("NAME is missing; write NAME and the name of the test")
  endif()
  if(DEFINED ARG_UNPARSED_ARGUMENTS)
    list(GET ARG_UNPARSED_ARGUMENTS 0 word)
    _impulse_refuse("'${word}' is not a keyword; the keywords are NAME, SCENES, BASELINES, \
RESULTS, UPDATE, REPRODUCIBLE, SET and LABELS")
  endif()
  if(DEFINED ARG_KEYWORDS_MISSING_VALUES)
    list(GET ARG_KEYWORDS_MISSING_VALUES 0 word)
    _impulse_refuse("${word} has no value; leave it out or give one")
  endif()
  if(NOT DEFINED ARG_SCENES)
    _impulse_refuse("SCENES is missing; write SCENES and scene files, folders or built-in names")
  endif()
  set(updates none missing changed all)
  if(DEFINED ARG_UPDATE AND NOT ARG_UPDATE IN_LIST updates)
    _impulse_refuse("UPDATE is '${ARG_UPDATE}'; it may be none, missing, changed or all")
  endif()
  foreach(setting IN LISTS ARG_SET)
    if(NOT setting MATCHES "^[^=]+=.")
      _impulse_refuse("SET has '${setting}'; it takes key=value, such as solver.sweeps=20")
    endif()
  endforeach()
  foreach(scene IN LISTS ARG_SCENES)
    cmake_path(ABSOLUTE_PATH scene BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE path)
    if(NOT EXISTS ${path} AND NOT scene MATCHES "^[a-z0-9-]+$")  # it may be a built-in scene
      _impulse_refuse("SCENES has '${scene}', but there is no file or folder ${path}")
    endif()
  endforeach()
endfunction()

function(_impulse_refuse what)
  message(FATAL_ERROR "impulse_add_snapshot_test(${ARG_NAME}): ${what}")
endfunction()
