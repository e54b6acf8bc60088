// A book drawn by Metal: one mesh, one program for all that is seen, one for what throws shadows.

#if canImport(Metal)
import Dispatch
import Metal

/// Draws one ``Book`` into whatever a render pass draws into. It knows no view and no input.
///
/// Use it on one thread: the one that steps the book.
public final class BookRenderer {
    /// Encoded sRGB where nothing is drawn.
    public static let background = MTLClearColor(red: 0.152, green: 0.152, blue: 0.152, alpha: 1)

    /// The device it draws with.
    public let device: MTLDevice
    /// The queue its commands go to.
    public let queue: MTLCommandQueue

    private let book: Book
    private let pipelines: Pipelines
    private let pictures: Pictures
    private let lampMaps: DepthMaps
    private let skyMaps: DepthMaps
    private let vertices: UnsafeRawBufferPointer
    private let indices: MTLBuffer
    /// As many as frames may be under way: the processor fills one while the others are read.
    private let copies: [MTLBuffer]
    private let free: DispatchSemaphore
    private let table: MTLBuffer
    private let tableIndices: MTLBuffer

    private var copy = 0
    private var stage: Stage
    private var uniforms: FrameUniforms
    private var pieces: [(piece: Piece, look: Look)] = []
    private var piecesGeneration: UInt64?
    private var mapsGeneration: UInt64?

    private static let framesUnderWay = 3
    private static let lamps = 16
    private static let skies = 32
    /// Half a side of the table, metres.
    private static let tableM: Float = 3

    /// A renderer for targets of these formats, with so many samples a pixel. `depth` is that of the pass's depth attachment.
    ///
    /// Throws ``RendererError``, ``DogleafError``, or what Metal says.
    public init(
        book: Book, device: MTLDevice, colour: MTLPixelFormat = .bgra8Unorm,
        depth: MTLPixelFormat = .depth32Float, samples: Int = 4
    ) throws {
        guard let queue = device.makeCommandQueue() else { throw RendererError.outOfMemory }
        (self.book, self.device, self.queue) = (book, device, queue)
        pipelines = try Pipelines(device: device, colour: colour, depth: depth, samples: samples)
        pictures = try Pictures(device: device, queue: queue, pipelines: pipelines)
        lampMaps = try DepthMaps(device: device, count: Self.lamps, across: 4, side: 512)
        skyMaps = try DepthMaps(device: device, count: Self.skies, across: 8, side: 192)
        let corners = try book.mesh().bytes
        vertices = corners
        indices = try Self.buffer(device, book.indices().bytes)
        copies = try (0..<Self.framesUnderWay).map { _ in try Self.buffer(device, corners) }
        free = DispatchSemaphore(value: Self.framesUnderWay)
        table = try Self.buffer(device, [UInt8](repeating: 0, count: 4 * 32))
        tableIndices = try Self.buffer(device, [0, 1, 2, 0, 2, 3] as [UInt16])
        stage = try book.stage()
        uniforms = FrameUniforms(stage)
        layTable()
    }

    /// Takes note of another view: after ``Book/look(gaze:widthPx:heightPx:)`` or ``Book/resize(widthPx:heightPx:)``.
    public func restage() throws {
        stage = try book.stage()
        uniforms = FrameUniforms(stage)
        layTable()
    }

    /// Whether a page's picture is there.
    public func hasPage(_ page: Int) -> Bool { pictures.has(page) }

    /// Pages that the book shows as of the last ``update(_:)`` and whose pictures are missing.
    public func missingPages() -> [Int] {
        let shown = pieces.flatMap { [$0.look.front, $0.look.back] }.compactMap { $0 }
        return Set(shown).filter { !pictures.has($0) }.sorted()
    }

    /// Takes a page's picture.
    public func setPage(_ page: Int, _ picture: PagePicture) throws {
        try pictures.set(page, picture)
    }

    /// Gives back the pictures of all pages but these.
    public func keepPages(_ wanted: (Int) -> Bool) {
        pictures.keep(wanted)
    }

    /// Takes over which pages a step's mesh shows, if that changed; ``draw(_:into:with:)`` does it too.
    public func update(_ frame: FrameInfo) throws {
        guard frame.piecesGeneration != piecesGeneration else { return }
        pieces = try book.pieces().filter(\.visible).map { (piece: $0, look: Look.of($0)) }
        piecesGeneration = frame.piecesGeneration
    }

    /// Encodes the book as of `frame`: its shadow maps, then the picture into `pass`, in the size of the book's view.
    ///
    /// Commit `commands` afterwards; at most three frames are under way at once.
    public func draw(_ frame: FrameInfo, into pass: MTLRenderPassDescriptor, with commands: MTLCommandBuffer) throws {
        try update(frame)
        free.wait()
        var isEncoded = false
        defer { if !isEncoded { free.signal() } }
        copy = (copy + 1) % copies.count
        if let from = vertices.baseAddress {
            copies[copy].contents().copyMemory(from: from, byteCount: vertices.count)
        }
        if frame.generation != mapsGeneration {
            lampMaps.fill(commands, first: 0, draw: map)
            skyMaps.fill(commands, first: Self.lamps, draw: map)
            mapsGeneration = frame.generation
        }
        pass.colorAttachments[0].clearColor = Self.background
        guard let encoder = commands.makeRenderCommandEncoder(descriptor: pass) else { throw RendererError.outOfMemory }
        begin(encoder)
        for (piece, look) in pieces {
            take(look, frame, encoder)
            draw(Int(piece.firstIndex), Int(piece.indexCount), encoder)
        }
        // Last: most of it is hidden by then.
        take(.table, frame, encoder)
        encoder.setVertexBuffer(table, offset: 0, index: 0)
        encoder.drawIndexedPrimitives(
            type: .triangle, indexCount: 6, indexType: .uint16, indexBuffer: tableIndices, indexBufferOffset: 0)
        encoder.endEncoding()
        commands.addCompletedHandler { [free] _ in free.signal() }
        isEncoded = true
    }

    private func begin(_ encoder: MTLRenderCommandEncoder) {
        encoder.setRenderPipelineState(pipelines.page)
        encoder.setDepthStencilState(pipelines.nearest)
        encoder.setFrontFacing(.counterClockwise)
        encoder.setCullMode(.back)
        encoder.setVertexBuffer(copies[copy], offset: 0, index: 0)
        encoder.setVertexBytes(&uniforms, length: MemoryLayout<FrameUniforms>.stride, index: 1)
        encoder.setFragmentBytes(&uniforms, length: MemoryLayout<FrameUniforms>.stride, index: 1)
        encoder.setFragmentTexture(pictures.grain, index: 2)
        encoder.setFragmentTexture(lampMaps.texture, index: 3)
        encoder.setFragmentTexture(skyMaps.texture, index: 4)
    }

    private func take(_ look: Look, _ frame: FrameInfo, _ encoder: MTLRenderCommandEncoder) {
        var of = PieceUniforms(look, frame: frame, leafM: stage.leafM)
        encoder.setFragmentBytes(&of, length: MemoryLayout<PieceUniforms>.stride, index: 2)
        encoder.setFragmentTexture(pictures[look.front], index: 0)
        encoder.setFragmentTexture(pictures[look.back], index: 1)
    }

    /// Draws all that casts shadows into one map.
    private func map(_ encoder: MTLRenderCommandEncoder, number: Int32) {
        var number = number
        encoder.setRenderPipelineState(pipelines.shadow)
        encoder.setDepthStencilState(pipelines.nearest)
        encoder.setVertexBuffer(copies[copy], offset: 0, index: 0)
        encoder.setVertexBytes(&uniforms, length: MemoryLayout<FrameUniforms>.stride, index: 1)
        encoder.setVertexBytes(&number, length: MemoryLayout<Int32>.stride, index: 2)
        var run = 0..<0
        // Pieces that follow each other in the buffer are drawn in one go.
        for (piece, _) in pieces {
            let own = Int(piece.firstIndex)..<Int(piece.firstIndex + piece.indexCount)
            if own.lowerBound != run.upperBound {
                draw(run.lowerBound, run.count, encoder)
                run = own
            }
            run = run.lowerBound..<own.upperBound
        }
        draw(run.lowerBound, run.count, encoder)
    }

    private func draw(_ first: Int, _ count: Int, _ encoder: MTLRenderCommandEncoder) {
        guard count > 0 else { return }
        encoder.drawIndexedPrimitives(
            type: .triangle, indexCount: count, indexType: .uint16, indexBuffer: indices,
            indexBufferOffset: first * MemoryLayout<UInt16>.stride)
    }

    private func layTable() {
        let (m, y) = (Self.tableM, stage.tableY)
        let corners = [(-m, -m), (-m, m), (m, m), (m, -m)]
        let floats: [Float] = corners.flatMap { x, z in [x, y, z, 0, 1, 0, 0.5, 0.5] }
        floats.withUnsafeBytes { bytes in
            guard let from = bytes.baseAddress else { return }
            table.contents().copyMemory(from: from, byteCount: bytes.count)
        }
    }

    private static func buffer(_ device: MTLDevice, _ bytes: UnsafeRawBufferPointer) throws -> MTLBuffer {
        guard
            let from = bytes.baseAddress,
            let buffer = device.makeBuffer(bytes: from, length: bytes.count, options: .storageModeShared)
        else { throw RendererError.outOfMemory }
        return buffer
    }

    private static func buffer<Value>(_ device: MTLDevice, _ values: [Value]) throws -> MTLBuffer {
        try values.withUnsafeBytes { try buffer(device, $0) }
    }
}
#endif
