// The pages of a PDF.

#if canImport(PDFKit)
import CoreGraphics
import Foundation
import PDFKit

/// A PDF document as a ``PageSource``.
public final class PDFPageSource: PageSource {
    private let document: PDFDocument

    /// The document in a file; `nil` if there is none that can be read without a password.
    public init?(url: URL) {
        guard let document = PDFDocument(url: url), !document.isLocked, document.pageCount > 0 else { return nil }
        self.document = document
    }

    /// Pages of the document.
    public var pageCount: Int { document.pageCount }

    /// That of the first page.
    public var aspect: Double {
        guard let size = document.page(at: 0)?.bounds(for: .cropBox).size, size.height > 0 else { return 0.7 }
        return Double(size.width / size.height)
    }

    /// The page on white.
    public func picture(page: Int, height: Int) -> PagePicture? {
        guard page < document.pageCount, let found = document.page(at: page) else { return nil }
        let bounds = found.bounds(for: .cropBox)
        guard bounds.width > 0, bounds.height > 0, height > 0 else { return nil }
        let scale = CGFloat(height) / bounds.height
        let width = max(1, Int((bounds.width * scale).rounded()))
        var rgba = Data(count: 4 * width * height)
        let drawn = rgba.withUnsafeMutableBytes { bytes in
            draw(found, scale: scale, width: width, height: height, into: bytes.baseAddress)
        }
        return drawn ? PagePicture(width: width, height: height, rgba: rgba) : nil
    }

    /// The text PDFKit finds on the page.
    public func text(page: Int) -> String? {
        page < document.pageCount ? document.page(at: page)?.string : nil
    }

    private func draw(
        _ page: PDFPage, scale: CGFloat, width: Int, height: Int, into bytes: UnsafeMutableRawPointer?
    ) -> Bool {
        guard
            let space = CGColorSpace(name: CGColorSpace.sRGB),
            let context = CGContext(
                data: bytes, width: width, height: height, bitsPerComponent: 8, bytesPerRow: 4 * width,
                space: space, bitmapInfo: CGImageAlphaInfo.premultipliedLast.rawValue)
        else { return false }
        context.setFillColor(red: 1, green: 1, blue: 1, alpha: 1)
        context.fill(CGRect(x: 0, y: 0, width: width, height: height))
        context.scaleBy(x: scale, y: scale)
        page.draw(with: .cropBox, to: context)
        return true
    }
}
#endif
