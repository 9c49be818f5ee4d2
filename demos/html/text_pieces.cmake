# Splits a text into raw string literals, each between `before` and `after`: a compiler need not accept
# literals above 64 KiB (C++ [implimits]).
function(pieces_of text before after out)
  set(pieces "")
  string(LENGTH "${text}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 8000 piece)
    string(FIND "${piece}" "\n" end REVERSE)  # not within a letter of several bytes
    if(end GREATER 0)
      math(EXPR end "${end} + 1")
      string(SUBSTRING "${piece}" 0 ${end} piece)
    endif()
    string(LENGTH "${piece}" size)
    string(APPEND pieces "\n${before}R\"piece(${piece})piece\"${after}")
    math(EXPR at "${at} + ${size}")
  endwhile()
  set(${out} "${pieces}" PARENT_SCOPE)
endfunction()
