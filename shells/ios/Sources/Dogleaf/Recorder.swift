// Recordings of what a reader did, for a bug report.

import Foundation

/// Records what a ``Book`` is given, and its hash after every step: `dogleaf replay` runs the bytes again.
public final class Recorder {
    private let book: Book
    private var isRunning = false

    /// A recorder that does not run yet.
    public init(book: Book) {
        self.book = book
    }

    /// Begins; `false` while a leaf is in the air or the book is paused. The book is opened anew at its page.
    ///
    /// Throws ``DogleafError`` for anything else, a closed book say.
    public func start() throws -> Bool {
        do {
            try book.startRecording()
            isRunning = true
        } catch DogleafError.Busy {
            isRunning = false
        } catch DogleafError.Paused {
            isRunning = false
        }
        return isRunning
    }

    /// Ends: the bytes of a `.dlr` file, or `nil` if there is none.
    public func stop() throws -> Data? {
        guard isRunning else { return nil }
        isRunning = false
        do {
            return try book.stopRecording()
        } catch DogleafError.Recording {
            return nil
        }
    }
}
