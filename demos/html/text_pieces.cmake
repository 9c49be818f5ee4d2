# Splits a text into raw string literals, each between `before` and `after`: a compiler need not accept
# literals above 64 KiB (C++ [implimits]).
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
