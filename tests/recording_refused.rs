//! Promise: whatever bytes come as a recording, the answer is a recording or one clear error: no panic,
//! no endless loop, no number that is none.

use crate::recorded::{Bytes, CRC, END, finite, play, record, recorder, seal, setup, turn};
use dogleaf_core::Book;
use dogleaf_core::grid::{G6x5, G8x6, Grid};
use dogleaf_core::real::Real;
use dogleaf_core::record::{
    MAX_BYTES, MAX_RECORDS, Reader, Record, RecordError, Recorder, Sink, SliceSink, Tier, VERSION,
    replay,
};
use dogleaf_core::scene::{Formulation, SpecError};

/// A hand that lifts a leaf and lets it go, on the smallest grid.
fn short() -> Vec<u8> {
    record::<f32, G6x5>(&setup(), &turn(&setup(), 100_000), 12)
}

fn refusal(bytes: &[u8]) -> Option<RecordError> {
    Reader::open(bytes).err()
}

/// A recording of nothing, and of what `tail` holds in place of its end.
fn with_stream(tail: &[&[u8]]) -> Vec<u8> {
    let mut body = recorder::<f32, G6x5>(&setup()).finish().expect("there is room").0;
    body.truncate(body.len() - END);
    tail.iter().for_each(|part| body.extend_from_slice(part));
    seal(body)
}

fn end(inputs: u32, looks: u32, steps: u32) -> Vec<u8> {
    let counts = [inputs, looks, steps].into_iter().flat_map(u32::to_le_bytes);
    std::iter::once(255).chain(counts).collect()
}

fn again(count: u32) -> Vec<u8> {
    std::iter::once(4).chain(count.to_le_bytes()).collect()
}

const STEP: [u8; 9] = [3, 1, 2, 3, 4, 5, 6, 7, 8];

#[test]
fn the_layout_is_as_written_down() {
    let bytes = short();
    assert_eq!(&bytes[..9], b"DLR1\x02\x00\x04\x06\x05");
    assert_eq!(seal(bytes[..bytes.len() - CRC].to_vec()), bytes, "the checksum is the common one");
    assert_eq!(refusal(&with_stream(&[&STEP, &end(0, 0, 1)])), None);
    assert_eq!(refusal(&with_stream(&[&STEP, &again(4), &end(0, 0, 5)])), None);
    // 9 bytes so far, made_by, book, paper without weights, world, view, fidelity, formulation, grip, pages.
    let header =
        9 + 8 + (8 + 8 + 4 + 4 + 1 + 1) + (4 * 8 + 1) + (3 * 8 + 8 + 4 + 8) + (7 * 8 + 8) + 2 + 9;
    assert_eq!(with_stream(&[]).len(), header + CRC);
}

#[test]
fn cut_anywhere_it_is_refused() {
    let bytes = short();
    for length in 0..bytes.len() {
        assert!(refusal(&bytes[..length]).is_some(), "{length} bytes");
        // Also where somebody made the checksum fit.
        if length < bytes.len() - CRC {
            let error = refusal(&seal(bytes[..length].to_vec()));
            assert!(error.is_some(), "{length} bytes, sealed");
            let expected = if length >= 6 { Some(RecordError::Truncated) } else { error };
            assert_eq!(error, expected, "{length} bytes, sealed");
        }
    }
    assert_eq!(refusal(&[]), Some(RecordError::Truncated));
}

#[test]
fn one_flipped_bit_is_seen() {
    let bytes = short();
    for bit in 0..bytes.len() * 8 {
        let mut flipped = bytes.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        let error = refusal(&flipped).unwrap_or_else(|| panic!("bit {bit} was not seen"));
        let head = matches!(error, RecordError::NotARecording | RecordError::Version(_));
        assert!(
            head == (bit < 48) && (head || error == RecordError::Checksum),
            "bit {bit}: {error}"
        );
    }
}

/// One flipped bit under a checksum that fits: refused, or replayed to the end in finite numbers.
#[test]
fn one_forged_bit_is_refused_or_replays_finite() {
    let bytes = short();
    let body = &bytes[..bytes.len() - CRC];
    let mut book = Box::new(Book::<f32, G6x5>::EMPTY);
    let (mut refused, mut replayed, mut diverged) = (0, 0, 0);
    for bit in 0..body.len() * 8 {
        let mut forged = body.to_vec();
        forged[bit / 8] ^= 1 << (bit % 8);
        let forged = seal(forged);
        let Ok(reader) = Reader::open(&forged) else {
            refused += 1;
            continue;
        };
        match replay(&reader, &mut book) {
            Err(RecordError::Tier { .. } | RecordError::Grid { .. } | RecordError::Formulation) => {
                refused += 1;
            }
            Err(error) => panic!("bit {bit}: {error} after it was opened"),
            Ok(verdict) => {
                assert!(finite(&book), "bit {bit}");
                assert_eq!(verdict.steps, reader.steps(), "bit {bit}");
                replayed += 1;
                diverged += u32::from(verdict.diverged.is_some());
            }
        }
    }
    assert!(refused > 300 && replayed > 1000 && diverged > 500, "{refused} {replayed} {diverged}");
}

#[test]
fn another_version_is_refused_before_all_else() {
    for version in [0, VERSION + 1, 0x0100, u16::MAX] {
        let mut bytes = short();
        bytes[4..6].copy_from_slice(&version.to_le_bytes());
        assert_eq!(refusal(&bytes), Some(RecordError::Version(version)), "checksum or not");
        assert_eq!(
            refusal(&bytes[..6]),
            Some(RecordError::Version(version)),
            "and whatever follows"
        );
        let sealed = seal(bytes[..bytes.len() - CRC].to_vec());
        assert_eq!(refusal(&sealed), Some(RecordError::Version(version)));
    }
    assert_eq!(refusal(b"%PDF-1.7 and so on"), Some(RecordError::NotARecording));
}

/// Refused by a book that goes on as if nothing had been.
fn unmoved<R: Real, G: Grid>(bytes: &[u8]) -> RecordError {
    let mut book =
        play::<R, G>(&setup(), &turn(&setup(), 200_000), 12, &mut recorder::<R, G>(&setup()));
    let (hash, now) = (book.state_hash(), book.now_us());
    let reader = Reader::open(bytes).expect("sound");
    let error = replay(&reader, &mut book).expect_err("it does not fit");
    assert_eq!((book.state_hash(), book.now_us()), (hash, now), "unchanged");
    error
}

#[test]
fn another_tier_grid_or_formulation_is_named() {
    let bytes = short();
    let tier = unmoved::<f64, G6x5>(&bytes);
    assert_eq!(tier, RecordError::Tier { recorded: Tier::F32, here: Tier::F64 });
    assert_eq!(tier.to_string(), "the recording was made with f32, not f64");
    let grid = unmoved::<f32, G8x6>(&bytes);
    assert_eq!(grid, RecordError::Grid { recorded: [6, 5], here: [8, 6] });
    assert_eq!(grid.to_string(), "the recording was made on a 6x5 grid, not 8x6");
    let mut seed = setup();
    seed.formulation = Formulation::Seed;
    let bytes = recorder::<f32, G6x5>(&seed).finish().expect("there is room").0;
    assert_eq!(unmoved::<f32, G6x5>(&bytes), RecordError::Formulation);
}

#[test]
fn too_much_is_refused() {
    let mut large = short();
    large.resize(MAX_BYTES + 1, 0);
    assert_eq!(refusal(&large), Some(RecordError::TooLarge));
    large.truncate(MAX_BYTES);
    assert_eq!(refusal(&large), Some(RecordError::Checksum));

    let most = with_stream(&[&STEP, &again(MAX_RECORDS - 1), &end(0, 0, MAX_RECORDS)]);
    let reader = Reader::open(&most).expect("as many as there may be");
    assert_eq!(reader.records().count(), MAX_RECORDS as usize);
    for count in [MAX_RECORDS, u32::MAX - 1, u32::MAX] {
        let steps = count.wrapping_add(1);
        let bytes = with_stream(&[&STEP, &again(count), &end(0, 0, steps)]);
        assert_eq!(refusal(&bytes), Some(RecordError::TooMany), "{count}");
    }
    let bytes = with_stream(&[&STEP, &again(1 << 31), &again(1 << 31), &end(0, 0, 1)]);
    assert_eq!(refusal(&bytes), Some(RecordError::TooMany), "no wrapping around");
}

#[test]
fn a_stream_that_makes_no_sense_is_refused() {
    use RecordError::{Counts, Repeat, Trailing, Truncated, Unknown};
    let mut input = vec![1; 22];
    input[10] = 4;
    let cases: [(&str, Vec<&[u8]>, RecordError); 11] = [
        ("no end", vec![&STEP], Truncated),
        ("half a step", vec![&STEP[..5]], Truncated),
        ("a run before a step", vec![&[4, 1, 0, 0, 0], &[255; 13]], Repeat),
        ("an empty run", vec![&STEP, &[4, 0, 0, 0, 0]], Repeat),
        ("tag 0", vec![&[0; 30]], Unknown("record")),
        ("tag 5", vec![&[5; 30]], Unknown("record")),
        ("phase 4", vec![&input], Unknown("pointer phase")),
        ("a step too few", vec![&STEP, &[255, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0]], Counts),
        ("an input too few", vec![&STEP, &[255, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0]], Counts),
        ("a byte more", vec![&[255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0], &[0]], Trailing),
        ("a step after the end", vec![&[255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0], &STEP], Trailing),
    ];
    for (name, stream, error) in cases {
        assert_eq!(refusal(&with_stream(&stream)), Some(error), "{name}");
    }
    let blind = std::iter::once(2).chain([0; 64]).collect::<Vec<_>>();
    let bytes = with_stream(&[&blind, &end(0, 1, 0)]);
    assert_eq!(refusal(&bytes), Some(RecordError::Spec(SpecError::OutOfRange("view"))));
}

#[test]
fn a_header_that_asks_for_the_impossible_is_refused() {
    let bytes = short();
    let forge = |at: usize, with: &[u8]| {
        let mut body = bytes[..bytes.len() - CRC].to_vec();
        body[at..at + with.len()].copy_from_slice(with);
        refusal(&seal(body))
    };
    let spec = |error| Some(RecordError::Spec(error));
    let width = 17;
    assert_eq!(forge(width, &0.13f64.to_le_bytes()), None, "the offset is right");
    let nan = spec(SpecError::NotFinite("book.width_m"));
    assert_eq!(forge(width, &f64::NAN.to_le_bytes()), nan);
    assert_eq!(forge(width, &f64::INFINITY.to_le_bytes()), nan);
    assert_eq!(
        forge(width, &(-0.13f64).to_le_bytes()),
        spec(SpecError::OutOfRange("book.width_m"))
    );
    assert_eq!(forge(width + 16, &[255; 4]), spec(SpecError::OutOfRange("book.pages")));
    assert_eq!(forge(width + 24, &[2]), Some(RecordError::Unknown("cover")));
    assert_eq!(forge(width + 25, &[9]), Some(RecordError::Unknown("reading direction")));
    assert_eq!(forge(width + 26 + 32, &[7]), Some(RecordError::Unknown("presence of weights")));
    assert_eq!(forge(6, &[5]), Some(RecordError::Unknown("numeric tier")));
    let fidelity = with_stream(&[]).len() - CRC - 11;
    assert_eq!(forge(fidelity, &[4]), Some(RecordError::Unknown("fidelity")));
    assert_eq!(forge(fidelity + 1, &[2]), Some(RecordError::Unknown("formulation")));
    let out = spec(SpecError::OutOfRange("handling.grip"));
    assert_eq!(forge(fidelity + 2, &101.0f64.to_le_bytes()), out);
    assert_eq!(forge(fidelity + 10, &[2]), Some(RecordError::Unknown("pages")));
}

/// A hundred thousand streams of random tags under a sound header and checksum.
#[test]
fn random_streams_end() {
    let mut state = 1u64;
    let mut random = move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as u32
    };
    let head = with_stream(&[]);
    let head = &head[..head.len() - CRC];
    let mut sound = 0;
    for _ in 0..100_000 {
        let mut body = head.to_vec();
        let (mut inputs, mut steps) = (0, 0);
        for _ in 0..random() % 6 {
            match random() % 8 {
                0 => body.push(random() as u8),
                1 => {
                    let count = random() % 5;
                    steps += count;
                    body.extend(again(count));
                }
                2 | 3 => {
                    inputs += 1;
                    body.push(1);
                    body.extend((0..9).map(|_| random() as u8));
                    body.push((random() % 4) as u8);
                    body.extend((0..10).map(|_| random() as u8));
                }
                _ => {
                    steps += 1;
                    body.extend(STEP);
                }
            }
        }
        body.extend(end(inputs, 0, steps));
        let bytes = seal(body);
        if let Ok(reader) = Reader::open(&bytes) {
            let records: Result<Vec<Record>, _> = reader.records().collect();
            assert_eq!(records.map(|r| r.len()), Ok((inputs + steps) as usize));
            sound += 1;
        }
    }
    assert!(sound > 10_000, "{sound}");
}

#[test]
fn a_recorder_stops_at_the_caps_and_can_be_finished() {
    let mut recorder = recorder::<f32, G6x5>(&setup());
    (0..MAX_RECORDS).try_for_each(|_| recorder.step(7)).expect("as many as there may be");
    assert_eq!(recorder.step(7), Err(RecordError::Full));
    assert_eq!(recorder.input(&turn(&setup(), 100_000)[0]), Err(RecordError::Full));
    let bytes = recorder.finish().expect("there is room").0;
    assert_eq!(Reader::open(&bytes).expect("sound").steps(), MAX_RECORDS);

    let mut recorder = self::recorder::<f32, G6x5>(&setup());
    let sample = turn(&setup(), 100_000)[0];
    let taken = (0..MAX_RECORDS).take_while(|_| recorder.input(&sample).is_ok()).count();
    assert_eq!(recorder.step(7), Err(RecordError::Full), "once full, always full: no holes");
    let bytes = recorder.finish().expect("there is room").0;
    assert!(bytes.len() <= MAX_BYTES && bytes.len() > MAX_BYTES - 64, "{} bytes", bytes.len());
    assert_eq!(Reader::open(&bytes).expect("sound").inputs() as usize, taken);
}

/// A disk that fills up.
#[derive(Debug)]
struct Failing(usize);

impl Sink for Failing {
    fn put(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        self.0 = self.0.checked_sub(bytes.len()).ok_or(RecordError::Sink)?;
        Ok(())
    }
}

#[test]
fn a_failing_sink_is_said_at_every_byte() {
    let samples = turn(&setup(), 100_000);
    let whole = {
        let mut bytes = Bytes::default();
        act(&mut bytes, &samples).expect("memory does not fail");
        bytes.0.len()
    };
    for room in 0..whole {
        assert_eq!(act(Failing(room), &samples), Err(RecordError::Sink), "{room}");
        let mut buffer = vec![0; room];
        let error = act(SliceSink::new(&mut buffer), &samples);
        assert_eq!(error, Err(RecordError::Full), "{room}: a slice says so before it is too late");
    }
    assert_eq!(act(Failing(whole), &samples), Ok(()));

    let mut broken =
        Recorder::start::<f32, G6x5>(Failing(whole - 100), &setup()).expect("for the head");
    while broken.input(&samples[0]).is_ok() {}
    assert_eq!(broken.step(1), Err(RecordError::Sink), "and stays broken");
    assert_eq!(broken.finish().err(), Some(RecordError::Sink));
}

fn act(sink: impl Sink, samples: &[dogleaf_core::hand::Sample]) -> Result<(), RecordError> {
    let mut recorder = Recorder::start::<f32, G6x5>(sink, &setup())?;
    for (n, sample) in samples.iter().enumerate() {
        recorder.input(sample)?;
        recorder.step(n as u64 / 2)?;
    }
    recorder.finish().map(|_| ())
}

#[test]
fn nothing_unsound_is_recorded() {
    let mut bad = setup();
    bad.world.gravity[0] = f64::NAN;
    let start = Recorder::start::<f32, G6x5>(Bytes::default(), &bad);
    assert_eq!(start.err(), Some(RecordError::Spec(SpecError::NotFinite("world.gravity"))));
    let mut recorder = recorder::<f32, G6x5>(&setup());
    let mut view = setup().view;
    view.eye_m = view.target_m;
    assert!(matches!(recorder.look(&view), Err(RecordError::Spec(_))), "a view that sees nothing");
    recorder.step(1).expect("the recording goes on");
    assert_eq!(refusal(&recorder.finish().expect("there is room").0), None);
}

#[test]
fn errors_are_one_clear_line() {
    use RecordError as E;
    let all = [
        E::NotARecording,
        E::Version(9),
        E::Truncated,
        E::TooLarge,
        E::TooMany,
        E::Checksum,
        E::Unknown("cover"),
        E::Repeat,
        E::Counts,
        E::Trailing,
        E::Spec(SpecError::OutOfRange("book.pages")),
        E::Tier { recorded: Tier::F64, here: Tier::F32 },
        E::Grid { recorded: [6, 5], here: [8, 6] },
        E::Formulation,
        E::Full,
        E::Sink,
    ];
    let mut lines: Vec<_> = all.iter().map(ToString::to_string).collect();
    for line in &lines {
        assert!(line.starts_with(char::is_lowercase) && !line.ends_with('.'), "{line}");
        assert!(!line.contains('\n') && !line.contains("refused"), "{line}");
    }
    assert!(lines.contains(&format!("the recording holds more than {MAX_RECORDS} records")));
    assert!(lines.contains(&format!("the recording is longer than {} MiB", MAX_BYTES >> 20)));
    lines.sort();
    lines.dedup();
    assert_eq!(lines.len(), all.len(), "no two are the same");
}
