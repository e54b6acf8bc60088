// Textures: the pages, blank paper, the table's wood.

#if canImport(Metal)
import Foundation
import Metal

/// The pictures a renderer holds.
final class Pictures {
    /// White: a page that has no picture.
    let blank: MTLTexture
    /// The wood of the table.
    let grain: MTLTexture
    private let device: MTLDevice
    private let queue: MTLCommandQueue
    private var pages: [Int: MTLTexture] = [:]

    init(device: MTLDevice, queue: MTLCommandQueue, pipelines: Pipelines) throws {
        self.device = device
        self.queue = queue
        blank = try Self.texture(device, width: 1, height: 1, format: .rgba8Unorm, usage: .shaderRead)
        blank.replace(
            region: MTLRegionMake2D(0, 0, 1, 1), mipmapLevel: 0, withBytes: [UInt8](repeating: 255, count: 4),
            bytesPerRow: 4)
        grain = try Self.texture(
            device, width: 192, height: 1536, format: Pipelines.grainFormat, usage: [.renderTarget, .shaderRead])
        try draw(grain, with: pipelines.grain)
    }

    subscript(page: Int?) -> MTLTexture { page.flatMap { pages[$0] } ?? blank }

    func has(_ page: Int) -> Bool { pages[page] != nil }

    func set(_ page: Int, _ picture: PagePicture) throws {
        let (width, height) = (picture.width, picture.height)
        let texture = try Self.texture(
            device, width: width, height: height, format: .rgba8Unorm, usage: .shaderRead)
        picture.rgba.withUnsafeBytes { bytes in
            guard let first = bytes.baseAddress else { return }
            texture.replace(
                region: MTLRegionMake2D(0, 0, width, height), mipmapLevel: 0, withBytes: first,
                bytesPerRow: 4 * width)
        }
        let commands = try self.commands()
        try chain(texture, commands)
        commands.commit()
        pages[page] = texture
    }

    func keep(_ wanted: (Int) -> Bool) {
        pages = pages.filter { wanted($0.key) }
    }

    private func draw(_ grain: MTLTexture, with pipeline: MTLRenderPipelineState) throws {
        let pass = MTLRenderPassDescriptor()
        pass.colorAttachments[0].texture = grain
        pass.colorAttachments[0].loadAction = .dontCare
        pass.colorAttachments[0].storeAction = .store
        let commands = try self.commands()
        guard let encoder = commands.makeRenderCommandEncoder(descriptor: pass) else { throw RendererError.outOfMemory }
        encoder.setRenderPipelineState(pipeline)
        encoder.drawPrimitives(type: .triangle, vertexStart: 0, vertexCount: 3)
        encoder.endEncoding()
        try chain(grain, commands)
        commands.commit()
    }

    private func commands() throws -> MTLCommandBuffer {
        guard let commands = queue.makeCommandBuffer() else { throw RendererError.outOfMemory }
        return commands
    }

    private func chain(_ texture: MTLTexture, _ commands: MTLCommandBuffer) throws {
        guard texture.mipmapLevelCount > 1 else { return }
        guard let encoder = commands.makeBlitCommandEncoder() else { throw RendererError.outOfMemory }
        encoder.generateMipmaps(for: texture)
        encoder.endEncoding()
    }

    private static func texture(
        _ device: MTLDevice, width: Int, height: Int, format: MTLPixelFormat, usage: MTLTextureUsage
    ) throws -> MTLTexture {
        let of = MTLTextureDescriptor.texture2DDescriptor(
            pixelFormat: format, width: width, height: height, mipmapped: width > 1 || height > 1)
        of.usage = usage
        guard let texture = device.makeTexture(descriptor: of) else { throw RendererError.outOfMemory }
        return texture
    }
}
#endif
