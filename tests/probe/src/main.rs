//! Runs the probes on a host, or on one that is emulated in user mode: `probe [f32|f64]..`, both by default.

use dogleaf_probe::{Probe, Work, probes};

fn main() {
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    let mut work = Box::new(Work::EMPTY);
    for probe in probes::<f32>().chain(probes::<f64>()) {
        if wanted.is_empty() || wanted.iter().any(|w| w == probe.tier) {
            let Probe { kind, name, tier, run } = probe;
            println!("{kind} {tier} {name} {:016x}", run(&mut work));
        }
    }
}
