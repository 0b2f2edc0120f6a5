# What the scripts of this folder share. Sourced, never run.

set -euo pipefail

root_dir="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
cache_dir="${XDG_CACHE_HOME:-$HOME/.cache}/smat"
export DEBIAN_FRONTEND=noninteractive

# A line about what is done next.
say() { printf '== %s\n' "$*"; }

# One sentence about what the world refused us, and the end.
fail() {
    printf '%s: %s\n' "$(basename "$0")" "$*" >&2
    exit 1
}

# run_logged LOG COMMAND...: keeps the noise of a command in a file; its exit status stays.
run_logged() {
    local log="$1"
    shift
    mkdir -p "$(dirname "$log")"
    "$@" >"$log" 2>&1 </dev/null
}

# as_root COMMAND...: with sudo when we are somebody else.
as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo DEBIAN_FRONTEND=noninteractive "$@"
    else
        fail "root is needed to run '$*', and there is no sudo: run that line as root, then this script again."
    fi
}

# Whether a Debian package is installed.
is_installed() {
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ]
}

# Whether apt could install a package, as far as the lists of this machine know.
is_available() {
    [ -n "$(apt-cache policy "$1" 2>/dev/null | sed -n 's/^ *Candidate: *//p' | grep -v '(none)' || true)" ]
}
