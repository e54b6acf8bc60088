// Where the pictures of pages come from.

import Foundation

/// A page's picture: RGBA bytes, sRGB, rows from the top, opaque.
public struct PagePicture: Sendable {
    /// Pixels across.
    public let width: Int
    /// Pixels down.
    public let height: Int
    /// Four bytes a pixel.
    public let rgba: Data

    /// A picture of these bytes; `nil` unless there are four a pixel.
    public init?(width: Int, height: Int, rgba: Data) {
        guard width > 0, height > 0, rgba.count == 4 * width * height else { return nil }
        self.width = width
        self.height = height
        self.rgba = rgba
    }
}

/// A publication that draws its pages. It is asked on one background queue, a page at a time.
public protocol PageSource: AnyObject {
    /// Printed pages.
    var pageCount: Int { get }
    /// Width of a page as a share of its height.
    var aspect: Double { get }
    /// The picture of a page counted from 0, about `height` pixels high; `nil` leaves the page blank.
    func picture(page: Int, height: Int) -> PagePicture?
    /// What a screen reader says of a page; `nil` if there is no text.
    func text(page: Int) -> String?
}

extension PageSource {
    /// No text.
    public func text(page: Int) -> String? { nil }
}
