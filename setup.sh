#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what fdebench needs from Debian's packages and npm: setup.sh for the solver, its sweep and its page; with --tests
# also what the tests and the site need, with --lint what .ci/lint needs, with --clang what the presets clang and fuzz need. Does
# nothing, in about a second, when nothing is missing.
set -euo pipefail
cd "$(dirname "$0")"

packages=(git pkg-config cmake ninja-build g++ ccache libeigen3-dev libboost-dev libmpfr-dev libmpc-dev libgmp-dev
  libhwy-dev libfmt-dev nlohmann-json3-dev libsqlite3-dev libssl-dev libtomlplusplus-dev zlib1g-dev)
# Machine code of equation files; on other processors they are interpreted.
[ "$(dpkg --print-architecture)" != amd64 ] || packages+=(libasmjit-dev)
# Of figures as PDF: librsvg, and the letters of papers.
packages+=(librsvg2-bin fonts-urw-base35)
npm_folders=(reports)
command -v node >/dev/null || packages+=(nodejs)
command -v npm >/dev/null || packages+=(npm)
for option in "$@"; do
  case $option in
    --tests)
      packages+=(libbenchmark-dev libgtest-dev libgmock-dev libgsl-dev libflint-dev libflint-arb-dev)
      # Of the Python module and its tests.
      packages+=(dpkg-dev file python3 python3-dev pybind11-dev python3-numpy python3-pytest python3-mpmath python3-matplotlib
        python3-nbconvert python3-ipykernel)
      # Of the site.
      packages+=(mkdocs-material doxygen)
      # Of the tables in docs/results.md.
      packages+=(sqlite3)
      # Of the packages.
      packages+=(patchelf python3-pip python3-setuptools python3-wheel)
      python3 -c "import jsonschema" 2>/dev/null || packages+=(python3-jsonschema)
      command -v octave-cli >/dev/null || packages+=(octave)
      # Chromium without a window. Its package does not name that of its data.
      command -v chromium-headless-shell >/dev/null || packages+=(chromium-headless-shell chromium-common)
      npm_folders+=(tests/browser)
      ;;
    --lint) packages+=(clang-format clang-tidy libclang-dev llvm-dev python3) ;;
    --clang) packages+=(clang libclang-rt-dev) ;;
    *)
      echo "setup.sh: $option: no such option; there are --tests, --lint and --clang" >&2
      exit 2
      ;;
  esac
done

missing=()
for package in "${packages[@]}"; do
  dpkg-query --show --showformat='${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' || missing+=("$package")
done
if ((${#missing[@]})); then
  as_root=()
  ((EUID == 0)) || as_root=(sudo)
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
fi

# npm leaves .package-lock.json in node_modules when it has finished; older than our lock means out of date.
for folder in "${npm_folders[@]}"; do
  if [ ! "$folder/node_modules/.package-lock.json" -nt "$folder/package-lock.json" ]; then
    npm ci --prefix "$folder" --no-audit --no-fund
    touch "$folder/node_modules/.package-lock.json"
  fi
done
