# A compiler takes a literal of 64 KiB at most (C++ [implimits]): a text is cut in raw literals, each
# between `before` and `after`.
function(pieces_of text before after out)
  set(pieces "")
  string(LENGTH "${text}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 8000 piece)
    string(APPEND pieces "\n${before}R\"piece(${piece})piece\"${after}")
    math(EXPR at "${at} + 8000")
  endwhile()
  set(${out} "${pieces}" PARENT_SCOPE)
endfunction()
