// What the shaders are told, laid out as in Shaders.metal.

#if canImport(Metal)
import simd

/// True for a whole frame; 144 bytes.
struct FrameUniforms {
    var clipFromWorld = matrix_identity_float4x4
    var bound = SIMD4<Float>()
    /// Centre of the lamp and radius of its disc, metres.
    var lamp = SIMD4<Float>(-0.33, 0.66, -0.30, 0.065)
    /// Its light, linear.
    var lampColour = SIMD4<Float>(1.15, 1.15 * 0.93, 1.15 * 0.83, 0)
    var eye = SIMD4<Float>()
    var picture = SIMD2<Float>()
    var pixelAtOneMetre: Float = 0
    var unused: Float = 0

    /// As the book's stage has it.
    init(_ stage: Stage) {
        let m = stage.viewProjection
        func column(_ n: Int) -> SIMD4<Float> { SIMD4(m[4 * n], m[4 * n + 1], m[4 * n + 2], m[4 * n + 3]) }
        clipFromWorld = simd_float4x4(column(0), column(1), column(2), column(3))
        bound.w = stage.radiusM
        eye = SIMD4(stage.eye[0], stage.eye[1], stage.eye[2], 0)
        picture = SIMD2(Float(stage.widthPx), Float(stage.heightPx))
        pixelAtOneMetre = stage.pixelAtOneMetre
    }
}

/// True for a piece; 32 bytes.
struct PieceUniforms {
    var tint: SIMD4<Float>
    var material: Int32
    var passing: Float
    var thickness: Float
    var leaves: Float

    /// A look under the light of a frame.
    init(_ look: Look, frame: FrameInfo, leafM: Float) {
        switch look.passing {
        case .none: passing = 0
        case .held: passing = frame.through
        case .flying: passing = frame.flyingThrough
        }
        tint = look.tint
        material = look.material
        thickness = passing > 0 ? min(leafM, 0.001) : 0
        leaves = look.leaves
    }
}
#endif
