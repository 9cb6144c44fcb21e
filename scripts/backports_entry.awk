# Turns the machine's own apt source entry for a Debian release into one for the release's backports suite.
#   awk -v uri=URI -v codename=bookworm -v format=deb822|one-line -f backports_entry.awk FILE
# Prints the first enabled binary entry of FILE that has this URI and the plain codename among its suites, with its
# signing key and other options kept; nothing when there is none. The URI decides, since a third party may use
# Debian's codenames too.

function sameUri(a) {
    sub(/\/+$/, "", a)
    return a == uri
}

# Field 1 is "deb", an optional [options] block may hold spaces, then URI, suite, components.
function oneLine(line,    options, fields) {
    sub(/#.*/, "", line)
    if (line !~ /^[ \t]*deb[ \t]/) return ""
    sub(/^[ \t]*deb[ \t]+/, "", line)
    if (match(line, /^\[[^]]*\][ \t]*/)) {
        options = substr(line, 1, RLENGTH)
        line = substr(line, RLENGTH + 1)
        sub(/[ \t]*$/, " ", options)
    }
    split(line, fields, /[ \t]+/)
    if (!sameUri(fields[1]) || fields[2] != codename) return ""
    return "deb " options fields[1] " " codename "-backports main"
}

function hasWord(text, wanted, isUri,    words, n, i) {
    n = split(text, words, /[ \t\n]+/)
    for (i = 1; i <= n; i++) {
        if (isUri ? sameUri(words[i]) : words[i] == wanted) return 1
    }
    return 0
}

# A stanza: a line that starts with a space goes on with the field before it.
function stanza(text,    lines, n, i, name, value, kept) {
    n = split(text, lines, "\n")
    kept = ""
    for (i = 1; i <= n; i++) {
        if (lines[i] ~ /^#/) continue
        if (lines[i] !~ /^[ \t]/) {
            name = tolower(lines[i])
            sub(/:.*/, "", name)
            value[name] = lines[i]
            sub(/^[^:]*:[ \t]*/, "", value[name])
        } else {
            value[name] = value[name] "\n" lines[i]
        }
        if (name !~ /^(types|suites|components|enabled)$/) kept = kept "\n" lines[i]
    }
    if (!hasWord(value["types"], "deb") || tolower(value["enabled"]) ~ /^(no|false|without|off|disable)/) return ""
    if (!hasWord(value["uris"], "", 1) || !hasWord(value["suites"], codename)) return ""
    return "Types: deb\nSuites: " codename "-backports\nComponents: main" kept
}

BEGIN {
    sub(/\/+$/, "", uri)
    if (format == "deb822") RS = ""
}

{
    entry = format == "deb822" ? stanza($0) : oneLine($0)
    if (entry != "") {
        print entry
        exit
    }
}
