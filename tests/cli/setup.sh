# The start of each script of this folder: `source "$(dirname "$0")/setup.sh"`, those of its folders
# with `../setup.sh`. Leaves them in the project's folder with `jaywalk` on the path and $scratch, an
# empty folder.
set -euo pipefail
PATH="$(dirname "$(realpath "$1")"):$PATH"
export NO_COLOR=1
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# skip REASON: ends the script; ctest says that the test was skipped.
skip() {
  echo "SKIPPED: $*" >&2
  exit 77
}

# expect CODE COMMAND...: runs the command, with a limit of 60 s (JAYWALK_LIMIT); its output is in $output. CODE
# may be `any`: 0 or 1.
expect() {
  local wanted=$1 code=0
  shift
  output=$(timeout "${JAYWALK_LIMIT:-60}" "$@" 2>&1 </dev/null) || code=$?
  [[ $code == "$wanted" || $wanted$code == any[01] ]] || fail "exit $code, expected $wanted: $*"$'\n'"$output"
}

# contains TEXT: the last output has it.
contains() {
  [[ $output == *"$1"* ]] || fail "no '$1' in:"$'\n'"$output"
}

# change OPTION VALUE COMMAND...: leaves the command in $changed, the option's value in it replaced.
change() {
  local option=$1 value=$2
  shift 2
  changed=()
  while (($#)); do
    changed+=("$1")
    [[ $1 != "$option" ]] || { changed+=("$value") && shift; }
    shift
  done
}
