#!/usr/bin/env bash
# Builds boundfit_wasm.wasm.gz, page.wasm.gz and the JavaScript that goes with both from source, into crates/lesson/engine, where the
# lesson takes them from, or into the folder that is named. The page's module answers fit alone, and every page has it inside.
#
# The standard library for WebAssembly is compiled too, from Debian's sources of it, so that nothing is downloaded but packages and
# crates: Debian's compiler for browsers (rustc-web, and rust-web-src of the same version), the linker of the usual toolchain, and
# wasm-opt of binaryen. They are installed if this runs as root, 140 MB. Takes six minutes of processor time, then three.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
of_lesson=$root/crates/lesson/engine
mkdir -p "${1:-$of_lesson}"
engine=$(cd "${1:-$of_lesson}" && pwd)
cd "$root/wasm"

missing=()
[ -x /usr/bin/rustc ] && ls /usr/src/rustc-*/library/Cargo.toml >/dev/null 2>&1 || missing+=(rustc-web rust-web-src)
command -v wasm-opt >/dev/null || missing+=(binaryen)
if [ "${#missing[@]}" -gt 0 ]; then
  command -v apt-get >/dev/null && [ "$(id -u)" = 0 ] || { echo "missing: ${missing[*]}" >&2; exit 1; }
  apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
fi

# The usual toolchain has cargo and the linker; Debian's compiler comes before its own in nothing else.
usual=$(rustc --print sysroot)
target=${CARGO_TARGET_DIR:-$PWD/target}
export RUSTC=/usr/bin/rustc
# Building a standard library is not stable.
export RUSTC_BOOTSTRAP=1
CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$(find "$usual" -name rust-lld -type f | head -n 1)
export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER
home=${CARGO_HOME:-$HOME/.cargo}
flags=(
  # No path of this machine is part of the module.
  "--remap-path-prefix=$root=/boundfit" "--remap-path-prefix=$home=/cargo"
  # A panic traps, with or without the words that nobody would see and that make the module larger.
  -Zunstable-options -Cpanic=immediate-abort -Zlocation-detail=none
)
export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS=${flags[*]}

"$RUSTC" -Vv
# Builds the module with these features, as a file of this name.
module() {
  local name=$1
  shift
  cargo build --release --locked --package boundfit-wasm "$@" \
    -Z build-std=std,panic_abort -Z build-std-features=optimize_for_size --target wasm32-unknown-unknown
  cargo run --quiet --release --locked --package boundfit-wasm-pack -- \
    "$target/wasm32-unknown-unknown/release/boundfit_wasm.wasm" "$target/$name"

  # What the compiler uses of WebAssembly must be named, or else is taken for an error.
  wasm-opt -Oz --strip-debug --strip-producers --enable-bulk-memory --enable-sign-ext --enable-mutable-globals \
    --enable-nontrapping-float-to-int --enable-multivalue --enable-reference-types \
    "$target/$name/boundfit_wasm_bg.wasm" -o "$target/$name/boundfit_wasm.wasm"
  # Binaryen 108, which is Debian's, gives every table that is exported the number 0. That of JavaScript's objects is the second one.
  LC_ALL=C sed -i 's/__wbindgen_externrefs\x01\x00/__wbindgen_externrefs\x01\x01/' "$target/$name/boundfit_wasm.wasm"
  gzip -9 -n < "$target/$name/boundfit_wasm.wasm" > "$engine/$name.wasm.gz"
  wc -c "$target/$name/boundfit_wasm.wasm" "$engine/$name.wasm.gz"
}

module page --no-default-features
module boundfit_wasm
# One script goes with both.
cmp "$target/page/boundfit_wasm.js" "$target/boundfit_wasm/boundfit_wasm.js"
# The module is started from bytes that are there: what would fetch it is left out, so that a page can be seen to load nothing.
sed -e '/^async function __wbg_load(/,/^}/d' -e '/^let __wbg_init_promise/,/^export /d' \
  "$target/boundfit_wasm/boundfit_wasm.js" > "$engine/boundfit_wasm.mjs"
echo 'export { initSync };' >> "$engine/boundfit_wasm.mjs"
[ "$engine" = "$of_lesson" ] || cp "$of_lesson"/boundfit.{mjs,d.mts} "$engine"
sed '/^ \* If `module_or_path` is/,$d' "$target/boundfit_wasm/boundfit_wasm.d.ts" | sed '$d' > "$engine/boundfit_wasm.d.mts"
