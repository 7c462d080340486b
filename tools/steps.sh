# shellcheck shell=bash
# What ./demo and ./test share; sourced by them from the root of the repository.

# ccache makes the second build quick where it happens to be installed.
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_SLOPPINESS=pch_defines,time_macros; fi

# The lanes of ./demo and ./test: those that every processor has, and the best of this machine.
isas_of_this_machine='baseline;native'

# jobs [MEMINFO]: how many files may be compiled at once: one for each core and for each 1.2 GB of free memory.
jobs() {
  local cores free
  cores=$(nproc)
  free=$(awk '/^MemAvailable:/ { print int($2 / 1200000) }' "${1:-/proc/meminfo}" 2>/dev/null || true)
  [[ -n $free ]] || free=$cores
  echo $((free < 1 ? 1 : free < cores ? free : cores))
}

step() { printf '\n== %s\n' "$*"; }

# quietly LOG COMMAND…: the command's output goes to the log, and is shown only if it fails.
quietly() { logged drain "$@"; }
drain() { cat >/dev/null; }

# building LOG COMMAND…: as quietly, and prints how far ninja is.
building() { NINJA_STATUS='[%f/%t] ' logged progress "$@"; }

# Reads what ninja says: one line that moves on a terminal; elsewhere a line for each quarter.
progress() {
  local line built all quarters=0
  while IFS= read -r line; do
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\  ]] || continue
    built=${BASH_REMATCH[1]} all=${BASH_REMATCH[2]}
    if [[ -t 1 ]]; then
      printf '\r\033[Kbuilding %d of %d files' "$built" "$all"
    elif ((4 * built / all > quarters)); then
      quarters=$((4 * built / all))
      echo "built $built of $all files"
    fi
  done
  [[ ! -t 1 ]] || printf '\r\033[K'
}

# logged READER LOG COMMAND…: the command's output goes to the log and to a function that reads it; all of it is shown if it fails.
logged() {
  local reader=$1 log=$2 start code=0
  shift 2
  start=$(wc -c <"$log")
  "$@" 2>&1 </dev/null | tee -a "$log" | "$reader" || code=${PIPESTATUS[0]}
  [[ $code -eq 0 ]] || { tail -c "+$((start + 1))" "$log" >&2; echo "failed ($code): $*" >&2; }
  return "$code"
}
