# Turns the peers' JSON lines (one flat object per line) into two Markdown tables.
# Columns and rows are in the order in which they first appear.

function field(name,    value) {
    if (!match($0, "\"" name "\":(\"[^\"]*\"|[^,}]*)")) return ""
    value = substr($0, RSTART + length(name) + 3, RLENGTH - length(name) - 3)
    gsub(/"/, "", value)
    return value
}

# Appends to the list of values of a cell and name; a cell is a scene and a column.
function note(cell, name) {
    if (field(name) != "") values[cell, name] = values[cell, name] " " field(name)
}

function median(cell, name,    list, n, i, k, swap) {
    n = split(values[cell, name], list, " ")
    for (i = 2; i <= n; ++i)
        for (k = i; k > 1 && list[k] + 0 < list[k - 1] + 0; --k) {
            swap = list[k]; list[k] = list[k - 1]; list[k - 1] = swap
        }
    return n ? list[int(n / 2) + 1] : ""
}

# " (cut at 3.1 of 10 s)" where the budget or the engine ended a run early; all scenes step at 60 Hz
function cut(done, all) {
    return done == "" || done + 0 >= all + 0 ? "" : \
        sprintf(" (cut at %.3g of %.3g s)", done / 60, all / 60)
}

function milliseconds(cell) {
    if (median(cell, "cpu_last_ms") == "") return "-"
    return sprintf("%.3g / %.3g", median(cell, "cpu_first_ms"), median(cell, "cpu_last_ms")) \
        cut(median(cell, "cost_steps"), steps[cell])
}

function isCut(cell) { return median(cell, "cost_steps") + 0 < steps[cell] + 0 }

# Cut runs end at different moments of the scene: their ratio is only a guess.
function ratio(cell, other) {
    if (median(cell, "cpu_last_ms") + 0 <= 0 || median(other, "cpu_last_ms") == "") return "-"
    return sprintf("%.3g", median(other, "cpu_last_ms") / median(cell, "cpu_last_ms")) \
        (isCut(cell) || isCut(other) ? "?" : "")
}

function perPoint(cell) {
    return values[cell, "ns_per_point"] == "" ? "-" : sprintf("%.0f", median(cell, "ns_per_point"))
}

function heads(prefix, from,    c, text) {
    for (c = from; c <= columnCount; ++c) text = text " " prefix columns[c] " |"
    return text
}

function rules(count,    text) {
    while (count-- > 0) text = text " --- |"
    return "|" text
}

function costTable(    s, c, first, cell, times, ratios, points) {
    print "| scene |" heads("", 1) heads("x ", 2) heads("ns ", 1)
    print rules(3 * columnCount)
    for (s = 1; s <= sceneCount; ++s) {
        times = ratios = points = ""
        first = scenes[s] SUBSEP columns[1]
        for (c = 1; c <= columnCount; ++c) {
            cell = scenes[s] SUBSEP columns[c]
            times = times " " milliseconds(cell) " |"
            if (c > 1) ratios = ratios " " ratio(cell, first) " |"
            points = points " " perPoint(cell) " |"
        }
        print "| " scenes[s] " |" times ratios points
    }
}

function qualityTable(    s, c, cell, line) {
    print "| scene |" heads("", 1)
    print rules(1 + columnCount)
    for (s = 1; s <= sceneCount; ++s) {
        line = "| " scenes[s] " |"
        for (c = 1; c <= columnCount; ++c) {
            cell = scenes[s] SUBSEP columns[c]
            line = line " " (cell in verdict ? verdict[cell] : "-") " |"
        }
        print line
    }
}

{
    column = field("engine") " " field("preset")
    sub(/ default$/, "", column)
    scene = field("scene")
    cell = scene SUBSEP column
    if (!(column in seenColumn)) { seenColumn[column]; columns[++columnCount] = column }
    if (!(scene in seenScene)) { seenScene[scene]; scenes[++sceneCount] = scene }
    steps[cell] = field("steps")
    if (field("verdict") != "")
        verdict[cell] = field("verdict") cut(field("quality_steps"), field("steps"))
    note(cell, "cpu_first_ms"); note(cell, "cpu_last_ms")
    note(cell, "ns_per_point"); note(cell, "cost_steps")
}

END {
    print "\nMilliseconds of processor time a step, first / last two seconds; x: the cost of"
    print columns[1] " over that engine's, with a ? where a run was cut; ns: per contact point"
    print "in scenes without joints (both: last two seconds).\n"
    costTable()
    print "\nQuality, measured from the poses in the same way for all: the worst of the whole run,"
    print "except drift and penetration, which are at its end.\n"
    qualityTable()
}
