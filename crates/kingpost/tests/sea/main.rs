//! Water and wind: hulls, tanks, waves, moorings, thrusters.

#[path = "../common/mod.rs"]
mod common;

mod another_sea;
mod box_tanks;
mod catenary;
mod column_response;
mod coupled_hulls;
mod current_profiles;
mod drift_damping;
mod dynamic_positioning;
mod gusts;
mod held_in_waves;
mod hull;
mod hull_identities;
mod hull_stability;
mod hydrodynamic_databases;
mod hydrostatics;
mod listing_hulls;
mod mooring;
mod plausible_data;
mod random_sea;
mod raos;
mod sea_view;
mod slack_tanks;
mod slow_motion;
mod soft_hold;
mod thrust_allocation;
mod trailing_edges;
mod vessel;
mod water;
mod wave_field;
mod wave_loads;
mod wave_response;
mod wave_spectra;
mod wind_and_current;
