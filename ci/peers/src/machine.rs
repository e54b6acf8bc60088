//! The processor; a figure without its machine says little.

/// What matters of what a processor can.
const TOLD: [&str; 8] = ["sse4_2", "avx", "avx2", "fma", "bmi1", "bmi2", "f16c", "avx512f"];

/// The processor, as it calls itself.
pub(crate) fn name() -> String {
    field("model name")
        .map_or_else(|| std::env::consts::ARCH.to_owned(), |name| name.replace(['"', '\\'], ""))
}

/// Which of the vector instructions it has.
pub(crate) fn flags() -> String {
    let all = field("flags").unwrap_or_default();
    let has = |flag: &&str| all.split_whitespace().any(|f| f == *flag);
    let told: Vec<&str> = TOLD.into_iter().filter(has).collect();
    told.join(" ")
}

/// What our side was compiled for. `cargo ci peers` sees to it; a bare `cargo run` does not.
pub(crate) fn target() -> &'static str {
    let level_3 = cfg!(all(
        target_feature = "avx2",
        target_feature = "fma",
        target_feature = "bmi2",
        target_feature = "lzcnt"
    ));
    match (level_3, cfg!(target_arch = "x86_64")) {
        (true, _) => "x86-64-v3",
        (false, true) => "x86-64 below v3",
        (false, false) => std::env::consts::ARCH,
    }
}

fn field(key: &str) -> Option<String> {
    let info = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let (_, value) = info.lines().find(|l| l.starts_with(key))?.split_once(':')?;
    Some(value.trim().to_owned())
}
