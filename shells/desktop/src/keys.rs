//! What a key or a wheel means to a reader.

use dogleaf_core::scene::Direction;
use winit::event::MouseScrollDelta;
use winit::keyboard::{Key, ModifiersState, NamedKey};

/// What is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wish {
    Nothing,
    /// One leaf on, or back.
    Turn(bool),
    /// To the end, or to the beginning.
    TurnAll(bool),
    /// With a leaf in hand: one more, or one less.
    Bookmark(bool),
    /// Puts the leaf in hand back; with none, leaves.
    Back,
    Fullscreen,
}

/// What a key means in a book that is read this way. Arrows point where the leaf goes by.
pub(crate) fn wish(key: &Key, held: ModifiersState, direction: Direction) -> Wish {
    let ltr = direction == Direction::Ltr;
    let Key::Named(key) = key else { return Wish::Nothing };
    let arrow = |onward: bool| match held.shift_key() {
        true => Wish::Bookmark(onward),
        false => Wish::Turn(onward),
    };
    match key {
        NamedKey::ArrowRight => arrow(ltr),
        NamedKey::ArrowLeft => arrow(!ltr),
        NamedKey::ArrowDown => arrow(true),
        NamedKey::ArrowUp => arrow(false),
        NamedKey::Space => Wish::Turn(!held.shift_key()),
        NamedKey::PageDown => Wish::Turn(true),
        NamedKey::PageUp => Wish::Turn(false),
        NamedKey::End => Wish::TurnAll(true),
        NamedKey::Home => Wish::TurnAll(false),
        NamedKey::Escape | NamedKey::BrowserBack => Wish::Back,
        NamedKey::F11 => Wish::Fullscreen,
        _ => Wish::Nothing,
    }
}

/// Whether a wheel is rolled towards the reader, or to the right: some systems turn the wheel when Shift is held.
pub(crate) fn rolls_on(delta: MouseScrollDelta) -> bool {
    let [x, y] = match delta {
        MouseScrollDelta::LineDelta(x, y) => [f64::from(x), f64::from(y)],
        MouseScrollDelta::PixelDelta(way) => [way.x, way.y],
    };
    x + y < 0.0
}

#[cfg(test)]
mod tests {
    use super::{Wish, wish};
    use dogleaf_core::scene::Direction::{Ltr, Rtl};
    use winit::keyboard::{Key, ModifiersState, NamedKey};

    #[test]
    fn arrows_follow_the_way_one_reads() {
        let none = ModifiersState::empty();
        let right = Key::Named(NamedKey::ArrowRight);
        assert_eq!(wish(&right, none, Ltr), Wish::Turn(true), "on");
        assert_eq!(wish(&right, none, Rtl), Wish::Turn(false), "back, where one reads leftwards");
        assert_eq!(wish(&right, ModifiersState::SHIFT, Ltr), Wish::Bookmark(true), "one more leaf");
    }
}
