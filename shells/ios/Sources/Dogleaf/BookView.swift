// A book in a view: fingers in, frames out, nothing while it rests.

#if canImport(UIKit) && canImport(MetalKit)
import MetalKit
import UIKit

/// Shows a ``Book`` and lets the reader turn its pages.
///
/// It draws only while something moves. What becomes of a turn is told once, by ``onNotice``: exactly one `committed` or
/// `cancelled` ends every `lifted`. The view never opens, closes or navigates the publication.
public final class BookView: MTKView {
    /// The book it shows.
    public let book: Book
    /// Called on the main thread for everything the book tells.
    public var onNotice: ((Notice) -> Void)?
    /// Called on the main thread when a call failed: a closed book, a page that could not be uploaded.
    public var onError: ((Error) -> Void)?
    /// What moves; `nil` follows the system's "Reduce Motion".
    public var preferredMotion: Motion? { didSet { followMotion() } }
    /// Which way the publication is read: what a screen reader's swipe to the left means.
    public var direction = Direction.ltr
    /// Whether fingers feel the paper.
    public var hasHaptics = true
    /// What a screen reader says of a page, counted from 1, of a book with so many pages.
    public var announcement: (_ page: Int, _ pages: Int) -> String = { "Page \($0) of \($1)" }

    let renderer: BookRenderer
    let source: PageSource
    var fingers = Fingers()
    let pictureQueue = DispatchQueue(label: "dogleaf.pictures", qos: .userInitiated)
    var asked: Set<Int> = []
    private let ticks = UIImpactFeedbackGenerator(style: .light)

    /// A view of a book whose pages `source` draws.
    ///
    /// Throws ``RendererError`` where there is no Metal, and what ``BookRenderer`` throws.
    public init(book: Book, source: PageSource, frame: CGRect = .zero) throws {
        guard let device = MTLCreateSystemDefaultDevice() else { throw RendererError.shaders("no Metal device") }
        (self.book, self.source) = (book, source)
        renderer = try BookRenderer(book: book, device: device)
        super.init(frame: frame, device: device)
        colorPixelFormat = .bgra8Unorm
        depthStencilPixelFormat = .depth32Float
        sampleCount = 4
        enableSetNeedsDisplay = false
        isPaused = true
        isMultipleTouchEnabled = true
        isAccessibilityElement = true
        accessibilityTraits = .causesPageTurn
        delegate = self
        watchSystem()
        followMotion()
    }

    /// Not made by storyboards: it needs a book.
    @available(*, unavailable)
    public required init(coder: NSCoder) {
        fatalError("a BookView is made with a book")
    }

    /// Turns leaves on, or back: for keys and buttons. `false` while a leaf is in the air and at either end.
    @discardableResult
    public func turn(forward: Bool, leaves: UInt16 = 1) -> Bool {
        defer { wake() }
        do {
            try book.turn(forward: forward, leaves: leaves)
            return true
        } catch {
            return false
        }
    }

    /// Has frames made again until the book rests.
    public func wake() {
        isPaused = false
    }

    /// A view that is taken off its window rests.
    public override func didMoveToWindow() {
        super.didMoveToWindow()
        if window == nil { rest() } else { goOn() }
    }

    /// Does something with the book, and tells the app if it fails.
    func attempt(_ work: () throws -> Void) {
        do {
            try work()
        } catch {
            onError?(error)
        }
    }

    @objc func rest() {
        attempt { try book.pause() }
        fingers = Fingers()
        isPaused = true
    }

    @objc func goOn() {
        guard window != nil else { return }
        attempt {
            try book.resume()
            try book.redraw()
            readOut(Int(try book.page()))
        }
        wake()
    }

    @objc func followMotion() {
        let reduced = Motion(policy: UIAccessibility.isReduceMotionEnabled ? .reduced : .full, capUs: nil)
        attempt { try book.setMotion(motion: preferredMotion ?? reduced) }
        wake()
    }

    private func watchSystem() {
        let center = NotificationCenter.default
        let changes: [(Notification.Name, Selector)] = [
            (UIApplication.didEnterBackgroundNotification, #selector(rest)),
            (UIApplication.willEnterForegroundNotification, #selector(goOn)),
            (UIAccessibility.reduceMotionStatusDidChangeNotification, #selector(followMotion)),
        ]
        for (name, selector) in changes {
            center.addObserver(self, selector: selector, name: name, object: nil)
        }
    }

    func tell(_ notice: Notice) {
        switch notice {
        case .announce(let page, let pages):
            let said = announcement(Int(page) + 1, Int(pages))
            accessibilityValue = said
            readOut(Int(page))
            UIAccessibility.post(notification: .pageScrolled, argument: said)
        case .haptic(let tick):
            if hasHaptics { feel(tick) }
        case .lifted:
            ticks.prepare()
        case .held, .committed, .cancelled, .asleep:
            break
        }
        onNotice?(notice)
    }

    /// What the screen reader says of the two pages that are open; the left one stands before `page`.
    private func readOut(_ page: Int) {
        pictureQueue.async { [weak self, source] in
            let open = [page - 1, page].filter { $0 >= 0 && $0 < source.pageCount }
            let text = open.compactMap { source.text(page: $0) }.joined(separator: "\n")
            DispatchQueue.main.async { self?.accessibilityLabel = text }
        }
    }

    private func feel(_ tick: Tick) {
        switch tick {
        case .lift: ticks.impactOccurred(intensity: 0.4)
        case .over: ticks.impactOccurred(intensity: 0.3)
        case .land: ticks.impactOccurred(intensity: 0.8)
        case .flip: ticks.impactOccurred(intensity: 0.5)
        }
    }
}
#endif
