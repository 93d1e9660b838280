# Sourced by the scripts of this folder: where things are, how they speak.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

say() { printf '\033[1m== %s\033[0m\n' "$*" >&2; }
fail() { printf '%s\n' "$*" >&2; exit 3; }
refuse() { printf '%s: see %s --help\n' "$*" "$0" >&2; exit 2; } # an argument that a script does not know

# Runs a phase, says how long it took, and returns its status. (Within it `set -e` is off: join commands with &&.)
phase() {
  local what=$1 begin=$SECONDS status=0
  shift
  say "$what"
  "$@" || status=$?
  say "$what: $((SECONDS - begin)) s"
  return "$status"
}

# The text between the first line and the first empty line of a script's leading comment is its help.
help_if_asked() {
  case " $* " in
    *' --help '* | *' -h '*) sed -n '2,/^$/s/^# \{0,1\}//p' "$0"; exit 0 ;;
  esac
}

require_writable_checkout() {
  [[ -w . ]] || fail "$root: cannot be written: clone it (git clone '$root' DIR), or build elsewhere (cmake -S '$root' -B DIR)"
}

# Builds a preset, release or sanitize. From nothing it compiles many files at a time, which takes less than half as long; a build folder
# that is there keeps its way, since an edit then costs one file.
configure_and_build() { # PRESET [TARGET...]
  local preset=$1 configured=$1 folder=build
  shift
  require_writable_checkout
  [[ $preset == release ]] || folder=build/$preset
  [[ -e $folder/CMakeCache.txt ]] || configured=$preset-unity
  # A warning is an error where it can be acted on; a newer compiler's new warnings must not stop a user.
  cmake --preset "$configured" -DSTERADIAN_WERROR="${CI:-OFF}" >/dev/null && cmake --build --preset "$preset" ${1:+--target "$@"}
}
