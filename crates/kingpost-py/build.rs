//! Builds the module: sets the linker's arguments and computes the digest of the engine's sources. Builds of the same
//! sources compute the same numbers for every target.

use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    // On macOS the linker must allow Python's symbols to be undefined: the program that loads the module provides them.
    pyo3_build_config::add_extension_module_link_args();
    println!("cargo::rustc-env=KINGPOST_SOURCE_DIGEST={}", digest_of_sources()?);
    Ok(())
}

fn digest_of_sources() -> io::Result<String> {
    let engine = Path::new(&env::var("CARGO_MANIFEST_DIR").unwrap_or_default()).join("../kingpost");
    let mut files = Vec::new();
    sources(&engine.join("src"), &mut files)?;
    files.sort();
    let mut digest = Sha256::new();
    for file in &files {
        let text = fs::read_to_string(file)?;
        digest.update(file.strip_prefix(&engine).unwrap_or(file).to_string_lossy().replace('\\', "/"));
        digest.update([0]);
        // A checkout may have CRLF line ends.
        digest.update(text.replace("\r\n", "\n"));
        digest.update([0]);
    }
    println!("cargo::rerun-if-changed={}", engine.join("src").display());
    Ok(format!("{:x}", digest.finalize()))
}

fn sources(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            sources(&path, files)?;
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            files.push(path);
        }
    }
    Ok(())
}
