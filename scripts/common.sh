# Shared by the scripts: to be sourced from the root of the project.

# Runs a named step, says how long it took and remembers whether it failed.
failed=()
steps=()
step() {
  local name=$1 start=$SECONDS
  shift
  printf '\n== %s\n' "$name"
  if "$@"; then
    steps+=("$(printf '%-34s %5d s' "$name" $((SECONDS - start)))")
  else
    failed+=("$name")
    steps+=("$(printf '%-34s %5d s  FAILED' "$name" $((SECONDS - start)))")
    return 1
  fi
}

# Steps, times and verdict. Its status is the script's.
summary() {
  printf '\n== steps\n'
  printf '%s\n' "${steps[@]}"
  [ ${#failed[@]} -eq 0 ] || { echo "failed: ${failed[*]}" >&2; return 1; }
}

# Configures a build folder: configure PRESET FOLDER [cmake options]; ccache where it is there. A
# warning fails it too.
configure() {
  local preset=$1 folder=$2
  shift 2
  command -v ccache >/dev/null && set -- -DCMAKE_CXX_COMPILER_LAUNCHER=ccache "$@"
  if ! cmake --preset "$preset" -B "$folder" "$@" >"$folder.configure.log" 2>&1 ||
    grep -q '^CMake Warning' "$folder.configure.log"; then
    cat "$folder.configure.log"
    return 1
  fi
}
