# Sourced by ./run and ./test: installs missing packages, configures and builds. Needs bash and `root`, the project's folder.

say() { printf '\033[1m%s\033[0m\n' "$*"; }
fail() { printf '%s: %s\n' "$(basename "$0")" "$*" >&2; exit 1; }

# Packages of scripts/packages.txt that are not installed.
missing_packages() {
  local package
  grep -v '^#' "$root/scripts/packages.txt" | while read -r package; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || echo "$package"
  done
}

install_packages() {
  command -v apt-get >/dev/null || fail "apt-get not found: on systems other than Debian 12 install the packages of scripts/packages.txt by hand, then use cmake --preset release"
  local missing as_root=()
  missing=$(missing_packages)
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "these packages are missing, and there is no sudo to install them as root: $(echo $missing)"
    as_root=(sudo)
  fi
  say "Installing: $(echo $missing)"
  "${as_root[@]}" apt-get update -q || fail "apt-get update failed: is there a network?"
  # shellcheck disable=SC2086
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing ||
    fail "apt-get could not install: $(echo $missing)"
}

# Configures and builds the release preset; further arguments go to cmake --build.
build() {
  local log="$root/build/release/configure.log"
  mkdir -p "$root/build/release"
  say "Configuring (build/release)"
  (cd "$root" && cmake --preset release >"$log" 2>&1) || { cat "$log" >&2; fail "configuring failed; see above"; }
  say "Building"
  (cd "$root" && cmake --build --preset release --parallel "$(nproc)" "$@") || fail "building failed; see above"
}
