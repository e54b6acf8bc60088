#!/usr/bin/env bash
# build/DogleafFFI.xcframework: the library for devices, for simulators, and for `swift test` on a Mac.
# Needs a Mac with Xcode and rustup.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
[ "$(uname)" = Darwin ] || { echo "build-xcframework.sh: needs xcodebuild and lipo, so a Mac" >&2; exit 1; }

root=$(cd ../.. && pwd)
target=${CARGO_TARGET_DIR:-$root/target}
triples=(aarch64-apple-ios aarch64-apple-ios-sim x86_64-apple-ios aarch64-apple-darwin x86_64-apple-darwin)
export IPHONEOS_DEPLOYMENT_TARGET=15.0 MACOSX_DEPLOYMENT_TARGET=12.0

rustup target add "${triples[@]}"
for triple in "${triples[@]}"; do
    cargo rustc --manifest-path "$root/ffi/Cargo.toml" --profile mobile --lib --crate-type staticlib \
        --target "$triple" --target-dir "$target"
done

rm -rf build && mkdir -p build/simulator build/macos build/include/DogleafFFI
built() { echo "$target/$1/mobile/libdogleaf_ffi.a"; }
lipo -create "$(built aarch64-apple-ios-sim)" "$(built x86_64-apple-ios)" -output build/simulator/libdogleaf_ffi.a
lipo -create "$(built aarch64-apple-darwin)" "$(built x86_64-apple-darwin)" -output build/macos/libdogleaf_ffi.a

# In a folder of its own, so that its module.modulemap does not meet another library's.
cp Sources/DogleafFFI/include/* build/include/DogleafFFI/

xcodebuild -create-xcframework \
    -library "$(built aarch64-apple-ios)" -headers build/include \
    -library build/simulator/libdogleaf_ffi.a -headers build/include \
    -library build/macos/libdogleaf_ffi.a -headers build/include \
    -output build/DogleafFFI.xcframework
cp Sources/Dogleaf/PrivacyInfo.xcprivacy build/DogleafFFI.xcframework/

# The archive of a release, and the checksum that Package.swift asks for.
(cd build && ditto -c -k --keepParent DogleafFFI.xcframework DogleafFFI.xcframework.zip)
swift package compute-checksum build/DogleafFFI.xcframework.zip
