//! Finds a Rust compiler that can build for WASM, and installs what it lacks.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use std::{env, thread};

use anyhow::{Context, Result, bail};

pub const TARGET: &str = "wasm32-unknown-unknown";

const TIME_LIMIT: Duration = Duration::from_secs(120);

/// Debian's own compiler, which brings the standard library's source.
const DEBIAN_CARGO: &str = "/usr/bin/cargo";
const DEBIAN_RUSTC: &str = "/usr/bin/rustc";
const DEBIAN_PACKAGES: [&str; 3] = ["rustc-web", "cargo-web", "rust-web-src"];

pub enum Compiler {
    /// The compiler in use has the target's standard library.
    Installed,
    /// Debian's compiler builds the standard library too, and links with the given linker.
    Debian { linker: PathBuf },
}

impl Compiler {
    /// Returns the compiler in use if it has the target or rustup can add it, else Debian's.
    pub fn find() -> Result<Self> {
        let sysroot = sysroot("rustc")?;
        if has_target(&sysroot) || (add_with_rustup() && has_target(&sysroot)) {
            return Ok(Self::Installed);
        }
        debian(&sysroot).context(format!("no Rust target {TARGET}; run: rustup target add {TARGET}"))
    }

    /// Returns a cargo command that builds for [`TARGET`].
    pub fn cargo(&self) -> Command {
        match self {
            Self::Installed => Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into())),
            Self::Debian { linker } => {
                let mut cargo = Command::new(DEBIAN_CARGO);
                cargo
                    .env("RUSTC", DEBIAN_RUSTC)
                    .env("RUSTC_BOOTSTRAP", "1")
                    .env("CARGO_UNSTABLE_BUILD_STD", "std,panic_abort")
                    .env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", linker)
                    .env_remove("RUSTUP_TOOLCHAIN");
                cargo
            }
        }
    }
}

fn sysroot(rustc: &str) -> Result<PathBuf> {
    let output = Command::new(rustc).args(["--print", "sysroot"]).output().context("no rustc")?;
    Ok(PathBuf::from(String::from_utf8(output.stdout)?.trim()))
}

fn has_target(sysroot: &Path) -> bool {
    sysroot.join("lib/rustlib").join(TARGET).join("lib").is_dir()
}

fn add_with_rustup() -> bool {
    println!("adding the Rust target {TARGET}");
    run_within_limit(Command::new("rustup").args(["target", "add", TARGET]))
}

/// Installs Debian's compiler where apt is at hand and may be used.
fn debian(sysroot: &Path) -> Result<Compiler> {
    let linker = linker(sysroot)?;
    let source = Path::new("/usr/lib/rustlib/src/rust/library/std");
    if !(Path::new(DEBIAN_CARGO).exists() && source.exists()) {
        println!("installing Debian's {}", DEBIAN_PACKAGES.join(", "));
        let mut apt = Command::new("apt-get");
        apt.env("DEBIAN_FRONTEND", "noninteractive");
        apt.args(["install", "-y", "-q", "--no-install-recommends"]).args(DEBIAN_PACKAGES);
        let updated = run_within_limit(Command::new("apt-get").args(["update", "-q"]));
        if !(updated && run_within_limit(&mut apt) && source.exists()) {
            bail!("apt could not install {}", DEBIAN_PACKAGES.join(", "));
        }
    }
    Ok(Compiler::Debian { linker })
}

/// The linker that rustup's compiler brings.
fn linker(sysroot: &Path) -> Result<PathBuf> {
    let rustlib = sysroot.join("lib/rustlib");
    let hosts = rustlib.read_dir().with_context(|| rustlib.display().to_string())?;
    hosts
        .filter_map(|host| Some(host.ok()?.path().join("bin/rust-lld")))
        .find(|linker| linker.exists())
        .context("no rust-lld beside rustc")
}

/// Runs a command without input; false when it fails, does not start or takes too long.
fn run_within_limit(command: &mut Command) -> bool {
    let Ok(mut child) = command.stdin(Stdio::null()).spawn() else { return false };
    let end = Instant::now() + TIME_LIMIT;
    while Instant::now() < end {
        match child.try_wait() {
            Ok(Some(status)) => return status.success(),
            Ok(None) => thread::sleep(Duration::from_millis(100)),
            Err(_) => return false,
        }
    }
    // Too late for its result either way.
    let _ = child.kill().and_then(|()| child.wait().map(drop));
    false
}
