# Turns the project's comments into Doxygen's form, line by line, so that line numbers stay right.
# - Units follow a member as `// m` and continue in comment lines below it: both document all
#   members that the line declares.
# - A member named like its type (`Camera camera`, `std::vector<Rod> rods`) refers to its type.
# - Comparisons that are = default get a standard text.

# The declarators of a line as `a /**< text */, b /**< text */;`: commas in brackets do not count.
function documented(code, text,    i, c, depth, out) {
    for (i = 1; i <= length(code); ++i) {
        c = substr(code, i, 1)
        if (c ~ /[({<[]/) ++depth
        if (c ~ /[)}>\]]/) --depth
        if (depth == 0 && (c == "," || c == ";")) out = out " /**< " text " */"
        out = out c
    }
    return out
}
function isCalledLikeItsType(code,    words, type, name) {
    if (code !~ /^ +(std::vector<)?[A-Z][A-Za-z]*>? [a-z][A-Za-z]*( = [^;]*|\{[^;]*\})?;$/) return 0
    split(code, words, / +/)
    type = tolower(words[2])
    name = tolower(words[3])
    sub(/[;{=].*/, "", name)
    if (sub(/^std::vector</, "", type)) sub(/s$/, "", name)
    sub(/>$/, "", type)
    return substr(type, length(type) - length(name) + 1) == name
}

/^ *\/\/ / && goesOn { sub(/\/\//, "///<"); print; next }
{ goesOn = 0 }
/operator(<=>|==)\(.*= default;/ { print $0 "  ///< member by member"; next }
/[;}] +\/\/ / || /^ +[a-z][A-Za-z]*,? +\/\/ / {
    at = match($0, / +\/\/ /)
    code = substr($0, 1, at - 1)
    text = substr($0, at + RLENGTH)
    # The last one gets `///<`, which the lines below may continue.
    n = code ~ /;$/ && code !~ /\(/ ? split(documented(code, text), pieces, / \/\*\*< /) : 0
    if (n > 2) print documented(code, text)
    else print code "  ///< " text
    goesOn = n <= 2
    next
}
isCalledLikeItsType($0) { print $0 "  ///< see its type"; next }
{ print }
