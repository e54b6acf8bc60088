//! Compiles `eigen.cpp` for the processor level that the Rust side is compiled for.

fn main() {
    let include =
        std::env::var("EIGEN3_INCLUDE").unwrap_or_else(|_| "/usr/include/eigen3".to_owned());
    println!("cargo::rerun-if-changed=eigen.cpp");
    println!("cargo::rerun-if-env-changed=EIGEN3_INCLUDE");
    let mut build = cc::Build::new();
    build.cpp(true).std("c++17").opt_level(3).define("NDEBUG", None).warnings(false);
    // As a system folder: its warnings are not ours.
    build.flag("-isystem").flag(&include).file("eigen.cpp");
    if std::env::var("CARGO_CFG_TARGET_ARCH").is_ok_and(|arch| arch == "x86_64") {
        build.flag("-march=x86-64-v3");
    }
    build.compile("dogleaf_eigen");
}
