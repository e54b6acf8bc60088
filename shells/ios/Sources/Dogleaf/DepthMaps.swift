// Depth maps of the lamp and of the sky, many in one texture.

#if canImport(Metal)
import Metal

/// `count` maps of `side` texels, `across` beside each other; the sizes are those of the shaders.
struct DepthMaps {
    let texture: MTLTexture
    private let count: Int
    private let across: Int
    private let side: Int

    static let format = MTLPixelFormat.depth16Unorm

    init(device: MTLDevice, count: Int, across: Int, side: Int) throws {
        let size = MTLTextureDescriptor.texture2DDescriptor(
            pixelFormat: Self.format, width: across * side, height: count / across * side, mipmapped: false)
        size.usage = [.renderTarget, .shaderRead]
        size.storageMode = .private
        guard let texture = device.makeTexture(descriptor: size) else { throw RendererError.outOfMemory }
        self.texture = texture
        self.count = count
        self.across = across
        self.side = side
    }

    /// Draws every map: `draw` is told the number of each, counted from `first`.
    func fill(_ commands: MTLCommandBuffer, first: Int, draw: (MTLRenderCommandEncoder, Int32) -> Void) {
        let pass = MTLRenderPassDescriptor()
        pass.depthAttachment.texture = texture
        pass.depthAttachment.loadAction = .clear
        pass.depthAttachment.clearDepth = 1
        pass.depthAttachment.storeAction = .store
        guard let encoder = commands.makeRenderCommandEncoder(descriptor: pass) else { return }
        encoder.setCullMode(.none)
        for n in 0..<count {
            let x = Double(n % across * side)
            let y = Double(n / across * side)
            encoder.setViewport(
                MTLViewport(
                    originX: x, originY: y, width: Double(side), height: Double(side), znear: 0, zfar: 1))
            encoder.setScissorRect(MTLScissorRect(x: Int(x), y: Int(y), width: side, height: side))
            draw(encoder, Int32(first + n))
        }
        encoder.endEncoding()
    }
}
#endif
