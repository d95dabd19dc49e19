# Completion of beadmesh for bash. Verbs and options are asked of the program, so that they are those of its version.

_beadmesh_options() {
  "$1" ${2:+"$2"} --help 2>/dev/null | grep -oE '^  (-[a-z],)?--[a-z][a-z-]*' | grep -oE -- '--[a-z-]+'
}

_beadmesh_verbs() {
  "$1" --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p'
}

# Folders, and files with one of the endings.
_beadmesh_files() {
  local word=$1 name
  shift
  while IFS= read -r name; do
    if [[ -d $name ]]; then
      COMPREPLY+=("$name/")
    else
      local ending
      for ending in "$@"; do
        if [[ ${name,,} == *".$ending" ]]; then COMPREPLY+=("$name"); fi
      done
    fi
  done < <(compgen -f -- "$word")
  compopt -o nospace -o filenames 2>/dev/null
}

_beadmesh() {
  local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} verb= k
  COMPREPLY=()
  for ((k = 1; k < COMP_CWORD; ++k)); do
    if [[ ${COMP_WORDS[k]} != -* ]]; then
      verb=${COMP_WORDS[k]}
      break
    fi
  done
  case $before in
    --preset) COMPREPLY=($(compgen -W "crash nvh durability" -- "$word")); return ;;
    --method) COMPREPLY=($(compgen -W "automatic blocks ridge face" -- "$word")); return ;;
    --analysis) COMPREPLY=($(compgen -W "modes none" -- "$word")); return ;;
    --unit) COMPREPLY=($(compgen -W "mm cm m um in ft" -- "$word")); return ;;
    -o | --output) _beadmesh_files "$word" bdf nas dat k key inp vtu msh stl; return ;;
    --config) _beadmesh_files "$word" toml; return ;;
    --json) _beadmesh_files "$word" json; return ;;
    --csv) _beadmesh_files "$word" csv; return ;;
    --report) _beadmesh_files "$word" html svg; return ;;
    --svg | --debug-svg) _beadmesh_files "$word" svg; return ;;
  esac
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$(_beadmesh_options "$program" "$verb")" -- "$word"))
  elif [[ -z $verb ]]; then
    COMPREPLY=($(compgen -W "$(_beadmesh_verbs "$program")" -- "$word"))
  elif [[ $verb == check ]]; then
    _beadmesh_files "$word" bdf nas dat k key inp
  else
    _beadmesh_files "$word" step stp iges igs brep stl wkt poly bdf nas dat k key inp obj ply toml txt csv
  fi
}

complete -F _beadmesh beadmesh
