//! Tells `dogleaf bench` how it was built.

use std::env;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=CARGO_ENCODED_RUSTFLAGS");
    let flags = env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default().replace('\u{1f}', " ");
    println!("cargo::rustc-env=DOGLEAF_FLAGS={flags}");
    for (name, from) in [("DOGLEAF_TARGET", "TARGET"), ("DOGLEAF_OPT", "OPT_LEVEL")] {
        println!("cargo::rustc-env={name}={}", env::var(from).unwrap_or_default());
    }
    println!("cargo::rustc-env=DOGLEAF_RUSTC={}", compiler().unwrap_or_default().trim());
}

fn compiler() -> Option<String> {
    let output = Command::new(env::var_os("RUSTC")?).arg("--version").output().ok()?;
    String::from_utf8(output.stdout).ok()
}
