//! `android-size`: what a phone would load, linked without the NDK: only to be weighed and looked at. Android's own
//! libraries are left out and what they hold is left open, so the real one is some tens of kilobytes larger.

use std::path::{Path, PathBuf};

use object::read::elf::{FileHeader, ProgramHeader};
use object::{Endianness, Object, ObjectSymbol, elf};

use crate::shell::{cargo, command, output, run, target_dir};
use crate::tally::Tally;
use crate::tools;
use crate::words::{Result, Stop, no_args};

/// A processor a phone may have.
struct Abi {
    /// What Android calls it.
    name: &'static str,
    triple: &'static str,
    /// What the linker calls it.
    emulation: &'static str,
    /// Bytes of the stripped library at most: what we have. It may only fall, unless an app gets more for it: the planner
    /// for electronic paper and its words took 21 kB.
    most: u64,
}

const ABIS: [Abi; 2] = [
    Abi {
        name: "arm64-v8a",
        triple: "aarch64-linux-android",
        emulation: "aarch64linux",
        most: 724 * 1024,
    },
    Abi {
        name: "x86_64",
        triple: "x86_64-linux-android",
        emulation: "elf_x86_64",
        most: 837 * 1024,
    },
];
/// What we want of each.
const GOAL: u64 = 700 * 1024;
/// What a phone with pages of 16 kB maps.
const PAGE: u64 = 0x4000;
/// The frame loop's calls, found by name.
const CALLS: usize = 2;

/// One row of the table.
struct Weight {
    bytes: u64,
    align: u64,
    exports: usize,
    calls: usize,
}

/// `cargo ci android-size`.
pub(crate) fn size(args: &[String]) -> Result {
    no_args(args)?;
    let lld = linker().map_err(Stop::Skipped)?;
    let mut rows = Vec::new();
    let mut skipped = Vec::new();
    for abi in ABIS {
        match tools::target(abi.triple) {
            Ok(()) => rows.push((weigh(&abi, &lld)?, abi)),
            Err(why) => skipped.push(why),
        }
    }
    println!("| libdogleaf_ffi.so | stripped, bytes | at most | goal | LOAD align | exported |");
    println!("|---|---|---|---|---|---|");
    for (Weight { bytes, align, exports, .. }, Abi { name, most, .. }) in &rows {
        let missed = if *bytes > GOAL { ", missed" } else { "" };
        println!("| {name} | {bytes} | {most} | {GOAL}{missed} | {align:#x} | {exports} |");
    }
    let faults: Vec<String> = rows.iter().flat_map(|(found, abi)| faults(found, abi)).collect();
    if !faults.is_empty() {
        return Err(faults.join("; ").into());
    }
    if skipped.is_empty() { Ok(Tally::default()) } else { Err(Stop::Skipped(skipped.join("; "))) }
}

fn faults(found: &Weight, abi: &Abi) -> Vec<String> {
    let Weight { bytes, align, calls, .. } = *found;
    let Abi { name, most, .. } = abi;
    let mut faults = Vec::new();
    if bytes > *most {
        faults.push(format!("{name}: {bytes} bytes are more than {most}"));
    }
    if align < PAGE {
        faults.push(format!("{name}: aligned to {align:#x}, phones want {PAGE:#x}"));
    }
    if calls != CALLS {
        faults.push(format!("{name}: {calls} of the frame loop's {CALLS} calls are exported"));
    }
    faults
}

/// The folder with the toolchain's own linker under the name compilers look for.
fn linker() -> std::result::Result<PathBuf, String> {
    let libdir = output(&mut command("rustc", ["--print", "target-libdir"]))?;
    let folder = Path::new(libdir.trim()).with_file_name("bin").join("gcc-ld");
    let found = folder.join("ld.lld").exists() && cfg!(target_os = "linux");
    if found { Ok(folder) } else { Err(format!("no ld.lld in {}", folder.display())) }
}

fn weigh(abi: &Abi, lld: &Path) -> std::result::Result<Weight, String> {
    let &Abi { name, triple, emulation, .. } = abi;
    let folder = target_dir().join("android");
    let folder = std::path::absolute(folder).map_err(|e| e.to_string())?;
    let script = folder.join(format!("link-{name}"));
    write_script(&script, emulation, lld)?;
    let variable = format!("CARGO_TARGET_{}_LINKER", triple.to_uppercase().replace('-', "_"));
    let build = ["build", "--profile", "mobile", "-p", "dogleaf-ffi", "--target", triple];
    run(cargo(build).env(variable, &script))?;
    let file = target_dir().join(triple).join("mobile/libdogleaf_ffi.so");
    let bytes = std::fs::read(&file).map_err(|e| format!("{}: {e}", file.display()))?;
    look(&bytes).map_err(|e| format!("{}: {e}", file.display()))
}

/// A compiler's driver that links for Android and drops the libraries it has not got.
#[cfg(unix)]
fn write_script(script: &Path, emulation: &str, lld: &Path) -> std::result::Result<(), String> {
    use std::os::unix::fs::PermissionsExt;
    let text = format!(
        "#!/bin/sh\nfor a in \"$@\"; do shift; case \"$a\" in -l*) ;; *) set -- \"$@\" \"$a\" ;; esac; done\n\
         exec cc -fuse-ld=lld '-B{}' -nostdlib -nostartfiles \"$@\" -Wl,-m,{emulation} \
         -Wl,-z,max-page-size=16384 -Wl,--unresolved-symbols=ignore-all\n",
        lld.display()
    );
    let fail = |e: std::io::Error| format!("{}: {e}", script.display());
    std::fs::create_dir_all(script.parent().unwrap_or(Path::new("."))).map_err(fail)?;
    std::fs::write(script, text).map_err(fail)?;
    std::fs::set_permissions(script, std::fs::Permissions::from_mode(0o755)).map_err(fail)
}

#[cfg(not(unix))]
fn write_script(_: &Path, _: &str, _: &Path) -> std::result::Result<(), String> {
    Err("a script that links is written on Unix only".to_owned())
}

fn look(bytes: &[u8]) -> std::result::Result<Weight, String> {
    let header = elf::FileHeader64::<Endianness>::parse(bytes).map_err(|e| e.to_string())?;
    let endian = header.endian().map_err(|e| e.to_string())?;
    let segments = header.program_headers(endian, bytes).map_err(|e| e.to_string())?;
    let loads = segments.iter().filter(|s| s.p_type(endian) == elf::PT_LOAD);
    let align = loads.map(|s| s.p_align(endian)).min().unwrap_or(0);
    let file = object::File::parse(bytes).map_err(|e| e.to_string())?;
    let names: Vec<&str> = file
        .dynamic_symbols()
        .filter(ObjectSymbol::is_definition)
        .filter_map(|s| s.name().ok())
        .collect();
    let calls = names.iter().filter(|n| n.starts_with("Java_org_dogleaf_FastCalls_")).count();
    Ok(Weight { bytes: bytes.len() as u64, align, exports: names.len(), calls })
}

#[cfg(test)]
mod check {
    use super::{ABIS, CALLS, PAGE, Weight, faults};

    #[test]
    fn every_bound_can_break() {
        let good = || Weight { bytes: 1, align: PAGE, exports: 9, calls: CALLS };
        assert!(faults(&good(), &ABIS[0]).is_empty(), "within its bounds");
        for (bad, word) in [
            (Weight { bytes: ABIS[0].most + 1, ..good() }, "bytes"),
            (Weight { align: 0x1000, ..good() }, "aligned"),
            (Weight { calls: 1, ..good() }, "calls"),
        ] {
            let found = faults(&bad, &ABIS[0]);
            assert!(found.len() == 1 && found[0].contains(word), "{found:?}");
        }
    }
}
