// Promise: what the view hands to the book and the renderer to the card, where neither has to run.

import XCTest

@testable import Dogleaf

final class ShellTests: XCTestCase {
    private final class Touch {}

    func testFingersKeepTheirNumbersAndFreeOnesAreTakenAgain() {
        let (a, b, c) = (Touch(), Touch(), Touch())
        var fingers = Fingers()
        XCTAssertEqual(fingers.number(of: ObjectIdentifier(a)), 0)
        XCTAssertEqual(fingers.number(of: ObjectIdentifier(b)), 1)
        XCTAssertEqual(fingers.number(of: ObjectIdentifier(a)), 0, "while it lasts")
        fingers.forget(ObjectIdentifier(a))
        XCTAssertEqual(fingers.number(of: ObjectIdentifier(c)), 0)
        XCTAssertEqual(fingers.number(of: ObjectIdentifier(b)), 1)
    }

    func testTimeIsNeverBeforeTheStart() {
        XCTAssertEqual(Fingers.microseconds(1.5), 1_500_000)
        XCTAssertEqual(Fingers.microseconds(-1), 0)
    }

    func testLightPassesLeavesAndNothingElse() throws {
        let book = try Book.open(options: paperback())
        try book.turn(forward: true, leaves: 1)
        for n in 1...20 { _ = try book.step(nowUs: UInt64(n) * frameUs) }
        for piece in try book.pieces() where piece.visible {
            let look = Look.of(piece)
            let isLeaf = [.leafUp, .leafDown, .leafRim].contains(piece.surface)
            XCTAssertEqual(look.passing != .none, isLeaf, "\(piece.surface)")
            if piece.surface == .leafUp {
                XCTAssertEqual(look.front, 120)
                XCTAssertEqual(look.back, 121)
            }
        }
    }

    func testAPictureHasFourBytesAPixel() {
        XCTAssertNil(PagePicture(width: 2, height: 2, rgba: Data(count: 15)))
        XCTAssertNil(PagePicture(width: 0, height: 2, rgba: Data()))
        XCTAssertEqual(PagePicture(width: 2, height: 2, rgba: Data(count: 16))?.width, 2)
    }
}
