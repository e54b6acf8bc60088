//! The page: one file of HTML with its plots in SVG, readable in light and in dark, with nothing from elsewhere.

mod parts;
mod plot;
mod style;
mod tables;

use crate::report::Report;
use std::fmt::Write;

impl Report {
    /// The page.
    pub fn html(&self) -> String {
        let mut t = String::with_capacity(1 << 20);
        let _ = write!(
            t,
            "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">\
             <title>dogleaf: what accuracy costs in time</title><style>{}</style></head><body><main>",
            style::CSS
        );
        let _ = write!(
            t,
            "<h1>What accuracy costs in time</h1><p class=\"sub\">dogleaf {} &middot; {} &middot; cost: {}{}</p>",
            self.dogleaf,
            escape(&self.machine),
            self.unit,
            if self.quick { " &middot; quick run" } else { "" }
        );
        parts::verdict(&mut t, self);
        parts::plots(&mut t, self);
        tables::presets(&mut t, self);
        tables::claims(&mut t, self);
        tables::references(&mut t, self);
        tables::omissions(&mut t, self);
        tables::all(&mut t, self);
        t.push_str("</main></body></html>\n");
        t
    }
}

/// Text as it may stand in HTML.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
