# impulse_add_snapshot_test(NAME name SCENES scene... [BASELINES folder] [RESULTS folder]
#                           [UPDATE none|missing|changed|all] [REPRODUCIBLE] [SET key=value...]
#                           [LABELS label...])
#
# A test, `name`, that plays the scenes and compares them with their baselines: `impulse test`.
#   SCENES        scene files, folders of them, names of built-in scenes
#   BASELINES     where the baselines are; beside each scene unless given
#   RESULTS       for report.html, report.json, junit.xml and the pictures;
#                 snapshots/NAME of the binary folder unless given
#   UPDATE        which baselines it may write; none unless given, as a test leaves sources alone
#   REPRODUCIBLE  the same pixels on every x86-64 processor
#   SET           values to set in every scene
#   LABELS        for ctest -L, besides `snapshot`
# Scenes and baselines are relative to the current source folder, results to the binary folder. The
# test runs alone, as it takes all processors by itself.
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

# Of the caller's ARG_...: stops where something is missing, unknown or not there.
function(_impulse_check_snapshot_test)
  if(NOT DEFINED ARG_NAME)
    _impulse_refuse("NAME is missing; write NAME and what ctest shall call the test")
  endif()
  if(DEFINED ARG_UNPARSED_ARGUMENTS)
    list(GET ARG_UNPARSED_ARGUMENTS 0 word)
    _impulse_refuse("'${word}' is no keyword here; there are NAME, SCENES, BASELINES, RESULTS, \
UPDATE, REPRODUCIBLE, SET and LABELS")
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
    if(NOT EXISTS ${path} AND NOT scene MATCHES "^[a-z0-9-]+$")  # which a built-in scene may be
      _impulse_refuse("SCENES has '${scene}', and there is no file or folder ${path}")
    endif()
  endforeach()
endfunction()

function(_impulse_refuse what)
  message(FATAL_ERROR "impulse_add_snapshot_test(${ARG_NAME}): ${what}")
endfunction()
