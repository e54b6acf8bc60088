//! What goes where: the package, its types and shaders; the page with all that it needs without a network.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use super::{Places, SHELL};
use crate::shell::{command, run};

type Done<T = ()> = std::result::Result<T, String>;

const GLSL: &str = "shells/glsl";
const SHADERS: [&str; 6] =
    ["page.vert", "page.frag", "shadow.vert", "shadow.frag", "grain.vert", "grain.frag"];
/// What of pdf.js a page needs.
const PDFJS: [(&str, &str); 6] = [
    ("legacy/build/pdf.min.mjs", "pdf.min.mjs"),
    ("legacy/build/pdf.worker.min.mjs", "pdf.worker.min.mjs"),
    ("LICENSE", "LICENSE"),
    ("cmaps", "cmaps"),
    ("standard_fonts", "standard_fonts"),
    ("wasm", "wasm"),
];

/// The npm package: modules, both cores, shaders; then types, which also checks them.
pub(super) fn package(places: &Places) -> Done {
    let to = &places.package;
    clear(to)?;
    copy(&Path::new(SHELL).join("js"), to)?;
    for name in ["package.json", "tsconfig.json"] {
        copy(&Path::new(SHELL).join("package").join(name), &to.join(name))?;
    }
    copy(&Path::new(SHELL).join("README.md"), &to.join("README.md"))?;
    for licence in ["LICENSE-APACHE", "LICENSE-MIT"] {
        copy(Path::new(licence), &to.join(licence))?;
    }
    let made = places.out.join("made");
    for core in ["simd", "scalar"] {
        copy(&made.join(core).join("dogleaf_bg.wasm"), &to.join(format!("wasm/{core}.wasm")))?;
    }
    for glue in ["dogleaf.js", "dogleaf.d.ts"] {
        copy(&made.join("simd").join(glue), &to.join("wasm").join(glue))?;
    }
    write(&to.join("shaders.js"), &shaders()?)?;
    types(places)
}

/// The shaders of all GL shells as a module.
fn shaders() -> Done<String> {
    let quoted =
        |name: &str| -> Done<String> { Ok(format!("{:?}", read(&Path::new(GLSL).join(name))?)) };
    let mut text = format!(
        "// Made of shells/glsl.\n\nexport const COMMON = {};\n\nexport const SHADERS = {{\n",
        quoted("common.glsl")?
    );
    for name in SHADERS {
        let _ = writeln!(text, "    {name:?}: {},", quoted(name)?);
    }
    text.push_str("};\n");
    Ok(text)
}

/// The types of the modules, and whether they hold; then those of somebody who uses the package.
fn types(places: &Places) -> Done {
    let tsc = |project: &Path| {
        let mut c = command("node", [places.modules.join("typescript/bin/tsc")]);
        c.arg("--project").arg(project);
        run(&mut c)
    };
    tsc(&places.package)?;
    fs::remove_file(places.package.join("tsconfig.json")).map_err(|e| e.to_string())?;
    let consumer = places.out.join("consumer");
    clear(&consumer)?;
    copy(&Path::new(SHELL).join("tests/consumer"), &consumer)?;
    copy(&Path::new(SHELL).join("examples/host_loop.js"), &consumer.join("host_loop.js"))?;
    copy(&places.package, &consumer.join("node_modules/dogleaf"))?;
    tsc(&consumer)?;
    // The control: what is wrong is refused.
    let wrong = consumer.join("wrong");
    if tsc(&wrong).is_ok() {
        return Err("a consumer that is wrong passed the types".to_owned());
    }
    Ok(())
}

/// The page, with everything local, and a list of it for the worker that keeps it.
pub(super) fn reader(places: &Places) -> Done {
    let to = &places.reader;
    clear(to)?;
    copy(&Path::new(SHELL).join("reader"), to)?;
    copy(&places.package, &to.join("dogleaf"))?;
    let grids = places.out.join("made/grids/dogleaf_bg.wasm");
    copy(&grids, &to.join("dogleaf/wasm/grids.wasm"))?;
    for (from, name) in PDFJS {
        copy(&places.modules.join("pdfjs-dist").join(from), &to.join("pdfjs").join(name))?;
    }
    for data in ["books/old-verses.pdf", "recordings/slow_turn_f32.dlr"] {
        copy(&Path::new("fixtures").join(data), &to.join(data))?;
    }
    offline(to)
}

/// Names every file to the service worker, and the hash of all of them: another page is another cache.
fn offline(folder: &Path) -> Done {
    let mut files = Vec::new();
    list(folder, folder, &mut files)?;
    files.retain(|f| f != "sw.js" && !f.ends_with(".d.ts") && !f.contains("LICENSE"));
    files.sort();
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for file in &files {
        let bytes = fs::read(folder.join(file)).map_err(|e| format!("{file}: {e}"))?;
        for byte in file.bytes().chain(bytes) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
    let worker = folder.join("sw.js");
    let text = read(&worker)?;
    let filled = text.replace("\"@VERSION@\"", &format!("\"{hash:016x}\""));
    write(&worker, &filled.replace("[\"@FILES@\"]", &format!("{files:?}")))
}

fn list(root: &Path, folder: &Path, into: &mut Vec<String>) -> Done {
    for entry in entries(folder)? {
        if entry.is_dir() {
            list(root, &entry, into)?;
        } else if let Ok(name) = entry.strip_prefix(root) {
            into.push(name.to_string_lossy().replace('\\', "/"));
        }
    }
    Ok(())
}

fn entries(folder: &Path) -> Done<Vec<PathBuf>> {
    let all = fs::read_dir(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    Ok(all.flatten().map(|e| e.path()).collect())
}

/// Copies a file, or a folder with all that is in it.
pub(super) fn copy(from: &Path, to: &Path) -> Done {
    if from.is_dir() {
        return entries(from)?
            .iter()
            .try_for_each(|e| copy(e, &to.join(e.file_name().unwrap_or_default())));
    }
    fs::create_dir_all(to.parent().unwrap_or(Path::new("."))).map_err(|e| e.to_string())?;
    fs::copy(from, to).map(|_| ()).map_err(|e| format!("{}: {e}", from.display()))
}

fn clear(folder: &Path) -> Done {
    match fs::remove_dir_all(folder) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => {
            Err(format!("{}: {e}", folder.display()))
        }
        _ => fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display())),
    }
}

pub(super) fn read(path: &Path) -> Done<String> {
    fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))
}

fn write(path: &Path, text: &str) -> Done {
    fs::write(path, text).map_err(|e| format!("{}: {e}", path.display()))
}
