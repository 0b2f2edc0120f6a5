# What the scripts of this folder share. Sourced, never run.

set -euo pipefail

root_dir="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
export HOME="${HOME:-$(getent passwd "$(id -u)" | cut -d : -f 6)}"
cache_dir="${XDG_CACHE_HOME:-$HOME/.cache}/smat"

# Qt wants a folder of the session's own, and says so at every start where there is none.
if [ -z "${XDG_RUNTIME_DIR:-}" ]; then
    export XDG_RUNTIME_DIR="$cache_dir/runtime"
    mkdir -p -m 700 "$XDG_RUNTIME_DIR"
fi

# A line about what is done next.
say() { printf '== %s\n' "$*"; }

# One sentence about what the world refused us, and the end.
fail() {
    printf '%s: %s\n' "$(basename "$0")" "$*" >&2
    exit 1
}

# run_logged LOG COMMAND...: keeps the noise of a command in a file; its exit status stays. A function
# called this way in a condition runs on after a failing line: chain its lines with && or || return.
run_logged() {
    local log="$1"
    shift
    mkdir -p "$(dirname "$log")"
    "$@" >"$log" 2>&1 </dev/null
}

# Whether a Debian package is installed.
is_installed() {
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ]
}

# Whether apt could install a package, as far as the lists of this machine know.
is_available() {
    local policy
    policy="$(apt-cache policy "$1" 2>/dev/null || true)"
    case "$policy" in *'Candidate: (none)'*) return 1 ;; *'Candidate: '*) return 0 ;; esac
    return 1
}

# configure_and_build PRESET [TARGET...]: cmake with what scripts/setup found out, then the build, of all
# where no target is named; noise only where it fails.
configure_and_build() {
    local preset="$1" log="$root_dir/build/$1-configure.log" options=("-DSMAT_PYTHON_ENVIRONMENT=$cache_dir/python")
    local targets=("${@:2}")
    if [ "${SMAT_BUILD_GUI:-ON}" = OFF ]; then
        options+=(-DSMAT_BUILD_GUI=OFF)
    fi
    say "Configuring build/$preset"
    if ! run_logged "$log" cmake --preset "$preset" "${options[@]}"; then
        grep -A 12 'CMake Error' "$log" >&2 || tail -n 20 "$log" >&2
        fail "the build could not be configured (all of it in $log)."
    fi
    say "Building (the first time takes a few minutes)"
    cmake --build --preset "$preset" ${targets[@]:+--target "${targets[@]}"} || fail "the build failed; the first error is above."
}
