# Turns the lines of `impulse test --self-test --json` into a table: the effect of each mutant over all
# pictures that it changes.
function field(name,    value) {
    if (!match($0, "\"" name "\":(\"[^\"]*\"|[^,}]*)")) return ""
    value = substr($0, RSTART + length(name) + 3, RLENGTH - length(name) - 3)
    gsub(/"/, "", value)
    return value
}

/"mutant":/ {
    mutant = field("mutant")
    scene = mutant SUBSEP field("scene")
    if (!(mutant in pictures)) { order[++mutants] = mutant; pictures[mutant] = 0 }
    if (field("unchanged") == "true") next
    if (!(scene in seen)) { seen[scene] = 0; ++scenes[mutant] }
    state = field("state") == "true"
    picture = field("picture") == "true"
    if ((state || picture) && !seen[scene]++) ++caught[mutant]
    byState[mutant] += state
    byPicture[mutant] += picture
    window = field("window") + 0
    ssim = field("ssim") + 0
    if (!pictures[mutant]++ || window < leastWindow[mutant]) leastWindow[mutant] = window
    if (pictures[mutant] == 1 || ssim > largestSsim[mutant]) largestSsim[mutant] = ssim
}

END {
    print "Damage: of the pictures that a mutant changes, how many are noticed, and the smallest change."
    print ""
    print "| mutant | scenes caught | pictures | state notices | gate notices | least window | largest SSIM |"
    print "| --- | --: | --: | --: | --: | --: | --: |"
    for (i = 1; i <= mutants; ++i) {
        m = order[i]
        printf "| %s | %d of %d | %d | %d | %d | %d | %.4f |\n", m, caught[m], scenes[m],
               pictures[m], byState[m], byPicture[m], leastWindow[m], largestSsim[m]
    }
}
