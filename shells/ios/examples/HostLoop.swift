// All a reader has to do to replace its page curl, without BookView: a book, a renderer, four calls a frame.
// The clock is that of touches and display links: seconds since the device started.

import Dogleaf
import MetalKit

final class PageTurn: NSObject, MTKViewDelegate {
    private let book: Book
    private let renderer: BookRenderer
    private let picture: (Int) -> PagePicture?
    private let committed: (Int) -> Void

    init(pages: Int, view: MTKView, device: MTLDevice, picture: @escaping (Int) -> PagePicture?, committed: @escaping (Int) -> Void) throws {
        let size = view.drawableSize
        book = try Book.open(options: bookOptions(pages: UInt32(pages), widthPx: UInt32(max(1, size.width)), heightPx: UInt32(max(1, size.height))))
        renderer = try BookRenderer(book: book, device: device)
        (self.picture, self.committed) = (picture, committed)
        super.init()
        (view.device, view.depthStencilPixelFormat, view.sampleCount) = (device, .depth32Float, 4)
        view.delegate = self
    }

    /// For every touch, with those that were coalesced; `view.isPaused = false` afterwards.
    func touch(id: UInt8, phase: Phase, x: Float, y: Float, seconds: Double) throws {
        let time = UInt64(seconds * 1_000_000)
        try book.pointer(sample: PointerSample(timeUs: time, id: id, phase: phase, x: x, y: y, leaves: 0))
    }

    func mtkView(_ view: MTKView, drawableSizeWillChange size: CGSize) {
        try? book.resize(widthPx: UInt32(size.width), heightPx: UInt32(size.height))
        try? renderer.restage()
    }

    func draw(in view: MTKView) {
        guard let frame = try? book.step(nowUs: UInt64(CACurrentMediaTime() * 1_000_000)) else { return }
        view.isPaused = !frame.needsFrame
        if frame.draw { try? draw(frame, view) }
        if frame.notices > 0 {
            for case .committed(let page) in (try? book.notices()) ?? [] { committed(Int(page)) }
        }
    }

    private func draw(_ frame: FrameInfo, _ view: MTKView) throws {
        try renderer.update(frame)
        for page in renderer.missingPages() {
            if let picture = picture(page) { try renderer.setPage(page, picture) }
        }
        guard let pass = view.currentRenderPassDescriptor, let drawable = view.currentDrawable,
            let commands = renderer.queue.makeCommandBuffer()
        else {
            view.isPaused = false
            return try book.redraw()
        }
        try renderer.draw(frame, into: pass, with: commands)
        commands.present(drawable)
        commands.commit()
    }
}
