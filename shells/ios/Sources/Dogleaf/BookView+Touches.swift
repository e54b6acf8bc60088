// Fingers and screen readers of a BookView.

#if canImport(UIKit) && canImport(MetalKit)
import MetalKit
import UIKit

extension BookView {
    /// Fingers come down.
    public override func touchesBegan(_ touches: Set<UITouch>, with event: UIEvent?) {
        feed(touches, event, .down)
    }

    /// Fingers move: with every sample the system collected since the last frame.
    public override func touchesMoved(_ touches: Set<UITouch>, with event: UIEvent?) {
        feed(touches, event, .move)
    }

    /// Fingers let go.
    public override func touchesEnded(_ touches: Set<UITouch>, with event: UIEvent?) {
        feed(touches, event, .up)
    }

    /// The system takes fingers away: the leaf goes back.
    public override func touchesCancelled(_ touches: Set<UITouch>, with event: UIEvent?) {
        feed(touches, event, .cancel)
    }

    private func feed(_ touches: Set<UITouch>, _ event: UIEvent?, _ phase: Phase) {
        var samples: [PointerSample] = []
        for touch in touches {
            let key = ObjectIdentifier(touch)
            let number = fingers.number(of: key)
            let collected = phase == .move ? event?.coalescedTouches(for: touch) : nil
            samples += (collected ?? [touch]).map { sample($0, number, phase) }
            if phase == .up || phase == .cancel { fingers.forget(key) }
        }
        // Fingers are collected one by one; the book wants the oldest sample first.
        samples.sort { $0.timeUs < $1.timeUs }
        do {
            try book.pointers(samples: samples)
        } catch DogleafError.Pointer {
            // A sample out of order: the next one says where the finger is.
        } catch {
            onError?(error)
        }
        wake()
    }

    private func sample(_ touch: UITouch, _ number: UInt8, _ phase: Phase) -> PointerSample {
        let place = touch.preciseLocation(in: self)
        return PointerSample(
            timeUs: Fingers.microseconds(touch.timestamp), id: number, phase: phase,
            x: Float(place.x * contentScaleFactor), y: Float(place.y * contentScaleFactor), leaves: 0)
    }

    /// Three fingers of a screen reader's user turn a page.
    public override func accessibilityScroll(_ way: UIAccessibilityScrollDirection) -> Bool {
        switch way {
        case .left: return turn(forward: direction == .ltr)
        case .right: return turn(forward: direction == .rtl)
        case .next, .down: return turn(forward: true)
        case .previous, .up: return turn(forward: false)
        @unknown default: return false
        }
    }
}
#endif
