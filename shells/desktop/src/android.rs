//! The same window on Android, without a line of Java: a native activity that opens the app's own book.
#![allow(unsafe_code)]

use crate::error::DesktopError;
use crate::view::{BookView, Options};
use crate::window::{self, Ready, Show};
use dogleaf_content::Book;
use winit::event_loop::EventLoop;
use winit::platform::android::EventLoopBuilderExtAndroid;
use winit::platform::android::activity::AndroidApp;

/// Where the app keeps its book, in its own folder.
const BOOKS: [&str; 2] = ["book.pdf", "book.cbz"];

/// What the system calls when the activity starts.
// SAFETY: no other function of this library has the name that the glue looks for.
#[unsafe(no_mangle)]
fn android_main(app: AndroidApp) {
    if let Err(error) = read(&app) {
        eprintln!("dogleaf: {error}");
    }
}

fn read(app: &AndroidApp) -> Result<(), DesktopError> {
    let folders = [app.external_data_path(), app.internal_data_path()];
    let paths = folders.into_iter().flatten().flat_map(|f| BOOKS.map(|name| f.join(name)));
    let path = paths.into_iter().find(|p| p.exists());
    let path = path.ok_or_else(|| DesktopError::Call("the app's folder has no book".to_owned()))?;
    let words = |e: winit::error::EventLoopError| DesktopError::Window(e.to_string());
    let events = EventLoop::<Ready>::with_user_event();
    let events = { events }.with_android_app(app.clone()).build().map_err(words)?;
    let wake = events.create_proxy();
    let ready = move || _ = wake.send_event(Ready);
    let view = BookView::open(Book::open(&path)?, &Options::default(), ready)?;
    window::run(events, view, Show { script: None, size: Options::default().size }).map(drop)
}
