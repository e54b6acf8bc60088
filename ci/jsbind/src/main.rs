//! wasm-bindgen's generator: `dogleaf-jsbind FILE.wasm FOLDER` writes modules for browsers and their types.

use std::process::ExitCode;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [from, to] = args.as_slice() else {
        eprintln!("usage: dogleaf-jsbind FILE.wasm FOLDER");
        return ExitCode::from(2);
    };
    let mut bindgen = Bindgen::new();
    // The page says where the module lies: it has two to choose from.
    bindgen.input_path(from).out_name("dogleaf").typescript(true).omit_default_module_path(true);
    let made = bindgen.web(true).and_then(|b| b.generate(to));
    match made {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("dogleaf-jsbind: {why:#}");
            ExitCode::FAILURE
        }
    }
}
