//! The study of the ground at depth, from a case to its answers: a rectangle that stands on a half-space.

use groundwave::Silent;
use groundwave::case::Case;
use std::f64::consts::PI;

/// σ_z/q below the corner of a rectangle with sides mz and nz: Newmark 1935, as in Poulos & Davis 1974, section 3.4.
fn corner(m: f64, n: f64) -> f64 {
    let (sum, both) = (m * m + n * n + 1.0, m * m * n * n);
    let root = 2.0 * m * n * sum.sqrt();
    (root / (sum + both) * (sum + 1.0) / sum + (root / (sum - both)).atan()) / (4.0 * PI)
}

#[test]
fn pressure_under_the_middle_of_a_rectangle() {
    let case = "title = \"rectangle\"\n[soil.half_space]\nyoung = \"50 MPa\"\npoisson = 0.3\ndensity = 1800.0\nloss_factor = 0.04\n\
                [track]\nkind = \"none\"\nload = { kind = \"patch\", half_length = 1.0, half_width = 0.75, compatibility = \"centre\" }\n\
                [train]\naxles = [{ position = 0.0, load = \"120 kN\" }]\n[ground_at_depth]\nz = [1.5, 3.0, 6.0]\n";
    let case = Case::parse(case, "case.toml", &|_| Err(String::new())).unwrap();
    let outcome = case.studies[0].run(&case.railway, &Silent).unwrap();
    let found = outcome.group.get("max_compression").unwrap().values.clone();
    for (i, z) in [1.5, 3.0, 6.0].into_iter().enumerate() {
        let exact = 120e3 / 3.0 * 4.0 * corner(1.0 / z, 0.75 / z);
        let error = found[[0, i]] / exact - 1.0;
        println!("{z} m: {error:e}");
        // measured below
        assert!(error.abs() < 1e-4, "{z} m: {error:e}");
    }
}
