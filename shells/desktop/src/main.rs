//! The program `dogleaf-desktop`: a book in a window, or a picture of one.

#[cfg(not(target_os = "android"))]
mod args;

#[cfg(not(target_os = "android"))]
fn main() -> std::process::ExitCode {
    desktop::main()
}

/// On Android the library is what starts.
#[cfg(target_os = "android")]
fn main() {}

#[cfg(not(target_os = "android"))]
mod desktop {
    use crate::args::Args;
    use clap::Parser;
    use clap::error::ErrorKind;
    use dogleaf_content::Book;
    use dogleaf_desktop::window::{self, Ready, Show};
    use dogleaf_desktop::{BookView, DesktopError, Options, Script, gesture, one_line, shot};
    use std::path::Path;
    use std::process::ExitCode;
    use winit::event_loop::EventLoop;

    /// Longest gesture played before a picture, seconds.
    const LONGEST_S: f64 = 900.0;

    pub(crate) fn main() -> ExitCode {
        let args = match Args::try_parse() {
            Ok(args) => args,
            Err(error) => return refuse(&error),
        };
        match read(&args) {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                eprintln!("dogleaf-desktop: {}", one_line(&error.to_string()));
                ExitCode::from(2)
            }
        }
    }

    fn read(args: &Args) -> Result<(), DesktopError> {
        let script = match &args.gesture {
            Some(path) => Some(Script::new(gesture::load(path)?)),
            None => None,
        };
        let book = Book::open(&args.book)?;
        match &args.screenshot {
            Some(path) => picture(args, book, script.unwrap_or_default(), path),
            None => reader(args, book, script),
        }
    }

    fn picture(
        args: &Args,
        book: Book,
        mut script: Script,
        path: &Path,
    ) -> Result<(), DesktopError> {
        if !(0.0..=LONGEST_S).contains(&args.at) {
            return Err(DesktopError::Call(format!("--at: wanted 0 to {LONGEST_S} seconds")));
        }
        let mut view = BookView::open(book, &args.options(), || ())?;
        if let Some(path) = &args.record {
            view.record(path)?;
        }
        shot::play(&mut view, &mut script, (args.at * 1e6) as u64);
        view.picture_size(args.size());
        shot::save(&mut view, path)?;
        view.close()
    }

    fn reader(args: &Args, book: Book, script: Option<Script>) -> Result<(), DesktopError> {
        let words = |e: winit::error::EventLoopError| DesktopError::Window(e.to_string());
        let events = EventLoop::<Ready>::with_user_event().build().map_err(words)?;
        let wake = events.create_proxy();
        let mut view = BookView::open(book, &args.options(), move || _ = wake.send_event(Ready))?;
        if let Some(path) = &args.record {
            view.record(path)?;
        }
        let playing = script.is_some();
        let script = script.map(|s| s.scaled(Options::default().size, args.size()));
        let mut seen = window::run(events, view, Show { script, size: args.size() })?.frames_ms;
        if playing {
            seen.sort_by(f64::total_cmp);
            let median = seen.get(seen.len() / 2).copied().unwrap_or_default();
            println!("{} pictures, {median:.1} ms each", seen.len());
        }
        Ok(())
    }

    /// Help and version go out as they are; anything else is one line.
    fn refuse(error: &clap::Error) -> ExitCode {
        if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
            let _ = error.print();
            return ExitCode::SUCCESS;
        }
        let text = error.to_string();
        let text = text.split("Usage:").next().unwrap_or(&text);
        let text = text.split("For more information").next().unwrap_or(text);
        let line = one_line(text);
        eprintln!("dogleaf-desktop: {}", line.strip_prefix("error: ").unwrap_or(&line));
        ExitCode::from(2)
    }
}
