#!/usr/bin/env bash
# Puts Emscripten 3.1.69 (from Debian's next release) into a private prefix on Debian 12, with LLVM 19 from Debian 12 itself.
# Everything comes from the mirror that this machine's apt already uses. The system changes only by clang-19, lld-19 and
# llvm-19, if they are missing; the prefix can be deleted at any time.
#   usage: install-emscripten.sh PREFIX
set -euo pipefail

prefix=${1:?usage: install-emscripten.sh PREFIX}
em=$prefix/usr/share/emscripten
if [ -e "$prefix/.done" ]; then echo "already there: $prefix"; exit 0; fi

if [ ! -x /usr/lib/llvm-19/bin/clang ] || [ ! -x /usr/lib/llvm-19/bin/lld ] || [ ! -x /usr/lib/llvm-19/bin/llvm-ar ]; then
  sudo=; [ "$(id -u)" = 0 ] || sudo=sudo
  $sudo apt-get install -y -qq --no-install-recommends clang-19 lld-19 llvm-19 >/dev/null
fi

mirror=$(apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(COMPONENT)' 'Created-By: Packages' |
         awk '$2=="bookworm" && $3=="main" {print $1; exit}')
[ -n "$mirror" ] || { echo "no Debian 12 main archive in this machine's apt sources" >&2; exit 1; }

tmp=$(mktemp -d); trap 'rm -rf "$tmp"' EXIT
mkdir -p "$tmp"/{parts,lists/partial,cache/archives/partial,debs} "$prefix"
cat > "$tmp/parts/trixie.sources" <<S
Types: deb
URIs: $mirror
Suites: trixie
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
S
# An apt of its own lists and cache: the system's apt never hears of the next release.
apt_trixie=(-qq -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$tmp/parts" -o Dir::State::lists="$tmp/lists"
            -o Dir::Cache="$tmp/cache" -o APT::Sandbox::User=root)
apt-get "${apt_trixie[@]}" update
(cd "$tmp/debs" && apt-get "${apt_trixie[@]}" download \
  emscripten/trixie binaryen/trixie libc6/trixie libstdc++6/trixie libgcc-s1/trixie)

dpkg-deb --fsys-tarfile "$tmp"/debs/emscripten_*.deb | tar -x -C "$prefix" --exclude='./usr/share/emscripten/test' \
  --exclude='*/wasm32-emscripten/pic' --exclude='*/wasm32-emscripten/lto-pic' \
  --exclude='./usr/share/doc' --exclude='./usr/share/man'
dpkg -x "$tmp"/debs/binaryen_*.deb "$prefix"
for d in libc6 libstdc++6 libgcc-s1; do dpkg -x "$tmp"/debs/${d}_*.deb "$prefix/trixie-rt"; done

# That binaryen needs a newer C library than Debian 12 has: run it by its own release's loader.
mkdir -p "$prefix/binaryen/bin"
triplet=$(uname -m)-linux-gnu
lib=$prefix/trixie-rt/usr/lib/$triplet
loader=$(ls "$lib"/ld-linux-*.so.* | head -n 1)
for tool in "$prefix"/usr/bin/wasm*; do
  out=$prefix/binaryen/bin/$(basename "$tool")
  printf '#!/bin/sh\nexec "%s" --library-path "%s:%s" "%s" "$@"\n' \
    "$loader" "$lib" "$prefix/usr/lib/$triplet" "$tool" > "$out"
  chmod +x "$out"
done

cat > "$em/.emscripten" <<S
LLVM_ROOT = '/usr/lib/llvm-19/bin'
BINARYEN_ROOT = '$prefix/binaryen'
NODE_JS = '$(command -v node)'
FROZEN_CACHE = True
CACHE = '$em/cache'
LLVM_ADD_VERSION = ''
CLANG_ADD_VERSION = ''
S

# The optimizer of the JavaScript half needs acorn, which the package leaves to Debian's own node modules.
(cd "$em" && npm install --no-audit --no-fund --no-save --loglevel=error acorn@8.14.0 >/dev/null)

touch "$prefix/.done"
"$em/em++" --version | head -n 1
