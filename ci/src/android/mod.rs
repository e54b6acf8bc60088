//! `android`: the Kotlin shell on a plain JVM, its renderer on Mesa without a window. `android-size`: what a phone would
//! load is weighed.

mod size;

pub(crate) use size::size;

use std::path::Path;

use crate::bindings::library;
use crate::shell::{apt_install, command, run_counting, succeeds};
use crate::tally::Tally;
use crate::words::{Result, Stop, no_args};

const POM: &str = "shells/android/pom.xml";
/// What the tests run on, and the packages that have it.
const JVM: [(&str, &str); 2] = [("javac", "openjdk-17-jdk-headless"), ("mvn", "maven")];
const GL: [&str; 3] = ["libegl1", "libgles2", "libgl1-mesa-dri"];
/// Where the loader looks for Mesa's part of EGL.
const MESA: &str = "/usr/share/glvnd/egl_vendor.d/50_mesa.json";

/// `cargo ci android`.
pub(crate) fn android(args: &[String]) -> Result {
    no_args(args)?;
    ready().map_err(Stop::Skipped)?;
    let absolute = |p: &Path| std::path::absolute(p).map_err(|e| Stop::from(e.to_string()));
    let library = absolute(&library()?)?;
    let folder = library.parent().unwrap_or(Path::new("."));
    let mut c = command("mvn", ["--batch-mode", "--quiet", "--file", POM, "test"]);
    c.arg(format!("-Ddogleaf.library={}", folder.display()));
    let (result, mut tally) = run_counting(&mut c);
    result.map_err(|why| Stop::Failed(why, tally))?;
    tally += reports()?;
    Ok(tally)
}

fn ready() -> std::result::Result<(), String> {
    for (program, package) in JVM {
        let there = || succeeds(&mut command(program, ["-version"]));
        if !(there() || apt_install(&[package]) && there()) {
            return Err(format!("{program} is missing: install {package}"));
        }
    }
    if !Path::new(MESA).exists() && !apt_install(&GL) {
        return Err(format!("no Mesa to draw with: install {}", GL.join(", ")));
    }
    Ok(())
}

/// What the tests say of themselves: a report a class.
fn reports() -> std::result::Result<Tally, String> {
    let folder = "shells/android/target/surefire-reports";
    let list = std::fs::read_dir(folder).map_err(|e| format!("{folder}: {e}"))?;
    let mut tally = Tally::default();
    for entry in list.flatten().filter(|e| e.path().extension().is_some_and(|x| x == "txt")) {
        let text = std::fs::read_to_string(entry.path()).unwrap_or_default();
        tally += counted(&text);
    }
    println!("{} tests passed on the JVM", tally.passed);
    if tally.passed == 0 { Err("no test ran on the JVM".to_owned()) } else { Ok(tally) }
}

/// `Tests run: 7, Failures: 0, Errors: 0, Skipped: 0, ..`
fn counted(report: &str) -> Tally {
    let count = |key: &str| -> u64 {
        let Some((_, rest)) = report.split_once(key) else { return 0 };
        rest.trim_start()
            .chars()
            .take_while(char::is_ascii_digit)
            .collect::<String>()
            .parse()
            .unwrap_or(0)
    };
    let failed = count("Failures:") + count("Errors:");
    let ignored = count("Skipped:");
    let passed = count("Tests run:").saturating_sub(failed + ignored);
    Tally { passed, failed, ignored }
}

#[cfg(test)]
mod check {
    use super::counted;
    use crate::tally::Tally;

    #[test]
    fn reports_are_counted() {
        let text = "Test set: org.dogleaf.BookTest\nTests run: 9, Failures: 1, Errors: 2, Skipped: 3, Time elapsed: 1 s";
        assert_eq!(counted(text), Tally { passed: 3, failed: 3, ignored: 3 });
        assert_eq!(counted("nothing"), Tally::default());
    }
}
