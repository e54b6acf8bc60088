// Promise: the same book as in Rust, through Swift.

import XCTest

@testable import Dogleaf

final class BookTests: XCTestCase {
    private func ends(_ told: [Notice]) -> Int {
        told.filter { notice in
            switch notice {
            case .committed, .cancelled: return true
            default: return false
            }
        }.count
    }

    private func commits(_ told: [Notice]) -> Int {
        told.filter { if case .committed = $0 { return true } else { return false } }.count
    }

    func testOneGestureGivesOneHashInRustAndInSwift() throws {
        let rows = try golden()
        XCTAssertGreaterThanOrEqual(rows.count, 5, "the table of Rust is there")
        for row in rows {
            let book = try Book.open(options: paperback())
            let (frames, told) = try book.play(gesture(row.gesture))
            let hash = String(try book.stateHash(), radix: 16)
            XCTAssertEqual(String(repeating: "0", count: 16 - hash.count) + hash, row.hash, row.gesture)
            XCTAssertEqual(frames, row.frames, row.gesture)
            XCTAssertEqual(try book.page(), row.page, row.gesture)
            XCTAssertEqual(commits(told), row.commits, row.gesture)
        }
    }

    func testADragCommitsExactlyOnceAndIsAnnounced() throws {
        let book = try Book.open(options: paperback())
        let (_, told) = try book.play(gesture("slow_turn"))
        XCTAssertEqual(ends(told), 1)
        XCTAssertTrue(told.contains(.committed(page: 122)))
        XCTAssertTrue(told.contains(.announce(page: 122, pages: 320)))
        XCTAssertTrue(told.contains(.haptic(tick: .land)))
        XCTAssertFalse(try book.needsFrame(), "asleep is asleep")
    }

    func testAFingerThatIsTakenAwayCancelsExactlyOnce() throws {
        let book = try Book.open(options: paperback())
        var drag = Array(try gesture("slow_turn").prefix(120))
        var away = try XCTUnwrap(drag.last)
        away.phase = .cancel
        drag.append(away)
        let (_, told) = try book.play(drag)
        XCTAssertEqual(ends(told), 1)
        XCTAssertTrue(told.contains(.cancelled))
        XCTAssertEqual(try book.page(), 120)
    }

    func testTheMeshStaysWhereItIsAndIsSeenWithoutACopy() throws {
        let book = try Book.open(options: paperback())
        let meshView = try book.mesh()
        let bytes = meshView.bytes
        XCTAssertEqual(bytes.count, Int(meshView.vertices) * Int(meshView.stride))
        XCTAssertEqual(meshView.stride, 32)
        var highest: Float = 0
        _ = try book.play(gesture("slow_turn")) { _ in
            for n in 0..<Int(meshView.vertices) {
                highest = max(highest, bytes.load(fromByteOffset: n * 32 + 4, as: Float.self))
            }
        }
        XCTAssertEqual(try book.mesh().address, meshView.address)
        XCTAssertTrue((0.05...0.2).contains(highest), "the leaf rose through the buffer: \(highest) m")
        XCTAssertGreaterThan(try book.indices().bytes.count, 6_000)
    }

    func testErrorsSayWhatIsWrong() throws {
        var options = paperback()
        options.pages = 0
        XCTAssertThrowsError(try Book.open(options: options)) { error in
            guard case DogleafError.Refused(let why) = error else { return XCTFail("\(error)") }
            XCTAssertTrue(why.contains("book.pages"), why)
        }
        options = paperback()
        options.openAt = 0
        let book = try Book.open(options: options)
        assertRefused(.NoSuchPage(message: ""), try book.turn(forward: false, leaves: 1))
        try book.turn(forward: true, leaves: 1)
        assertRefused(.Busy(message: ""), try book.turn(forward: true, leaves: 1))
        assertRefused(.Recording(message: ""), try book.restore(bytes: Data([1, 2, 3])))
        book.shut()
        assertRefused(.Closed(message: ""), try book.step(nowUs: 1))
    }

    func testASnapshotSurvivesTheProcess() throws {
        let book = try Book.open(options: paperback())
        try book.turn(forward: true, leaves: 3)
        try book.pause()
        let bytes = try book.snapshot()
        XCTAssertLessThan(bytes.count, 400)
        XCTAssertEqual(try Book.fromSnapshot(bytes: bytes).pages(), 320)
    }

    func testARecordingIsADlrFile() throws {
        let book = try Book.open(options: paperback())
        let recorder = Recorder(book: book)
        XCTAssertTrue(try recorder.start())
        _ = try book.play(gesture("flick"))
        let bytes = try XCTUnwrap(try recorder.stop())
        XCTAssertEqual(bytes.prefix(4), Data("DLR1".utf8))
        XCTAssertGreaterThan(bytes.count, 500)
        XCTAssertNil(try recorder.stop(), "only one")
    }

    /// The same case of the error, whatever its message.
    private func assertRefused<Answer>(
        _ expected: DogleafError, _ work: @autoclosure () throws -> Answer, line: UInt = #line
    ) {
        XCTAssertThrowsError(try work(), line: line) { error in
            let name = { (of: Any) in String(describing: of).split(separator: "(").first.map(String.init) }
            XCTAssertEqual(name(error), name(expected), line: line)
        }
    }
}
