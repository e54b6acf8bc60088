// What each piece of the book is made of: the piece's uniforms of the page shader.

/// How the shader shall take a piece: its uniforms of the same names.
struct Look: Equatable {
    /// Which leaf's light may pass a piece.
    enum Passing {
        case none
        case held
        case flying
    }

    /// 0 paper, 1 the cut edges of leaves, 2 a board, 3 the table.
    var material: Int32 = 0
    /// Linear colour of the bare surface.
    var tint = Look.paper
    /// Leaves whose edges are seen.
    var leaves: Float = 0
    /// The page on this side.
    var front: Int?
    /// The page on the other side of the same leaf.
    var back: Int?
    /// Whether light passes it.
    var passing = Passing.none

    private static let paper = SIMD4<Float>(0.905, 0.885, 0.835, 0)
    private static let cloth = SIMD4<Float>(0.16, 0.035, 0.03, 0)
    private static let wood = SIMD4<Float>(0.105, 0.066, 0.042, 0)

    /// The table's.
    static let table = Look(material: 3, tint: wood)

    /// That of a piece.
    static func of(_ piece: Piece) -> Look {
        switch piece.surface {
        case .leftSides, .rightSides: return Look(material: 1, leaves: Float(piece.leaves))
        case .leftBoard, .rightBoard, .spine: return Look(material: 2, tint: cloth)
        case .leftTop, .rightTop: return Look(front: page(piece.face))
        case .leftBottom, .rightBottom: return Look()
        case .leafRim where piece.leaves > 1: return Look(material: 1, leaves: Float(piece.leaves))
        case .leafRim, .leafUp, .leafDown: return leaf(piece)
        }
    }

    private static func leaf(_ piece: Piece) -> Look {
        Look(
            front: page(piece.face), back: piece.reverse.map(Int.init),
            passing: piece.flying ? .flying : .held)
    }

    private static func page(_ face: PieceFace) -> Int? {
        if case .page(let page) = face { return Int(page) }
        return nil
    }
}
