//! `cargo xtask wasm`: compiles the engine to WASM and packs it for the browser into
//! `web/src/engine/pkg`: the module, its JavaScript and its TypeScript types.

mod compiler;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

use anyhow::{Context, Result, bail};
use compiler::{Compiler, TARGET};
use wasm_bindgen_cli_support::Bindgen;

const CRATE: &str = "kingpost-wasm";
const PACKAGE: &str = "web/src/engine/pkg";

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let result = match arguments.as_slice() {
        [task] if task == "wasm" => wasm(),
        _ => Err(anyhow::anyhow!("usage: cargo xtask wasm")),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn wasm() -> Result<()> {
    let root = root()?;
    let built = build(&root, &Compiler::find()?)?;
    let package = root.join(PACKAGE);
    Bindgen::new()
        .input_path(&built)
        .web(true)?
        .typescript(true)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate(&package)
        .with_context(|| format!("packing {} failed", built.display()))?;
    let module = package.join("kingpost_wasm_bg.wasm");
    let bytes = fs::metadata(&module).with_context(|| module.display().to_string())?.len();
    println!("{PACKAGE}: {:.0} kB of WASM", bytes as f64 / 1e3);
    Ok(())
}

/// Compiles the crate and returns the path of its module.
fn build(root: &Path, compiler: &Compiler) -> Result<PathBuf> {
    let status = compiler
        .cargo()
        .current_dir(root)
        .args(["build", "--locked", "--profile", "wasm", "--package", CRATE, "--target", TARGET])
        .status()
        .context("cargo did not start")?;
    if !status.success() {
        bail!("{CRATE} does not compile");
    }
    let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    Ok(target.join(TARGET).join("wasm").join("kingpost_wasm.wasm"))
}

fn root() -> Result<PathBuf> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    Ok(here.parent().context("xtask lies in the workspace")?.to_path_buf())
}
