//! Scenarios whose numbers are changed one by one, with the files that they name.

use kingpost::scenario::{Files, Host};
use std::borrow::Cow;
use std::fs;
use std::path::{Path, PathBuf};

/// A scenario and the files that it names.
pub struct Case {
    pub name: &'static str,
    pub text: String,
    pub files: Files,
}

/// The text of a file of the gallery, and the files that it may name.
pub fn gallery(name: &'static str) -> (String, Files) {
    let text = fs::read_to_string(folder().join(name)).expect("a file of the gallery");
    (text, Files::of(Tables))
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios")
}

/// The gallery's files, a record of waves and a table of RAOs.
#[derive(Debug)]
struct Tables;

impl Host for Tables {
    fn text(&self, name: &str) -> Option<Cow<'_, str>> {
        match name {
            "record.csv" => Some(Cow::Owned(record())),
            "raos.csv" => Some(Cow::Owned(raos())),
            _ => {
                let path = folder().join(name.strip_prefix("gallery:").unwrap_or(name));
                fs::read_to_string(path).ok().map(Cow::Owned)
            }
        }
    }
}

/// Eight seconds of two waves.
fn record() -> String {
    let row = |i: i32| {
        let t = 0.5 * f64::from(i);
        format!("{t},{}\n", 0.3 * libm::cos(0.8 * t) + 0.2 * libm::sin(1.6 * t))
    };
    format!("time_s,elevation_m\n{}", (0..16).map(row).collect::<String>())
}

/// RAOs that change with direction and frequency.
fn raos() -> String {
    let modes = ["surge_forward", "sway_port", "heave_up", "roll_port_up", "pitch_bow_down", "yaw_bow_port"];
    let units = ["m_per_m", "m_per_m", "m_per_m", "deg_per_m", "deg_per_m", "deg_per_m"];
    let name =
        |(mode, unit): (&&str, &&str)| format!("{mode}_{unit},{}_lag_deg", mode.split('_').next().unwrap_or_default());
    let names: Vec<String> = modes.iter().zip(&units).map(name).collect();
    let row = |(direction, frequency): (i32, i32)| {
        let of = |mode: i32| {
            format!("{},{}", 0.2 + 0.1 * f64::from(mode) + 0.001 * f64::from(direction), 10 * mode + frequency)
        };
        let numbers: Vec<String> = (0..6).map(of).collect();
        format!("{direction},{},{}\n", 0.1 + 0.5 * f64::from(frequency), numbers.join(","))
    };
    let grid = (0..=6).flat_map(|k| (0..6).map(move |frequency| (30 * k, frequency)));
    format!("direction_to_deg,frequency_rad_s,{}\n{}", names.join(","), grid.map(row).collect::<String>())
}
