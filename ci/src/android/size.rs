//! `android-size`: what a phone would load, linked without the NDK: only to be weighed and looked at. Android's own
//! libraries are left out and what they hold is left open, so the real one is some tens of kilobytes larger.

use std::path::{Path, PathBuf};

use object::read::elf::{FileHeader, ProgramHeader};
use object::{Endianness, Object, ObjectSymbol, elf};

use crate::shell::{cargo, command, output, run, target_dir};
use crate::tally::Tally;
use crate::tools;
use crate::words::{Result, Stop, no_args};

/// What Android calls a processor, the toolchain's name for it, and the linker's.
const ABIS: [(&str, &str, &str); 2] = [
    ("arm64-v8a", "aarch64-linux-android", "aarch64linux"),
    ("x86_64", "x86_64-linux-android", "elf_x86_64"),
];
/// Bytes of the stripped library at most.
const MOST: u64 = 700 * 1024;
/// What a phone with pages of 16 kB maps.
const PAGE: u64 = 0x4000;

/// One row of the table.
struct Weight {
    abi: &'static str,
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
    for (abi, triple, emulation) in ABIS {
        match tools::target(triple) {
            Ok(()) => rows.push(weigh(abi, triple, emulation, &lld)?),
            Err(why) => skipped.push(why),
        }
    }
    println!(
        "| libdogleaf_ffi.so | stripped, bytes | at most | LOAD align | exported |\n|---|---|---|---|---|"
    );
    for r in &rows {
        println!("| {} | {} | {MOST} | {:#x} | {} |", r.abi, r.bytes, r.align, r.exports);
    }
    let mut faults = Vec::new();
    for r in &rows {
        if r.bytes > MOST {
            faults.push(format!("{}: {} bytes are more than {MOST}", r.abi, r.bytes));
        }
        if r.align < PAGE {
            faults.push(format!("{}: aligned to {:#x}, phones want {PAGE:#x}", r.abi, r.align));
        }
        if r.calls != 2 {
            faults.push(format!("{}: the frame loop's two calls are not exported", r.abi));
        }
    }
    if !faults.is_empty() {
        return Err(faults.join("; ").into());
    }
    if skipped.is_empty() { Ok(Tally::default()) } else { Err(Stop::Skipped(skipped.join("; "))) }
}

/// The folder with the toolchain's own linker under the name compilers look for.
fn linker() -> std::result::Result<PathBuf, String> {
    let libdir = output(&mut command("rustc", ["--print", "target-libdir"]))?;
    let folder = Path::new(libdir.trim()).with_file_name("bin").join("gcc-ld");
    let found = folder.join("ld.lld").exists() && cfg!(target_os = "linux");
    if found { Ok(folder) } else { Err(format!("no ld.lld in {}", folder.display())) }
}

fn weigh(
    abi: &'static str,
    triple: &str,
    emulation: &str,
    lld: &Path,
) -> std::result::Result<Weight, String> {
    let folder = target_dir().join("android");
    let folder = std::path::absolute(folder).map_err(|e| e.to_string())?;
    let script = folder.join(format!("link-{abi}"));
    write_script(&script, emulation, lld)?;
    let variable = format!("CARGO_TARGET_{}_LINKER", triple.to_uppercase().replace('-', "_"));
    let build = ["build", "--profile", "mobile", "-p", "dogleaf-ffi", "--target", triple];
    run(cargo(build).env(variable, &script))?;
    let file = target_dir().join(triple).join("mobile/libdogleaf_ffi.so");
    let bytes = std::fs::read(&file).map_err(|e| format!("{}: {e}", file.display()))?;
    look(abi, &bytes).map_err(|e| format!("{}: {e}", file.display()))
}

/// A compiler's driver that links for Android and drops the libraries it has not got.
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

fn look(abi: &'static str, bytes: &[u8]) -> std::result::Result<Weight, String> {
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
    Ok(Weight { abi, bytes: bytes.len() as u64, align, exports: names.len(), calls })
}
