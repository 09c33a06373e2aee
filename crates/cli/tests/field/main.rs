//! What people who do this job ran into, each with the right answer: files and cases as they have them, typed
//! mistakes, and hostile input. A module is one such problem.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

#[cfg(unix)]
mod strangers;
mod support;

#[cfg(unix)]
mod adv_01_links_of_a_results_folder;
#[cfg(unix)]
mod adv_02_ids_in_scripts;
#[cfg(unix)]
mod adv_03_ids_and_links_of_a_study;
#[cfg(unix)]
mod adv_04_folder_names_in_scripts;
mod adv_05_fans_of_triangles;
#[cfg(unix)]
mod adv_06_limit_of_address_space;
#[cfg(unix)]
mod adv_07_control_characters;
#[cfg(unix)]
mod adv_08_small_ones;
mod adv_09_lateral_tow;
mod adv_10_single_precision_pressed;
mod adv_11_cones_on_few_cells;
mod adv_12_vertical_force_of_a_held_body;
mod falling_block;
mod field_01_calibrate_first_row_zero;
mod field_03_geotiff_in_feet;
mod field_05_motion_table_column_name;
mod field_07_plane_strain_bearing_depth;
mod field_08_thin_walled_mesh;
mod field_09_decimal_comma_other_readers;
mod field_11_obj_concave_polygon;
mod field_13_cone_no_closed_form;
mod field_14_forecast_pull_of_grousered_wheel;
mod field_15_measured_csv_dialects;
mod field_18_scattered_and_asc_heights;
mod field_19_vane_torque;
mod field_20_floor_of_the_tray;
mod field_20_tray_of_soil;
mod field_21_overburden_in_a_closed_box;
mod user_11_study_page;
mod user_12_dimensionless_weight;
mod user_13_values_no_soil_has;
mod user_14_void_under_soil;
mod user_16_dimensionless_curve;
mod user_17_study_progress;
mod user_18_contact_stress;
mod user_19_vertical_noise;
mod user_20_noise_at_zero_pull;
