//! Unit aliases: endings such as `_deg`, `_t` and `_kN` for units that engineers use; the names are read as
//! their SI names.

use std::f64::consts::PI;

/// An ending of a name, the corresponding SI ending, and the conversion factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnitAlias {
    /// The ending as written: `_deg`.
    pub ending: &'static str,
    /// The ending of the SI name: `_rad`.
    pub si: &'static str,
    /// SI value = factor * written value.
    pub factor: f64,
}

const fn alias(ending: &'static str, si: &'static str, factor: f64) -> UnitAlias {
    UnitAlias { ending, si, factor }
}

const DEGREE: f64 = PI / 180.0;

/// Every unit alias. No alias is the ending of another alias.
pub const UNIT_ALIASES: [UnitAlias; 17] = [
    alias("_deg", "_rad", DEGREE),
    alias("_deg_s", "_rad_s", DEGREE),
    alias("_deg_s2", "_rad_s2", DEGREE),
    alias("_deg_s3", "_rad_s3", DEGREE),
    alias("_kW", "_W", 1000.0),
    alias("_t", "_kg", 1000.0),
    alias("_t_m2", "_kg_m2", 1000.0),
    alias("_kN", "_N", 1000.0),
    alias("_kN_m", "_N_m", 1000.0),
    alias("_kN_m_s", "_N_m_s", 1000.0),
    alias("_kN_s_m", "_N_s_m", 1000.0),
    alias("_kN_m_per_rad", "_N_m_per_rad", 1000.0),
    alias("_kN_m_s_per_rad", "_N_m_s_per_rad", 1000.0),
    alias("_GPa", "_Pa", 1e9),
    alias("_bar", "_Pa", 1e5),
    alias("_kN_per_m", "_N_per_m", 1000.0),
    alias("_kN_s_per_m", "_N_s_per_m", 1000.0),
];

/// Endings of the names of quantities in SI units, and the unit of each.
const SI_ENDINGS: [(&str, &str); 35] = [
    ("_s", "s"),
    ("_m", "m"),
    ("_rad", "rad"),
    ("_kg", "kg"),
    ("_N", "N"),
    ("_Pa", "Pa"),
    ("_Hz", "Hz"),
    ("_m2", "m^2"),
    ("_m4", "m^4"),
    ("_m_s", "m/s"),
    ("_m_s2", "m/s^2"),
    ("_m_s3", "m/s^3"),
    ("_rad_s", "rad/s"),
    ("_rad_s2", "rad/s^2"),
    ("_rad_s3", "rad/s^3"),
    ("_W", "W"),
    ("_rad_per_m", "rad/m"),
    ("_s_per_m", "s/m"),
    ("_s_per_rad", "s/rad"),
    ("_kg_m2", "kg m^2"),
    ("_kg_m3", "kg/m^3"),
    ("_kg_per_m", "kg/m"),
    ("_N_m", "N m"),
    ("_N_m2", "N m^2"),
    ("_N_per_m3", "N/m^3"),
    ("_N_per_m", "N/m"),
    ("_N_m_s", "N m s"),
    ("_N_s_m", "N s/m"),
    ("_N_s2_m2", "N s^2/m^2"),
    ("_N_m_s2", "N m s^2"),
    ("_N_s_per_m", "N s/m"),
    ("_N_per_m_s", "N/(m s)"),
    ("_N_m_per_rad", "N m/rad"),
    ("_N_m_s_per_rad", "N m s/rad"),
    ("_N_m_per_rad_s", "N m/(rad s)"),
];

/// Returns the longest ending of a name that is a unit, and the unit.
pub(super) fn si_ending(name: &str) -> Option<(&'static str, &'static str)> {
    let known = SI_ENDINGS.into_iter();
    known.filter(|(ending, _)| name.ends_with(ending)).max_by_key(|(ending, _)| ending.len())
}

/// Returns the SI value of a unit, if it is a unit of the same quantity: `kN` for N, `deg/s` for rad/s.
pub(super) fn factor_of(unit: &str, si: &str) -> Option<f64> {
    let written = units_for(si).into_iter().find(|(written, _)| written == unit);
    written.map(|(_, factor)| factor)
}

/// Returns the units in which a quantity can be written, the SI unit first, each with its value in SI units.
pub(super) fn units_for(si: &str) -> Vec<(String, f64)> {
    let stem = |ending: &'static str| ending[1..].split('_').next().unwrap_or_default();
    let of = |alias: &UnitAlias| {
        let (_, unit) = SI_ENDINGS.iter().find(|(ending, _)| *ending == alias.si)?;
        (*unit == si).then(|| (unit.replacen(stem(alias.si), stem(alias.ending), 1), alias.factor))
    };
    let aliases = UNIT_ALIASES.iter().filter_map(of);
    core::iter::once((si.to_owned(), 1.0)).chain(aliases).collect()
}

/// Returns the SI name and the factor, if the name ends in a unit alias.
pub(super) fn si_name(name: &str) -> Option<(String, f64)> {
    // A stiffness per degree is not an angle: it has no alias.
    if name.ends_with("_per_deg") {
        return None;
    }
    UNIT_ALIASES.iter().find_map(|alias| {
        let stem = name.strip_suffix(alias.ending)?;
        Some((format!("{stem}{}", alias.si), alias.factor))
    })
}

/// Returns the other names under which the quantity with this SI name can be written.
pub(super) fn aliases_of(name: &str) -> impl Iterator<Item = String> + '_ {
    let written = |alias: &UnitAlias| Some(format!("{}{}", name.strip_suffix(alias.si)?, alias.ending));
    UNIT_ALIASES.iter().filter_map(written).filter(move |written| si_name(written).is_some_and(|(si, _)| si == name))
}

/// Returns the SI path of a path whose quantity ends in a unit alias (`bodies.ship.mass_t`,
/// `...orientation_deg.2`), and the factor; without an alias the same path and 1.
pub(super) fn si_path(path: &[String]) -> (Vec<String>, f64) {
    let mut si = path.to_vec();
    let is_index = |segment: &String| segment.parse::<usize>().is_ok();
    let quantity = match si.as_mut_slice() {
        [.., quantity, last] if is_index(last) => Some(quantity),
        [.., last] => Some(last),
        [] => None,
    };
    if let Some(segment) = quantity
        && let Some((name, factor)) = si_name(segment)
    {
        *segment = name;
        return (si, factor);
    }
    (si, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// SI prefixes, the tonne of 1000 kg, the bar of 100,000 Pa (BIPM, *The International System of Units*,
    /// 9th ed., tables 7 and 8), and the turn of 360 degrees.
    #[test]
    fn each_alias_has_the_factor_of_its_prefix() {
        let of_prefix = [("_deg", PI / 180.0), ("_k", 1e3), ("_t", 1e3), ("_GPa", 1e9), ("_bar", 1e5)];
        for UnitAlias { ending, si, .. } in UNIT_ALIASES {
            let (_, expected) = of_prefix.iter().find(|(prefix, _)| ending.starts_with(prefix)).unwrap();
            assert_eq!(si_name(&format!("x{ending}")), Some((format!("x{si}"), *expected)), "{ending}");
        }
    }
}
