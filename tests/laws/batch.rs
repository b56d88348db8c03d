//! The ground in lanes of eight against the scalar code it is copied from, over random valid grounds.

use crate::draw::{Ground, ground};
use crate::{Verdict, ask, report, within};
use groundwave::soil::{GroundSolver, Solver};

/// A hundred wavenumbers around that of the input.
fn as_scalar(input: &Ground) -> Verdict {
    let prepared =
        Solver::DirectStiffness.prepare(&input.profile(), input.omega, &[]).map_err(|e| e.to_string())?;
    let k: Vec<f64> = (0..100).map(|i| input.k * 1.04f64.powi(i - 50)).collect();
    let mut worst = 0.0f64;
    for (k, lanes) in k.iter().zip(prepared.u_zz_many(&k)) {
        let exact = prepared.u_zz(*k);
        let gap = (lanes - exact).norm() / exact.norm() / input.cost(*k);
        // in units of what stiffness matrices cost: both round, in another order
        worst = worst.max(within(gap, 1e-11, || format!("k = {k}: {lanes} {exact}"))?);
    }
    Ok(worst)
}

#[test]
fn lanes_are_the_scalar_code() {
    report("lanes", ask(2000, &ground((1e-3, 100.0), (1e-2, 1e4)), as_scalar));
}
