// What the tests share: a book on a table, gestures of the fixtures, frames of sixty a second.

import Foundation
import XCTest

@testable import Dogleaf

let frameUs: UInt64 = 16_667

private let fixtures = URL(fileURLWithPath: #filePath)
    .deletingLastPathComponent().appendingPathComponent("../../../../fixtures").standardizedFileURL

/// A paperback of 320 pages, open at 120, in a view of 960 by 720.
func paperback() -> BookOptions {
    var options = bookOptions(pages: 320, widthPx: 960, heightPx: 720)
    options.openAt = 120
    return options
}

private struct Line: Decodable {
    var t_us: UInt64
    var id: UInt8?
    var phase: String
    var x: Int
    var y: Int
    var leaves: UInt16?
}

/// A gesture of the fixtures, in pixels.
func gesture(_ name: String) throws -> [PointerSample] {
    let file = fixtures.appendingPathComponent("gestures/\(name).jsonl")
    let phases: [String: Phase] = ["down": .down, "move": .move, "up": .up, "cancel": .cancel]
    return try String(contentsOf: file, encoding: .utf8).split(separator: "\n").map { text in
        let line = try JSONDecoder().decode(Line.self, from: Data(text.utf8))
        return PointerSample(
            timeUs: line.t_us, id: line.id ?? 0, phase: try XCTUnwrap(phases[line.phase]),
            x: Float(line.x) / 256, y: Float(line.y) / 256, leaves: line.leaves ?? 0)
    }
}

extension Book {
    /// Plays a gesture frame by frame until everything is at rest; answers the frames and what was told.
    func play(_ samples: [PointerSample], each: (FrameInfo) -> Void = { _ in }) throws -> (Int, [Notice]) {
        var told: [Notice] = []
        var rest = samples[...]
        for count in 1...3_000 {
            let now = UInt64(count) * frameUs
            let due = rest.prefix { $0.timeUs <= now }
            if !due.isEmpty { try pointers(samples: Array(due)) }
            rest = rest.dropFirst(due.count)
            let frame = try step(nowUs: now)
            if frame.notices > 0 { told += try notices() }
            each(frame)
            if rest.isEmpty && !frame.needsFrame { return (count, told) }
        }
        struct NeverAtRest: Error {}
        throw NeverAtRest()
    }
}

/// A row of the table that Rust wrote.
struct GoldenRow {
    let gesture: String
    let frames: Int
    let page: UInt32
    let commits: Int
    let hash: String
}

/// The whole table.
func golden() throws -> [GoldenRow] {
    let file = fixtures.appendingPathComponent("golden/bindings.txt")
    let lines = try String(contentsOf: file, encoding: .utf8).split(separator: "\n").dropFirst()
    return try lines.map { line in
        let cells = line.split(separator: " ").map(String.init)
        return GoldenRow(
            gesture: cells[0], frames: try XCTUnwrap(Int(cells[1])), page: try XCTUnwrap(UInt32(cells[2])),
            commits: try XCTUnwrap(Int(cells[3])), hash: cells[4])
    }
}
