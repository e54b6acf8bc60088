// BookView in SwiftUI.

import Dogleaf
import SwiftUI

/// A PDF as a book; its snapshot is kept in the app's defaults.
struct BookScreen: UIViewRepresentable {
    let url: URL
    let remote: Remote
    let turned: (Int) -> Void

    func makeUIView(context: Context) -> UIView {
        guard let source = PDFPageSource(url: url), let view = try? bookView(of: source) else { return UIView() }
        let (key, turned) = (self.key, self.turned)
        view.onNotice = { [weak view] notice in
            guard case .committed(let page) = notice, let book = view?.book else { return }
            UserDefaults.standard.set(try? book.snapshot(), forKey: key)
            turned(Int(page))
        }
        remote.view = view
        return view
    }

    func updateUIView(_ view: UIView, context: Context) {}

    private var key: String { "snapshot of \(url.lastPathComponent)" }

    private func bookView(of source: PageSource) throws -> BookView {
        try BookView(book: book(of: source), source: source)
    }

    /// The book as it was left, or from its first page.
    private func book(of source: PageSource) throws -> Book {
        if let bytes = UserDefaults.standard.data(forKey: key), let book = try? Book.fromSnapshot(bytes: bytes),
            try book.pages() == UInt32(source.pageCount)
        {
            return book
        }
        var options = bookOptions(pages: UInt32(source.pageCount), widthPx: 1024, heightPx: 768)
        options.widthM = options.heightM * source.aspect
        return try Book.open(options: options)
    }
}
