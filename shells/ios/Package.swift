// swift-tools-version: 5.9
import PackageDescription

#if os(Linux)
// The library of this machine: `cargo build --release -p dogleaf-ffi`, then
// `swift test -Xlinker -L<target>/release` with that folder in LD_LIBRARY_PATH.
let library: Target = .systemLibrary(name: "DogleafFFI", path: "Sources/DogleafFFI/include")
let unread = ["Shaders.metal", "PrivacyInfo.xcprivacy"]
let resources: [Resource] = []
let linked: [LinkerSetting] = [.linkedLibrary("dogleaf_ffi")]
#else
/// `true`: what `build-xcframework.sh` made here. `false`: the archive of a release, once there is one.
let useLocalFramework = true
let release = (url: "https://example.org/DogleafFFI.xcframework.zip", checksum: "")
let library: Target = useLocalFramework
    ? .binaryTarget(name: "DogleafFFI", path: "build/DogleafFFI.xcframework")
    : .binaryTarget(name: "DogleafFFI", url: release.url, checksum: release.checksum)
let unread: [String] = []
let resources: [Resource] = [.process("Shaders.metal"), .copy("PrivacyInfo.xcprivacy")]
let linked: [LinkerSetting] = []
#endif

let package = Package(
    name: "Dogleaf",
    platforms: [.iOS(.v15), .macOS(.v12)],
    products: [.library(name: "Dogleaf", targets: ["Dogleaf"])],
    targets: [
        library,
        .target(
            name: "Dogleaf", dependencies: ["DogleafFFI"], exclude: unread, resources: resources,
            linkerSettings: linked),
        .testTarget(name: "DogleafTests", dependencies: ["Dogleaf"]),
    ]
)
