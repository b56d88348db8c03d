//! The ground beside a rough track: wavenumbers and expected values against a march in time.
//!
//! The march shares with the library G(k, ω), the matrices of the track and the mass of the wheel: transfer functions of a force
//! that stands, by plain sums over β_y and β; impulse responses by inverse transform; contact forces from the rail's impulse
//! responses along the way of the wheel; the ground by superposition of what the force does at each place it passes,
//!
//! ```text
//! H(x, ω) = (1/2π) Σ h(β, ω) e^{iβx} Δβ      g(x, t) = (1/π) Re Σ H(x, ω) e^{iωt} Δω
//! α(ω̃) = Σ g_rail(vt, t) e^{−iω̃t} Δt         u(t) = Σ P(τ) g(vτ, t − τ) Δτ
//! ```

use crate::common::{STRIP, named, tracks};
use groundwave::assessment::Band;
use groundwave::contact::WheelRail;
use groundwave::dataset::Group;
use groundwave::field::{Channel, Section, Sections};
use groundwave::foundation::LayeredSoil;
use groundwave::irregularity::{Component, German, Realisation, Spectrum};
use groundwave::progress::Silent;
use groundwave::rail::{InteractionError, TrackOnFoundation};
use groundwave::railway::{Contact, Ground, Railway, Support};
use groundwave::soil::{DirectStiffness, GroundSolver, Motion, PreparedGround, Profile, Solver, ThinLayer};
use groundwave::study::{Carrier, FreeField, Irregularity, Roughness};
use groundwave::track::Stack;
use groundwave::vehicle::{Axle, Multibody, Train};
use num_complex::Complex64;
use rayon::prelude::*;
use rustfft::FftPlanner;
use std::f64::consts::{PI, TAU};

/// v [m/s], y [m]
const SPEED: f64 = 67.5;
const RECEIVER: f64 = 8.0;
/// M [kg] and k_H [N/m] of a wheelset.
const MASS: f64 = 2003.0;
const CONTACT: f64 = 1.94e9;

const SPECTRUM: Spectrum = Spectrum::German { quality: German::Low };

/// Slower and faster than the waves of the ground that matter [m/s].
const SLOW: f64 = 114.0;
const FAST: f64 = 250.0;

// ---------------------------------------------------------------------------------------------------------------------------
// the march

fn taper(x: f64, from: f64, to: f64) -> f64 {
    let s = ((x.abs() - from) / (to - from)).clamp(0.0, 1.0);
    0.5 + 0.5 * (PI * s).cos()
}

/// G at one ω, tabled on points even in asinh(k/k₀).
struct Table {
    unit: f64,
    values: Vec<Complex64>,
}

const TABLE_STEP: f64 = 0.003;

impl Table {
    fn new(ground: &dyn PreparedGround, unit: f64, top: f64) -> Self {
        let count = ((top / unit).asinh() / TABLE_STEP) as usize + 4;
        let values =
            (0..count).map(|i| ground.u_zz(unit * (i as f64 * TABLE_STEP).sinh().max(1e-9))).collect();
        Self { unit, values }
    }

    /// Cubic through four points.
    fn at(&self, k: f64) -> Complex64 {
        let s = k / self.unit;
        let place = (s + (s * s + 1.0).sqrt()).ln() / TABLE_STEP;
        let i = (place as usize).clamp(1, self.values.len() - 3);
        let t = place - i as f64;
        let (a, b, c) = (t + 1.0, t - 1.0, t - 2.0);
        let v = &self.values[i - 1..i + 3];
        v[0] * (-t * b * c / 6.0) + v[1] * (a * b * c / 2.0) - v[2] * (a * t * c / 2.0)
            + v[3] * (a * t * b / 6.0)
    }
}

/// One node of the sums over β_y: β_y² and the weights of 1/k_eq and of the receiver.
struct Node {
    square: f64,
    strip: f64,
    receiver: f64,
}

/// Trapezoid in t, β_y = k₀ sinh t.
fn nodes(unit: f64, omega: f64, top: f64) -> Vec<Node> {
    let step = 0.014;
    let slow = omega / SLOW;
    (0..=((top / unit).asinh() / step) as usize)
        .map(|i| {
            let t = i as f64 * step;
            let beta = unit * t.sinh();
            let weight = if i == 0 { 0.5 } else { 1.0 } * unit * t.cosh() * step / PI;
            let x = beta * STRIP.half_width;
            let sinc = if x == 0.0 { 1.0 } else { x.sin() / x };
            Node {
                square: beta * beta,
                strip: weight * sinc * taper(beta, 0.5 * top, top),
                receiver: weight * sinc * (beta * RECEIVER).cos() * taper(beta, slow + 4.0, slow + 12.0),
            }
        })
        .collect()
}

#[derive(Clone, Copy, PartialEq)]
enum Of {
    Rail,
    Ground,
}

/// H at x = 0, Δx … (`count` of them) for a force that stands at 0: period `size` Δx.
fn standing(
    of: Of,
    stack: &Stack,
    profile: &Profile,
    f: f64,
    step: f64,
    size: usize,
    count: usize,
) -> Vec<Complex64> {
    let omega = TAU * f;
    let ground = DirectStiffness.prepare(profile, omega, &[]).unwrap();
    let unit = omega / FAST;
    let width = 40.0f64;
    let beta_step = TAU / (size as f64 * step);
    let highest = match of {
        // the rail's own bending there is hundreds of times its support
        Of::Rail => 12.0f64,
        // e^{−1.3·8}
        Of::Ground => (omega / SLOW).hypot(1.3),
    };
    let table = Table::new(ground.as_ref(), unit, width.hypot(highest) + 1.0);
    let nodes = nodes(unit, omega, width);
    let mut spectrum = vec![Complex64::ZERO; size];
    let mut stiffness = Complex64::ONE;
    for n in 0..=size / 2 {
        let beta = n as f64 * beta_step;
        let mut receiver = Complex64::ZERO;
        if beta < highest {
            let mut strip = Complex64::ZERO;
            for node in &nodes {
                let g = table.at((beta * beta + node.square).sqrt());
                strip += g * node.strip;
                receiver += g * node.receiver;
            }
            stiffness = 1.0 / strip;
        } else if of == Of::Ground {
            break;
        }
        let u = stack.respond(beta, omega, stiffness);
        let value = match of {
            Of::Rail => u.rail,
            Of::Ground => u.base * stiffness * receiver,
        } * (beta_step / TAU);
        spectrum[n] = value;
        spectrum[(size - n) % size] = value;
    }
    FftPlanner::new().plan_fft_inverse(size).process(&mut spectrum);
    spectrum.truncate(count);
    spectrum
}

/// α(ω̃) of the rail under a moving force from the impulse responses along its way, and the share of the energy of g_rail(0, t)
/// before its cause.
fn moving_rail(stack: &Stack, profile: &Profile, driving: &[f64]) -> (Vec<Complex64>, f64) {
    // a second before and after; 256 Hz
    let (rate, top, df, reach) = (512.0, 256.0, 0.5, 512usize);
    let step = SPEED / rate;
    let lines: Vec<(f64, Vec<Complex64>)> = (1..(top / df) as usize)
        .into_par_iter()
        .map(|i| {
            let f = i as f64 * df;
            let mut h = standing(Of::Rail, stack, profile, f, step, 4096, reach + 1);
            h.iter_mut().for_each(|h| *h *= taper(f, 200.0, 256.0));
            (f, h)
        })
        .collect();
    let impulse = |place: usize, t: f64| {
        let moving: f64 = lines.iter().map(|(f, h)| (h[place] * Complex64::cis(TAU * f * t)).re).sum();
        2.0 * df * (moving + 0.5 * lines[0].1[place].re)
    };
    let history: Vec<(f64, f64)> = (-(reach as i64)..=reach as i64)
        .into_par_iter()
        .map(|n| {
            let t = n as f64 / rate;
            (t, impulse(n.unsigned_abs() as usize, t) * taper(t, 0.8, 1.0))
        })
        .collect();
    let standing: Vec<(f64, f64)> =
        (-500..500).map(|n| (f64::from(n) / rate, impulse(0, f64::from(n) / rate))).collect();
    let energy =
        |early: bool| -> f64 { standing.iter().filter(|s| !early || s.0 < -0.02).map(|s| s.1 * s.1).sum() };
    let alpha = driving
        .iter()
        .map(|w| history.iter().map(|&(t, g)| g * Complex64::cis(-w * t)).sum::<Complex64>() / rate)
        .collect();
    (alpha, energy(true) / energy(false))
}

/// What the march says of the ground: u(t) every `step` from some time on, and the share of the energy of g(0, t) before its cause.
fn march(stack: &Stack, profile: &Profile, force: &(dyn Fn(f64) -> f64 + Sync)) -> (f64, Vec<f64>, f64) {
    let rate = 256.0;
    let (size, early) = (2048usize, 128usize);
    let df = rate / size as f64;
    let step = SPEED / rate;
    // force on 600 m either side of the receiver
    let reach = (600.0 / step) as usize;
    let lines: Vec<Vec<Complex64>> = (1..(115.0 / df) as usize)
        .into_par_iter()
        .map(|i| {
            let f = i as f64 * df;
            // damping fades long waves over kilometres
            let period = if f < 6.0 {
                32768
            } else if f < 20.0 {
                8192
            } else {
                4096
            };
            let mut h = standing(Of::Ground, stack, profile, f, step, period, reach + 1);
            h.iter_mut().for_each(|h| *h *= taper(f, 95.0, 115.0));
            h
        })
        .collect();
    let transform = FftPlanner::new().plan_fft_inverse(size);
    let impulse = |place: usize| -> Vec<f64> {
        let mut line = vec![Complex64::ZERO; size];
        line[0] = Complex64::from(lines[0][place].re);
        for (i, h) in lines.iter().enumerate() {
            line[i + 1] = h[place];
            line[size - 1 - i] = h[place].conj();
        }
        transform.process(&mut line);
        (0..size).map(|j| df * line[(j + size - early) % size].re).collect()
    };
    let at = impulse(0);
    let share = at[..early - 5].iter().map(|g| g * g).sum::<f64>() / at.iter().map(|g| g * g).sum::<f64>();
    let total = 2 * reach + 1 + size;
    let chunk = 100;
    let u = (0..=reach)
        .collect::<Vec<_>>()
        .par_chunks(chunk)
        .map(|places| {
            let mut u = vec![0.0; total];
            for &place in places {
                let g = impulse(place);
                let sides: &[i64] = if place == 0 { &[1] } else { &[1, -1] };
                for side in sides {
                    let index = side * place as i64;
                    let p = force(index as f64 / rate) / rate;
                    let from = (index + reach as i64) as usize;
                    for (u, g) in u[from..].iter_mut().zip(&g) {
                        *u += p * g;
                    }
                }
            }
            u
        })
        .reduce(|| vec![0.0; total], |a, b| a.iter().zip(&b).map(|(a, b)| a + b).collect());
    (1.0 / rate, u, share)
}

/// ∫ 2ω²|û|² df over each band.
fn band_energies(step: f64, u: &[f64], bands: &[Band]) -> Vec<f64> {
    let size = 4 * u.len().next_power_of_two();
    let mut line: Vec<Complex64> = u.iter().map(|u| Complex64::from(u * step)).collect();
    line.resize(size, Complex64::ZERO);
    FftPlanner::new().plan_fft_forward(size).process(&mut line);
    let df = 1.0 / (size as f64 * step);
    let energy = |band: &Band| {
        (0..size / 2)
            .map(|i| {
                let f = i as f64 * df;
                let inside = (f + 0.5 * df).min(band.upper()) - (f - 0.5 * df).max(band.lower());
                2.0 * (TAU * f).powi(2) * line[i].norm_sqr() * inside.max(0.0)
            })
            .sum()
    };
    bands.iter().map(energy).collect()
}

// ---------------------------------------------------------------------------------------------------------------------------
// the library

fn wheel(axles: &[f64]) -> Multibody {
    Multibody::unsprung(MASS, 150e3).unwrap().row(axles).unwrap()
}

/// Forces per metre of e^{iΩx} and α, at each driving frequency [rad/s].
fn library_forces(stack: &Stack, driving: &[f64]) -> (Vec<Complex64>, Vec<Complex64>) {
    let soil = LayeredSoil::new(named("paper_layered"), Solver::DirectStiffness, STRIP).unwrap();
    let track = TrackOnFoundation::new(stack, &soil, 0.0);
    let bodies = wheel(&[0.0]);
    let wheels = WheelRail { track: &track, bodies: &bodies, contact: &[CONTACT], speed: SPEED };
    driving
        .par_iter()
        .map(|&w| {
            let (alpha, worst) = wheels.rail(w).unwrap();
            assert!(worst <= 1.0);
            (wheels.forces(&alpha, w)[0], alpha[(0, 0)])
        })
        .unzip()
}

/// Cells (f, width) of bands, `per_band` in each.
fn cells(bands: &[Band], per_band: usize) -> Vec<(f64, f64)> {
    let cell = |band: &Band, i: usize| {
        let ratio = (band.upper() / band.lower()).powf(1.0 / per_band as f64);
        let from = band.lower() * ratio.powi(i as i32);
        (from * ratio.sqrt(), from * (ratio - 1.0))
    };
    bands.iter().flat_map(|b| (0..per_band).map(move |i| cell(b, i))).collect()
}

/// h((±ω̃ − ω)/v, ω) of every driving frequency, at every cell.
fn transfers(stack: &Stack, driving: &[f64], cells: &[(f64, f64)]) -> Vec<Vec<[Complex64; 2]>> {
    let profile = named("paper_layered");
    let channels = Channel::all(&[RECEIVER], &[Motion::Vertical]);
    cells
        .par_iter()
        .map(|&(f, _)| {
            let omega = TAU * f;
            let ground = DirectStiffness.prepare(&profile, omega, &[]).unwrap();
            let section = Section::new(stack, (ground.as_ref(), ground.as_ref()), STRIP, omega, &channels);
            assert!(section.worst <= 1.0);
            driving.iter().map(|w| [w, &-w].map(|w| section.transfer(0, (w - omega) / SPEED))).collect()
        })
        .collect()
}

/// Band energies of û(ω) = Σ ½a/v (e^{iθ} P h₊ + conj(e^{iθ} P) h₋).
fn library_energies(
    components: &[Component],
    forces: &[Complex64],
    transfers: &[Vec<[Complex64; 2]>],
    cells: &[(f64, f64)],
    per_band: usize,
) -> Vec<f64> {
    let density = |(h, &(f, width)): (&Vec<[Complex64; 2]>, &(f64, f64))| {
        let u: Complex64 = components
            .iter()
            .zip(forces)
            .zip(h)
            .map(|((c, p), h)| {
                let p = Complex64::cis(c.phase) * p * (0.5 * c.amplitude / SPEED);
                p * h[0] + p.conj() * h[1]
            })
            .sum();
        2.0 * (TAU * f).powi(2) * u.norm_sqr() * width
    };
    let all: Vec<f64> = transfers.iter().zip(cells).map(density).collect();
    all.chunks(per_band).map(|band| band.iter().sum()).collect()
}

/// Driving frequencies [rad/s].
fn driving(components: &[Component]) -> Vec<f64> {
    components.iter().map(|c| c.wavenumber * SPEED).collect()
}

#[test]
fn one_wheel_in_time() {
    let (stack, profile) = (tracks::ballasted(), named("paper_layered"));
    // ten components from 2.2 to 78 Hz; amplitudes such that no band is empty, phases of a profile with a seed
    let seeded = Realisation::of(&SPECTRUM, (SPEED / 80.0, SPEED / 2.0), 10, 7).unwrap();
    let components: Vec<Component> = (0..10)
        .map(|j| {
            let f = 2.2 * (78.0f64 / 2.2).powf(j as f64 / 9.0);
            let phase = seeded.components()[j].phase;
            Component { wavenumber: TAU * f / SPEED, amplitude: 1e-3 * (2.2 / f).powi(3), phase }
        })
        .collect();
    let driving = driving(&components);
    let (forces, alpha) = library_forces(&stack, &driving);
    let (own_alpha, early) = moving_rail(&stack, &profile, &driving);
    println!("before its cause, rail: {early:e} of the energy");
    // hysteretic damping is not quite causal; measured 3.8e-5, and 4.4e-6 on the ground below
    assert!(early < 1e-4, "{early:e}");
    let own: Vec<Complex64> = driving
        .iter()
        .zip(&own_alpha)
        .map(|(w, a)| -1.0 / (a - 1.0 / (MASS * w * w) + 1.0 / CONTACT))
        .collect();
    for (j, w) in driving.iter().enumerate() {
        let receptance = (own_alpha[j] / alpha[j] - 1.0).norm();
        let force = (own[j] / forces[j] - 1.0).norm();
        println!("{:6.2} Hz: receptance {receptance:.2e}, force {force:.2e}", w / TAU);
        // measured 4.7e-4 at 2.2 Hz, where g_rail is cut after a second, and 4.7e-4 at 78 Hz, where H is cut at 256 Hz
        assert!(receptance < 1e-3 && force < 1e-3, "{receptance:e} {force:e}");
    }

    let bands = Band::range(2.0, 80.0).unwrap();
    let force = |t: f64| {
        let sum: f64 = components
            .iter()
            .zip(&driving)
            .zip(&own)
            .map(|((c, w), p)| c.amplitude * (p * Complex64::cis(w * t + c.phase)).re)
            .sum();
        sum * taper(SPEED * t, 400.0, 600.0)
    };
    let (step, u, early) = march(&stack, &profile, &force);
    println!("before its cause, ground: {early:e} of the energy");
    assert!(early < 1e-5, "{early:e}");
    let in_time = band_energies(step, &u, &bands);

    // a single run has Doppler peaks near edges of bands: ten cells in a band instead of these miss 2.4 % of it
    let per_band = 20;
    let cells = cells(&bands, per_band);
    let h = transfers(&stack, &driving, &cells);
    let library = library_energies(&components, &forces, &h, &cells, per_band);
    let largest = library.iter().copied().fold(0.0, f64::max);
    for ((band, a), b) in bands.iter().zip(&in_time).zip(&library) {
        let difference = (a / b).sqrt() - 1.0;
        println!(
            "{:>5} Hz: {:9.2e} of the largest energy, r.m.s. {difference:+.4}",
            band.label(),
            b / largest
        );
        // bands with energy: measured 1.7e-3; the others, to which low components leak and in which waves fade over more than the
        // 600 m of the force, 9.1e-3 at 3.15 Hz
        let allowed = if *b > 0.01 * largest { 5e-3 } else { 0.02 };
        assert!(difference.abs() < allowed, "{difference}");
    }
    // u[n] at (n − reach − early) Δt
    let first = -((600.0 / (SPEED * step)).floor() + 128.0) * step;
    history_in_time(&components, &bands, &March { first, step, u });
}

/// u(t) of the march [m]: time of its first sample, step, values.
struct March {
    first: f64,
    step: f64,
    u: Vec<f64>,
}

impl March {
    /// Velocity at `times` of what lies below `highest` [Hz].
    fn velocity(&self, times: &[f64], highest: f64) -> Vec<f64> {
        let size = 2 * self.u.len().next_power_of_two();
        let mut line: Vec<Complex64> = self.u.iter().map(|u| Complex64::from(*u)).collect();
        line.resize(size, Complex64::ZERO);
        FftPlanner::new().plan_fft_forward(size).process(&mut line);
        let df = 1.0 / (size as f64 * self.step);
        let at = |t: &f64| -> f64 {
            (1..(highest / df) as usize)
                .map(|n| {
                    let omega = TAU * n as f64 * df;
                    (Complex64::new(0.0, 2.0 * omega / size as f64)
                        * line[n]
                        * Complex64::cis(omega * (t - self.first)))
                    .re
                })
                .sum()
        };
        times.par_iter().map(at).collect()
    }
}

/// The study's history on the profile of `components` against the march of the same.
fn history_in_time(components: &[Component], bands: &[Band], march: &March) {
    let study = given(components.to_vec(), bands, &[0.0]);
    let group = study.run(&model(Solver::DirectStiffness), &Silent).unwrap().group;
    let values = |name: &str| -> Vec<f64> { group.get(name).unwrap().values.iter().copied().collect() };
    let (time, v) = (values("time"), values("v_dynamic"));
    let some: Vec<usize> = (0..time.len()).filter(|i| time[*i].abs() < 1.0 && i % 5 == 0).collect();
    let times: Vec<f64> = some.iter().map(|&i| time[i]).collect();
    let own = march.velocity(&times, bands[bands.len() - 1].upper());
    let size = own.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let worst = some.iter().zip(&own).map(|(&i, o)| (v[i] - o).abs()).fold(0.0, f64::max) / size;
    println!("history: worst {worst:e} of the largest");
    // at its worst instant. Measured 1.36e-2
    assert!(worst < 0.02, "{worst:e}");
}

// ---------------------------------------------------------------------------------------------------------------------------
// quick ones

/// One axle on the ballasted track.
fn model(solver: Solver) -> Railway {
    let train = Train::new(vec![Axle { position: 0.0, load: 150e3 }]).unwrap();
    let support = Support::Ground(Ground::new(named("paper_layered"), solver, Some(Contact::Strip(STRIP))));
    Railway::new(support, tracks::ballasted(), Some(train)).unwrap()
}

fn study(bands: &[Band], wavelengths: (f64, f64)) -> FreeField {
    FreeField {
        speed: SPEED,
        receivers: vec![RECEIVER],
        passage_time: Some(1.0),
        components: Default::default(),
        bands: bands.to_vec(),
        sections: None,
        assessment: Default::default(),
        building: Default::default(),
        roughness: Some(Roughness {
            bodies: wheel(&[0.0]),
            contact: vec![CONTACT],
            irregularity: Irregularity::Random { spectrum: SPECTRUM, wavelengths, seed: 1, count: 1 },
        }),
    }
}

/// The same on a profile of these components, wheels on `axles` [m].
fn given(components: Vec<Component>, bands: &[Band], axles: &[f64]) -> FreeField {
    let profile = Realisation::new(components, 1e3).unwrap();
    let irregularity = Irregularity::Given { profile, text: "waves".into(), carrier: Carrier::Rail };
    let mut study = study(bands, (1.0, 10.0));
    study.roughness =
        Some(Roughness { bodies: wheel(axles), contact: vec![CONTACT; axles.len()], irregularity });
    study
}

/// Two wheels that do not feel one another pass as one, and as one again: each on the profile where it is.
#[test]
fn wheels_far_apart_pass_one_after_the_other() {
    let bands = Band::range(2.0, 63.0).unwrap();
    // a whole number of samples of the histories
    let step = 1.0 / (8.0 * bands[bands.len() - 1].upper());
    let lag = (1.2 * 100.0 / SPEED / step).ceil() as usize;
    let apart = SPEED * step * lag as f64;
    let waves: Vec<Component> = [0.9, 1.7, 3.1]
        .iter()
        .map(|&wavenumber| Component { wavenumber, amplitude: 1e-4, phase: wavenumber.powi(3) })
        .collect();
    let run = |axles: &[f64]| -> (Vec<f64>, Vec<f64>) {
        let train = axles.iter().map(|&position| Axle { position, load: 150e3 }).collect();
        let thin = Solver::ThinLayer(ThinLayer::default());
        let support = Support::Ground(Ground::new(named("paper_layered"), thin, Some(Contact::Strip(STRIP))));
        let train = Train::new(train).unwrap();
        let model = Railway::new(support, tracks::ballasted(), Some(train)).unwrap();
        let group = given(waves.clone(), &bands, axles).run(&model, &Silent).unwrap().group;
        let values = |name: &str| group.get(name).unwrap().values.iter().copied().collect();
        (values("time"), values("v_total"))
    };
    let ((time, one), (_, two)) = (run(&[0.0]), run(&[0.0, apart]));
    let largest = one.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let mut worst = 0.0f64;
    // both histories begin at the same time; within two seconds all is there
    for i in 0..time.len() {
        let before = if i >= lag { one[i - lag] } else { 0.0 };
        if time[i] > -0.5 && time[i] < 2.0 {
            worst = worst.max((two[i] - one[i] - before).abs() / largest);
        }
    }
    println!("worst {worst:e}");
    // measured 7.8e-3: what is folded in from beyond the ends of the two histories
    assert!(worst < 0.02, "{worst:e}");
}

fn band_rms(study: &FreeField, model: &Railway, part: &str) -> Vec<f64> {
    let outcome = study.run(model, &Silent).unwrap();
    outcome.group.get(part).unwrap().values.iter().copied().collect()
}

#[test]
fn seeds_scatter_about_the_expected_value() {
    let stack = tracks::ballasted();
    let wavelengths = (SPEED / 80.0, SPEED / 4.0);
    let bands = Band::range(8.0, 63.0).unwrap();
    let expected: Vec<f64> =
        band_rms(&study(&bands, wavelengths), &model(Solver::DirectStiffness), "v_rms_dynamic")
            .iter()
            .map(|v| v * v)
            .collect();
    let of = |seed| Realisation::of(&SPECTRUM, wavelengths, 600, seed).unwrap();
    let driving = driving(of(0).components());
    // forces are smooth: asked at a tenth of the driving frequencies
    let (asked, per_band) = (driving.iter().step_by(10).copied().collect::<Vec<_>>(), 12);
    let known = library_forces(&stack, &asked).0;
    let forces: Vec<Complex64> = (0..driving.len())
        .map(|j| {
            let (i, t) = ((j / 10).min(known.len() - 2), 0.1 * j as f64);
            let t = t - i as f64;
            known[i] * (1.0 - t) + known[i + 1] * t
        })
        .collect();
    let cells = cells(&bands, per_band);
    let h = transfers(&stack, &driving, &cells);
    let count = 400;
    let energies: Vec<Vec<f64>> = (0..count)
        .map(|seed| library_energies(of(seed).components(), &forces, &h, &cells, per_band))
        .collect();
    for (b, band) in bands.iter().enumerate() {
        let ratios: Vec<f64> = energies.iter().map(|e| e[b] / expected[b]).collect();
        let mean = ratios.iter().sum::<f64>() / count as f64;
        let variance = ratios.iter().map(|r| (r - mean).powi(2)).sum::<f64>() / (count - 1) as f64;
        let error = (variance / count as f64).sqrt();
        // the mean over all phases in closed form: no cross terms
        let incoherent: f64 = (b * per_band..(b + 1) * per_band)
            .map(|i| {
                let sum: f64 = of(0)
                    .components()
                    .iter()
                    .zip(&forces)
                    .zip(&h[i])
                    .map(|((c, p), h)| {
                        (0.5 * c.amplitude / SPEED).powi(2)
                            * p.norm_sqr()
                            * (h[0].norm_sqr() + h[1].norm_sqr())
                    })
                    .sum();
                2.0 * (TAU * cells[i].0).powi(2) * sum * cells[i].1
            })
            .sum();
        let incoherent = incoherent / expected[b];
        println!("{:>5} Hz: mean {mean:.3} ± {error:.3}, without cross terms {incoherent:.5}", band.label());
        // the error of the mean is 2 to 3.3 %; measured at most 2.3 of them (8 Hz)
        assert!((mean - 1.0).abs() < 3.0 * error, "{mean} ± {error}");
        // r.m.s. measured 5.6e-3 at 8 Hz: the even steps of these 600 components
        assert!((incoherent.sqrt() - 1.0).abs() < 0.01, "{incoherent}");
    }
}

/// √S_P/S of the study, which interpolates α, against forces at each driving frequency.
#[test]
fn forces_of_the_study() {
    let wavelengths = (SPEED / 100.0, SPEED / 1.5);
    let study = study(&Band::range(8.0, 8.0).unwrap(), wavelengths);
    let group = study.run(&model(Solver::DirectStiffness), &Silent).unwrap().group;
    let values = |name: &str| -> Vec<f64> { group.get(name).unwrap().values.iter().copied().collect() };
    let (f, density) = (values("driving_frequency"), values("contact_force"));
    let some: Vec<usize> = (0..f.len()).step_by(7).collect();
    let driving: Vec<f64> = some.iter().map(|&i| TAU * f[i]).collect();
    let (forces, _) = library_forces(&tracks::ballasted(), &driving);
    let (mut worst, mut at) = (0.0f64, 0.0);
    for ((&i, w), p) in some.iter().zip(&driving).zip(&forces) {
        let of_study = (density[i] * SPEED / TAU / SPECTRUM.one_sided(w / SPEED)).sqrt();
        let difference = of_study / p.norm() - 1.0;
        if difference.abs() > worst.abs() {
            (worst, at) = (difference, f[i]);
        }
    }
    println!("worst {worst:e} at {at:.1} Hz");
    // measured 1.4e-3 at 12.7 Hz: α is interpolated where the forces half-way between its entries are foreseen to 1 %
    assert!(worst.abs() < 3e-3, "{worst:e}");
}

/// Many histories carry the expected energy; the seed decides each.
#[test]
fn histories_of_many_profiles() {
    let bands = Band::range(4.0, 63.0).unwrap();
    let mut study = study(&bands, (SPEED / 60.0, SPEED / 5.0));
    let count = 200;
    let many = |seed, count| Irregularity::Random {
        spectrum: SPECTRUM,
        wavelengths: (SPEED / 60.0, SPEED / 5.0),
        seed,
        count,
    };
    let model = model(Solver::DirectStiffness);
    let mut run = |irregularity| {
        study.roughness = study.roughness.clone().map(|r| Roughness { irregularity, ..r });
        study.run(&model, &Silent).unwrap().group
    };
    let group = run(many(1, count));
    let values =
        |group: &Group, name: &str| -> Vec<f64> { group.get(name).unwrap().values.iter().copied().collect() };
    let expected: f64 = values(&group, "v_rms_total").iter().map(|v| v * v).sum();
    let energies = values(&group, "exposure");
    let mean = energies.iter().sum::<f64>() / count as f64;
    let variance = energies.iter().map(|e| (e - mean).powi(2)).sum::<f64>() / (count - 1) as f64;
    let error = (variance / count as f64).sqrt();
    println!("{:.4} ± {:.4} of the expected energy", mean / expected, error / expected);
    // measured 0.989 ± 0.016
    assert!((mean - expected).abs() < 3.0 * error, "{mean} ± {error}, {expected}");
    // seed 3 is the third of them
    let third = run(many(3, 1));
    assert_eq!(values(&third, "exposure")[0], energies[2]);
    assert_ne!(energies[0], energies[1]);
}

/// h between sections against sections there.
#[test]
fn between_sections() {
    let (stack, profile) = (tracks::ballasted(), named("paper_layered"));
    let channels = Channel::all(&[5.0, 20.0], &Motion::ALL);
    let section = |omega: f64| -> Result<Section, InteractionError> {
        let ground = DirectStiffness.prepare(&profile, omega, &[]).unwrap();
        Ok(Section::new(&stack, (ground.as_ref(), ground.as_ref()), STRIP, omega, &channels))
    };
    let sections = Sections::new((1.0, 550.0), &channels, 1.0 / SLOW, section, &Silent).unwrap();
    println!("{} sections", sections.count());
    assert!(sections.worst <= 1.0);
    let mut worst = 0.0f64;
    for i in 0..40 {
        let omega = 1.0 * 550f64.powf((f64::from(i) + 0.31) / 40.0);
        let (here, between) = (section(omega).unwrap(), sections.at(omega));
        for r in 0..channels.len() {
            let betas: Vec<f64> = (-60..60).map(|j| 1.2 * omega / SLOW * f64::from(j) / 60.0).collect();
            let largest = betas.iter().map(|b| here.transfer(r, *b).norm()).fold(0.0, f64::max);
            let off = betas.iter().map(|b| (here.transfer(r, *b) - between.transfer(r, *b)).norm());
            worst = worst.max(off.fold(0.0, f64::max) / largest);
        }
    }
    println!("worst {worst:e}");
    // nothing is made of what lies beyond
    assert!([0.9, 2000.0].iter().all(|omega| sections.at(*omega).transfer(0, 0.0).is_nan()));
    // measured 5.0e-4, as much as one table is off
    assert!(worst < 2e-3, "{worst:e}");
}

#[test]
fn a_smooth_rail_makes_no_force() {
    let bands = Band::range(2.0, 8.0).unwrap();
    let smooth = FreeField { roughness: None, ..study(&bands, (1.0, 10.0)) };
    let model = model(Solver::DirectStiffness);
    assert!(band_rms(&smooth, &model, "v_rms_dynamic").iter().all(|v| *v == 0.0));
    let total = band_rms(&smooth, &model, "v_rms_total");
    assert_eq!(total, band_rms(&smooth, &model, "v_rms_quasi_static"));
    assert!(total.iter().all(|v| *v > 0.0));
    // a profile without amplitude: nothing but the quasi-static part, to its last band
    let none = Component { wavenumber: 2.0, amplitude: 0.0, phase: 1.0 };
    let still = given(vec![none], &bands, &[0.0]);
    assert!(band_rms(&still, &model, "v_rms_dynamic").iter().all(|v| *v == 0.0));
    assert_eq!(band_rms(&still, &model, "v_rms_total"), total);
    let stack = tracks::ballasted();
    let flat: Vec<Component> =
        (1..5).map(|i| Component { wavenumber: f64::from(i), amplitude: 0.0, phase: 1.0 }).collect();
    let driving = driving(&flat);
    let (forces, _) = library_forces(&stack, &driving);
    let cells = cells(&bands, 1);
    let energies = library_energies(&flat, &forces, &transfers(&stack, &driving, &cells), &cells, 1);
    assert!(energies.iter().all(|e| *e == 0.0));
}

#[test]
fn standing_wheels_are_reciprocal() {
    let stack = tracks::ballasted();
    let soil = LayeredSoil::new(named("paper_layered"), Solver::DirectStiffness, STRIP).unwrap();
    let track = TrackOnFoundation::new(&stack, &soil, 0.0);
    let bodies = wheel(&[0.0, 2.5]);
    for f in [5.0, 20.0, 60.0] {
        for speed in [0.0, 1e-3] {
            let wheels = WheelRail { track: &track, bodies: &bodies, contact: &[CONTACT; 2], speed };
            let (alpha, worst) = wheels.rail(TAU * f).unwrap();
            let difference = (alpha[(0, 1)] - alpha[(1, 0)]).norm() / alpha[(0, 0)].norm();
            println!("{f} Hz, {speed} m/s: {difference:e}");
            // standing, α is even by construction; measured 1.8e-16. Almost standing, both sides are integrated by themselves, each
            // to 1e-4; measured 1.8e-5, and v/c is 1e-5
            assert!(worst <= 1.0 && difference < if speed == 0.0 { 1e-9 } else { 1e-4 }, "{difference:e}");
        }
    }
}

#[test]
fn thin_layers_and_direct_stiffness_agree() {
    let bands = Band::range(2.0, 80.0).unwrap();
    let study = study(&bands, (SPEED / 100.0, SPEED / 1.5));
    let thin = Solver::ThinLayer(ThinLayer::default());
    let [a, b] = [Solver::DirectStiffness, thin].map(|s| study.run(&model(s), &Silent).unwrap().group);
    let row =
        |group: &Group, part: &str| -> Vec<f64> { group.get(part).unwrap().values.iter().copied().collect() };
    for part in ["v_rms_dynamic", "v_rms_total", "v_rms_quasi_static"] {
        let (a, b) = (row(&a, part), row(&b, part));
        // the quasi-static part fades over seven decades of which only the first matter
        let floor = if part == "v_rms_quasi_static" { a.iter().copied().fold(0.0, f64::max) } else { 0.0 };
        let worst = a.iter().zip(&b).map(|(a, b)| (b - a).abs() / a.max(floor)).fold(0.0, f64::max);
        println!("{part}: {worst:e}");
        // measured 1.9e-5 (dynamic), 1.5e-4 (total), 6.9e-5 (quasi-static, of its largest band)
        assert!(worst < if part == "v_rms_dynamic" { 1e-4 } else { 5e-4 }, "{part}: {worst:e}");
    }
}

/// |h| at β = ω/v by plain sums over β_y, (Δ/π) Σ G(√(β² + β_y²)) sinc(β_y b) {1, cos β_y y}, the first with half its weight. They
/// repeat the ground every 2π/Δ = 126 m.
fn of_one_load(stack: &Stack, profile: &Profile, f: f64, speed: f64) -> f64 {
    let (step, top) = (0.05, 60.0);
    let (omega, beta) = (TAU * f, TAU * f / speed);
    let ground = DirectStiffness.prepare(profile, omega, &[]).unwrap();
    let (mut strip, mut receiver) = (Complex64::ZERO, Complex64::ZERO);
    for n in 0..(top / step) as usize {
        let beta_y = step * n as f64;
        let x = beta_y * STRIP.half_width;
        let weight = if n == 0 { 0.5 } else { x.sin() / x * taper(beta_y, 0.5 * top, top) };
        let g = ground.u_zz(beta.hypot(beta_y)) * (weight * step / PI);
        strip += g;
        receiver += g * (beta_y * RECEIVER).cos();
    }
    (stack.respond(beta, omega, 1.0 / strip).base / strip * receiver).norm()
}

/// ω/v crosses the wavenumber thin layers are cut for, 30 rad/m, inside the bands; beyond it nothing arrives. The witness shares G and
/// the stack with the study, no integral and no interpolation.
#[test]
fn slow_axles_leave_nothing_in_high_bands() {
    let (stack, profile) = (tracks::ballasted(), named("paper_layered"));
    for (highest, speed) in [(80.0, 60.0 / 3.6), (100.0, 77.0 / 3.6), (160.0, 123.0 / 3.6)] {
        let bands = Band::range(1.0, highest).unwrap();
        let mut study = study(&bands, (1.0, 10.0));
        (study.speed, study.receivers, study.roughness) = (speed, vec![RECEIVER], None);
        let outcome = study.run(&model(Solver::ThinLayer(ThinLayer::default())), &Silent).unwrap();
        assert!(outcome.concerns.iter().all(|c| c.code != "quasi-static-bands"), "{:?}", outcome.concerns);
        let told: Vec<f64> =
            outcome.group.get("v_rms_quasi_static").unwrap().values.iter().copied().collect();
        // ∫ 2ω² |h|² P²/v² df over one second
        let own: Vec<f64> = bands
            .par_iter()
            .map(|band| {
                let width = (band.upper() - band.lower()) / 100.0;
                let at = |i: i32| band.lower() + width * (f64::from(i) + 0.5);
                let velocity = |f: f64| TAU * f * of_one_load(&stack, &profile, f, speed) * 150e3 / speed;
                (0..100).map(|i| 2.0 * velocity(at(i)).powi(2) * width).sum::<f64>().sqrt()
            })
            .collect();
        let largest = own.iter().copied().fold(0.0, f64::max);
        let matter = |b: &usize| own[*b] > 1e-3 * largest;
        let worst = (0..bands.len()).filter(matter).map(|b| (told[b] / own[b] - 1.0).abs());
        let (count, worst) = ((0..bands.len()).filter(matter).count(), worst.fold(0.0, f64::max));
        let rest = (0..bands.len()).filter(|b| !matter(b)).map(|b| told[b]).fold(0.0, f64::max) / largest;
        let all = |v: &[f64]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
        let whole = all(&told) / all(&own) - 1.0;
        println!(
            "{speed} m/s: {count} bands off by {worst:e}, together {whole:e}; others {rest:e} of the largest"
        );
        // measured 1.3e-3, 1.2e-3, 1.1e-3, in the last of 6, 7 and 9 bands: the study samples a band over which |h|² falls by e⁴ sixteen
        // times; together 1.1e-4, 7.0e-5, 3.0e-5
        assert!(worst < 2e-3 && whole.abs() < 3e-4, "{speed}: {worst:e} {whole:e}");
        // measured 4.7e-4, 4.2e-4, 4.1e-4 in the next one; nowhere more than the witness, whose cut at 60 rad/m leaves it 1e-12 m/s
        assert!(rest < 1e-3, "{speed}: {rest:e}");
        assert!(told.iter().zip(&own).all(|(told, own)| *told < 1.001 * own), "{speed}: {told:?} {own:?}");
        if highest == 80.0 {
            // 2.404e-6 m/s of 80 kN over 0.96 s, known in three other ways; measured 2.2e-3
            let told = all(&told) * (80.0 / 150.0) / (16.0 / speed).sqrt();
            assert!((told / 2.404e-6 - 1.0).abs() < 5e-3, "{told:e}");
        }
    }
}
