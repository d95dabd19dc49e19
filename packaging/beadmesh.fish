# Completion of beadmesh for fish: verbs and options as the program lists them, else files.

function __beadmesh_verb
    set -l words (commandline -opc)
    test (count $words) -gt 1; and string match -v -- '-*' $words[2]
end

function __beadmesh_options
    beadmesh (__beadmesh_verb) --help 2>/dev/null | string match -rg -- '^  (?:-[a-z],)?(--[a-z][a-z-]*)'
end

complete -c beadmesh -f -n 'not __beadmesh_verb' \
    -a "(beadmesh --help 2>/dev/null | sed -n '/^Subcommands:/,/^\$/s/^  \([a-z][a-z-]*\) .*/\1/p')"
complete -c beadmesh -n 'string match -q -- "-*" (commandline -ct)' -f -a '(__beadmesh_options)'
