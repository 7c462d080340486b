# shellcheck shell=bash
# What ./demo and ./test share; sourced by them from the root of the repository.

# ccache makes the second build quick where it happens to be installed.
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_SLOPPINESS=pch_defines,time_macros; fi

step() { printf '\n== %s\n' "$*"; }

# quietly LOG COMMAND…: the command's output goes to the log, and is shown only if it fails.
quietly() {
  local log=$1 start code=0
  shift
  start=$(wc -c <"$log")
  "$@" >>"$log" 2>&1 </dev/null || code=$?
  [[ $code -eq 0 ]] || { tail -c "+$((start + 1))" "$log" >&2; echo "failed ($code): $*" >&2; }
  return $code
}
