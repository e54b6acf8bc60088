//! `size`: the firmware's image on the emulated Cortex-M7 against what it may take, and whether the checks
//! would notice.

mod figures;
mod image;

use crate::boards::{M0, M4F, M7, Processor};
use crate::tally::Tally;
use crate::words::{Result, Stop, no_args};
pub(crate) use figures::Figures;
pub(crate) use image::Image;

const KIB: u64 = 1024;
/// Code and constants: what we want, and what we have. The second may only fall.
const TEXT: [u64; 2] = [64 * KIB, 83 * KIB];
/// RAM, statics and stack together.
const RAM: [u64; 2] = [96 * KIB, 88 * KIB];
/// Stack.
const STACK: [u64; 2] = [4 * KIB, 3_900];
/// Instructions of the median step, and how many times as many the worst may take.
const INSTRUCTIONS: [u64; 2] = [1_200_000, 1_200_000];
const WORST: u64 = 2;

/// Features of the core, and how the firmware asks for them.
const FEATURES: [(&str, &str); 4] = [
    ("none", ""),
    ("seed, unused", "dogleaf-core/seed"),
    ("ribbon, unused", "dogleaf-core/ribbon"),
    ("defmt, logged", "defmt"),
];

/// The same image on the other processors, and the most instructions of its median step: what we have, with a
/// hundredth for another compiler.
const OTHERS: [(Processor, u64); 2] = [(M4F, 1_550_000), (M0, 61_600_000)];

/// One thing that is looked at: its name, its figure, what is wanted and what is allowed.
struct Check {
    name: &'static str,
    found: u64,
    goal: u64,
    most: u64,
}

/// `cargo ci size`.
pub(crate) fn size(args: &[String]) -> Result {
    no_args(args)?;
    for (processor, _) in [(M7, 0)].iter().chain(&OTHERS) {
        processor.ready().map_err(Stop::Skipped)?;
    }
    let mut faults = product()?;
    faults.extend(control()?);
    faults.extend(others()?);
    faults.extend(features()?);
    for fault in &faults {
        eprintln!("  {fault}");
    }
    if faults.is_empty() {
        Ok(Tally::default())
    } else {
        Err(format!("{} of the firmware's bounds do not hold", faults.len()).into())
    }
}

/// The image as it is: nothing may be over.
fn product() -> std::result::Result<Vec<String>, String> {
    let (checks, image, said) = looked_at("")?;
    println!("| firmware on Cortex-M7 | found | at most | goal |\n|---|---|---|---|");
    for Check { name, found, goal, most } in &checks {
        let missed = if found > goal { ", missed" } else { "" };
        println!("| {name} | {found} | {most} | {goal}{missed} |");
    }
    for line in said.lines() {
        println!("    {line}");
    }
    for name in image.panics.iter().chain(&image.allocators).chain(&image.unasked) {
        println!("    forbidden: {name}");
    }
    let over = checks.iter().filter(|c| c.found > c.most);
    Ok(over.map(|c| format!("{}: {} is more than {}", c.name, c.found, c.most)).collect())
}

/// The image with everything planted that must not be in it: every check must fail.
fn control() -> std::result::Result<Vec<String>, String> {
    let (checks, ..) = looked_at("planted")?;
    let blind = checks.iter().filter(|c| c.found <= c.most);
    Ok(blind.map(|c| format!("control: `{}` did not notice what was planted", c.name)).collect())
}

fn looked_at(features: &str) -> std::result::Result<(Vec<Check>, Image, String), String> {
    let path = M7.build("play", features)?;
    let image = Image::read(&path)?;
    // Its status is a figure of another word.
    let (_, said) = M7.run(&path)?;
    let figures = Figures::read(&said);
    let stack = figures.get("stack high water")?;
    let median = figures.get("instructions median")?;
    let check = |name, found, [goal, most]: [u64; 2]| Check { name, found, goal, most };
    let checks = vec![
        check("text and constants, bytes", image.text, TEXT),
        check("static RAM and stack, bytes", image.statics() + stack, RAM),
        check("stack high water, bytes", stack, STACK),
        check("instructions a step, median", median, INSTRUCTIONS),
        check(
            "instructions a step, worst",
            figures.get("instructions most")?,
            INSTRUCTIONS.map(|n| WORST * n),
        ),
        check("functions that panic", image.panics.len() as u64, [0, 0]),
        check("functions that allocate", image.allocators.len() as u64, [0, 0]),
        check("functions nobody asked for", image.unasked.len() as u64, [0, 0]),
    ];
    Ok((checks, image, said))
}

/// The image on the processors with less: every hash as recorded, the count within its bound.
fn others() -> std::result::Result<Vec<String>, String> {
    let mut faults = Vec::new();
    println!(
        "| processor | instructions a step, median | worst | at most | stack | text |\n|---|---|---|---|---|---|"
    );
    for (processor, most) in OTHERS {
        let path = processor.build("play", "")?;
        let (image, (well, said)) = (Image::read(&path)?, processor.run(&path)?);
        let figures = Figures::read(&said);
        let [median, worst, stack] =
            ["instructions median", "instructions most", "stack high water"]
                .map(|n| figures.get(n));
        let (name, median) = (processor.name, median?);
        println!("| {name} | {median} | {} | {most} | {} | {} |", worst?, stack?, image.text);
        if !well {
            faults.push(format!("{name}: a step has another hash than recorded"));
        }
        if median > most {
            faults.push(format!("{name}: {median} instructions are more than {most}"));
        }
    }
    Ok(faults)
}

/// Bytes that each feature of the core costs.
///
/// Of what is built but not used, nothing may be in it.
fn features() -> std::result::Result<Vec<String>, String> {
    println!("| feature of the core | text | statics |\n|---|---|---|");
    let mut faults = Vec::new();
    for (name, features) in FEATURES {
        let image = Image::read(&M7.build("play", features)?)?;
        println!("| {name} | {} | {} |", image.text, image.statics());
        faults.extend(image.unasked.iter().map(|unasked| format!("{name}: {unasked} is in it")));
    }
    Ok(faults)
}
