//! One scatter plot with logarithmic axes.

use super::escape;
use std::fmt::Write;

/// Size of a plot and its margins: left, top, right, bottom.
const SIZE: [f64; 2] = [720.0, 430.0];
const MARGIN: [f64; 4] = [66.0, 14.0, 118.0, 50.0];

/// What a mark looks like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    Disc,
    Square,
    Diamond,
    Cross,
}

/// A mark.
#[derive(Debug, Clone)]
pub(super) struct Mark {
    pub(super) at: [f64; 2],
    /// One of six colours.
    pub(super) colour: usize,
    pub(super) shape: Shape,
    /// What the pointer is told.
    pub(super) title: String,
    /// A name drawn beside the mark.
    pub(super) name: Option<String>,
}

/// A plot.
#[derive(Debug, Clone, Default)]
pub(super) struct Plot {
    pub(super) marks: Vec<Mark>,
    /// Lines through points.
    pub(super) lines: Vec<Vec<[f64; 2]>>,
    pub(super) axes: [String; 2],
    /// Words beside a mark: colour, shape, text.
    pub(super) legend: Vec<(usize, Shape, String)>,
}

struct Frame {
    low: [f64; 2],
    high: [f64; 2],
}

impl Frame {
    fn of(plot: &Plot) -> Option<Self> {
        let all = plot.marks.iter().map(|m| m.at).chain(plot.lines.iter().flatten().copied());
        let all: Vec<[f64; 2]> = all.filter(sound).map(|p| p.map(f64::log10)).collect();
        if all.is_empty() {
            return None;
        }
        let least = |c: usize| all.iter().fold(f64::INFINITY, |m, p| m.min(p[c]));
        let most = |c: usize| all.iter().fold(f64::NEG_INFINITY, |m, p| m.max(p[c]));
        let low = [least(0) - 0.12, least(1) - 0.15];
        let high = [most(0) + 0.12, most(1) + 0.15];
        Some(Self { low, high })
    }

    fn place(&self, p: [f64; 2]) -> [f64; 2] {
        let share = |c: usize| (p[c].log10() - self.low[c]) / (self.high[c] - self.low[c]);
        let [left, top, right, bottom] = MARGIN;
        [
            left + share(0) * (SIZE[0] - left - right),
            SIZE[1] - bottom - share(1) * (SIZE[1] - top - bottom),
        ]
    }
}

fn sound(p: &[f64; 2]) -> bool {
    p.iter().all(|v| *v > 0.0 && v.is_finite())
}

impl Plot {
    /// The plot as SVG; a word where there is nothing to draw.
    pub(super) fn svg(&self) -> String {
        let Some(frame) = Frame::of(self) else {
            return "<p class=\"note\">nothing to draw</p>".into();
        };
        let mut t = format!("<svg viewBox=\"0 0 {} {}\" role=\"img\">", SIZE[0], SIZE[1]);
        self.scales(&mut t, &frame);
        for line in &self.lines {
            let points: Vec<String> = line
                .iter()
                .filter(|p| sound(p))
                .map(|p| frame.place(*p))
                .map(|[x, y]| format!("{x:.1},{y:.1}"))
                .collect();
            let _ = write!(t, "<polyline class=\"front\" points=\"{}\"/>", points.join(" "));
        }
        self.marks.iter().filter(|m| sound(&m.at)).for_each(|m| mark(&mut t, &frame, m));
        self.names(&mut t, &frame);
        self.words(&mut t);
        t.push_str("</svg>");
        t
    }

    fn scales(&self, t: &mut String, frame: &Frame) {
        let [left, top, right, bottom] = MARGIN;
        let (x1, y1) = (SIZE[0] - right, SIZE[1] - bottom);
        for c in [0, 1] {
            for v in ticks(frame.low[c], frame.high[c]) {
                let p = frame.place(if c == 0 { [v, 1.0] } else { [1.0, v] });
                let at = p[c];
                let text = label(v);
                let _ = if c == 0 {
                    write!(
                        t,
                        "<line class=\"grid\" x1=\"{at:.1}\" x2=\"{at:.1}\" y1=\"{top}\" y2=\"{y1}\"/><text class=\"tick\" text-anchor=\"middle\" x=\"{at:.1}\" y=\"{}\">{text}</text>",
                        y1 + 16.0
                    )
                } else {
                    write!(
                        t,
                        "<line class=\"grid\" x1=\"{left}\" x2=\"{x1}\" y1=\"{at:.1}\" y2=\"{at:.1}\"/><text class=\"tick\" text-anchor=\"end\" x=\"{}\" y=\"{:.1}\">{text}</text>",
                        left - 6.0,
                        at + 4.0
                    )
                };
            }
        }
        let (mx, my) = (0.5 * (left + x1), 0.5 * (top + y1));
        let _ = write!(
            t,
            "<text text-anchor=\"middle\" x=\"{mx}\" y=\"{}\">{}</text><text text-anchor=\"middle\" transform=\"translate(14 {my}) rotate(-90)\">{}</text>",
            SIZE[1] - 8.0,
            escape(&self.axes[0]),
            escape(&self.axes[1])
        );
    }

    /// Names beside their marks, moved apart where they would lie on each other.
    fn names(&self, t: &mut String, frame: &Frame) {
        let mut taken: Vec<[f64; 2]> = Vec::new();
        for m in self.marks.iter().filter(|m| sound(&m.at)) {
            let Some(name) = &m.name else { continue };
            let [x, y] = frame.place(m.at);
            let mut at = [x + 11.0, y - 8.0];
            while taken.iter().any(|p| (p[1] - at[1]).abs() < 14.0 && (p[0] - at[0]).abs() < 120.0)
            {
                at[1] -= 14.0;
            }
            taken.push(at);
            let _ = write!(
                t,
                "<circle class=\"preset\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"8\"/><text class=\"name halo\" x=\"{:.1}\" y=\"{:.1}\">{}</text>",
                at[0],
                at[1],
                escape(name)
            );
        }
    }

    fn words(&self, t: &mut String) {
        let x = SIZE[0] - MARGIN[2] + 14.0;
        for (n, (colour, shape, text)) in self.legend.iter().enumerate() {
            let y = MARGIN[1] + 12.0 + 18.0 * n as f64;
            draw(t, *shape, *colour, [x, y - 4.0], "");
            let _ = write!(
                t,
                "<text class=\"tick\" x=\"{}\" y=\"{y}\">{}</text>",
                x + 11.0,
                escape(text)
            );
        }
    }
}

fn mark(t: &mut String, frame: &Frame, m: &Mark) {
    draw(t, m.shape, m.colour, frame.place(m.at), &m.title);
}

fn draw(t: &mut String, shape: Shape, colour: usize, [x, y]: [f64; 2], title: &str) {
    let title =
        if title.is_empty() { String::new() } else { format!("<title>{}</title>", escape(title)) };
    let class = format!("class=\"mark k{}\"", colour.min(5));
    let _ = match shape {
        Shape::Disc => {
            write!(t, "<circle {class} cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\">{title}</circle>")
        }
        Shape::Square => write!(
            t,
            "<rect {class} x=\"{:.1}\" y=\"{:.1}\" width=\"7\" height=\"7\">{title}</rect>",
            x - 3.5,
            y - 3.5
        ),
        Shape::Diamond => {
            write!(t, "<path {class} d=\"M{x:.1} {:.1}l5 5l-5 5l-5 -5z\">{title}</path>", y - 5.0)
        }
        Shape::Cross => write!(
            t,
            "<path {class} d=\"M{:.1} {:.1}l8 8m0 -8l-8 8\">{title}</path>",
            x - 4.0,
            y - 4.0
        ),
    };
}

/// Powers of ten, and twos and fives where there are few.
fn ticks(low: f64, high: f64) -> Vec<f64> {
    let parts: &[f64] = if high - low > 2.2 { &[1.0] } else { &[1.0, 2.0, 5.0] };
    let decades = low.floor() as i32..=high.ceil() as i32;
    let all = decades.flat_map(|d| parts.iter().map(move |p| p * 10f64.powi(d)));
    all.filter(|v| (low..=high).contains(&v.log10())).collect()
}

fn label(v: f64) -> String {
    match v {
        v if v >= 1e9 => format!("{} G", v / 1e9),
        v if v >= 1e6 => format!("{} M", v / 1e6),
        v if v >= 1e4 => format!("{} k", v / 1e3),
        v if v >= 1.0 => format!("{v:.0}"),
        v if v >= 1e-2 => format!("{v:.2}"),
        v => format!("{v:.0e}"),
    }
}
