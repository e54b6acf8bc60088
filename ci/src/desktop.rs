//! `desktop`: the window on a screen nobody sees, its pictures against the reference, and Android's half of it.

use std::path::Path;
use std::process::Command;

use crate::shell::{apt_install, cargo, command, output, run, run_counting, succeeds, target_dir};
use crate::tools;
use crate::words::{Result, Stop, no_args};

const PACKAGE: &str = "dogleaf-desktop";
const ANDROID: &str = "aarch64-linux-android";
/// What the program loads when it starts, and a screen in memory.
const LIBRARIES: [&str; 5] = [
    "libEGL.so.1",
    "libGLESv2.so.2",
    "libX11-xcb.so.1",
    "libXcursor.so.1",
    "libxkbcommon-x11.so.0",
];
const SCREEN: &str = "/usr/bin/xvfb-run";
/// Where Debian has them; the driver draws without a graphics card.
const DEBIAN: [&str; 11] = [
    "xvfb",
    "xauth",
    "libegl1",
    "libgles2",
    "libgl1-mesa-dri",
    "libx11-xcb1",
    "libxcursor1",
    "libxi6",
    "libxrandr2",
    "libxkbcommon0",
    "libxkbcommon-x11-0",
];
/// Tests need a release's speed, not its linking: a software driver draws for seconds.
const SWIFT: [&str; 4] = ["--profile", "swift", "-p", PACKAGE];

/// `cargo ci desktop`.
pub(crate) fn desktop(args: &[String]) -> Result {
    no_args(args)?;
    install().map_err(Stop::Skipped)?;
    let (tested, tally) = run_counting(&mut on_screen(&["test"], &["--", "--include-ignored"]));
    tested.map_err(|why| Stop::Failed(why, tally))?;
    let failed = |why| Stop::Failed(why, tally);
    run(&mut screenshot()).map_err(failed)?;
    let mut check = android().map_err(Stop::Skipped)?;
    run(&mut check).map_err(failed)?;
    Ok(tally)
}

/// Makes sure that everything is there.
fn install() -> std::result::Result<(), String> {
    if missing().is_empty() || (apt_install(&DEBIAN) && missing().is_empty()) {
        return Ok(());
    }
    Err(format!("{} missing: install {}", missing().join(", "), DEBIAN.join(" ")))
}

/// What is not on this machine.
fn missing() -> Vec<&'static str> {
    let known = output(&mut command("/sbin/ldconfig", ["-p"])).unwrap_or_default();
    let mut missing: Vec<_> = LIBRARIES.into_iter().filter(|l| !known.contains(l)).collect();
    missing.extend((!Path::new(SCREEN).exists()).then_some("xvfb-run"));
    missing
}

/// `cargo word`, with a screen of its own.
fn on_screen(word: &[&str], rest: &[&str]) -> Command {
    let mut c = command(SCREEN, ["-a", "cargo"]);
    c.args(word).args(SWIFT).args(rest);
    // A screen in memory is an X screen, whatever the machine has beside.
    c.env_remove("WAYLAND_DISPLAY");
    c
}

/// A picture to look at, drawn without any screen.
fn screenshot() -> Command {
    let mut c = cargo(["run"]);
    c.args(SWIFT).args(["--", "fixtures/books/old-verses.pdf"]);
    c.args(["--gesture", "fixtures/gestures/corner_turn.jsonl", "--at", "0.6", "--screenshot"]);
    c.arg(target_dir().join("desktop.png"));
    c.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
    c
}

/// `cargo check` of the library for Android: with the toolchain in use, or with Debian's, which builds `std` itself.
fn android() -> std::result::Result<Command, String> {
    let with = |mut c: Command| {
        c.args(["-p", PACKAGE, "--lib", "--target", ANDROID]);
        c.arg("--target-dir").arg(target_dir().join("android"));
        c
    };
    let lacks = match tools::target(ANDROID) {
        Ok(()) => return Ok(with(cargo(["check"]))),
        Err(lacks) => lacks,
    };
    let there = || {
        Path::new("/usr/bin/cargo").exists()
            && succeeds(&mut command("/usr/bin/rustc", ["--version"]))
    };
    if there() || (apt_install(&["rustc-web", "cargo-web", "rust-web-src"]) && there()) {
        let mut c =
            command("/usr/bin/cargo", ["check", "-Zbuild-std=std,panic_abort,panic_unwind"]);
        c.env("RUSTC", "/usr/bin/rustc").env("RUSTC_BOOTSTRAP", "1").env_remove("RUSTUP_TOOLCHAIN");
        return Ok(with(c));
    }
    Err(format!("the check for Android: {lacks}"))
}

#[cfg(test)]
mod check {
    use super::{on_screen, screenshot};

    #[test]
    fn the_tests_that_need_a_screen_get_one() {
        let c = on_screen(&["test"], &["--", "--include-ignored"]);
        let args: Vec<_> = c.get_args().map(|a| a.to_string_lossy()).collect();
        let wanted = "-a cargo test --profile swift -p dogleaf-desktop -- --include-ignored";
        assert_eq!(args.join(" "), wanted);
    }

    #[test]
    fn a_screenshot_has_no_screen() {
        let gone =
            |(name, value): (&std::ffi::OsStr, Option<_>)| name == "DISPLAY" && value.is_none();
        assert!(screenshot().get_envs().any(gone), "the headless way is what is tried");
    }
}
