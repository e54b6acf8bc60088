// The frame loop of a BookView.

#if canImport(UIKit) && canImport(MetalKit)
import MetalKit
import UIKit

extension BookView: MTKViewDelegate {
    /// The view has another size.
    public func mtkView(_ view: MTKView, drawableSizeWillChange size: CGSize) {
        guard size.width >= 1, size.height >= 1 else { return }
        attempt {
            try book.resize(widthPx: UInt32(size.width), heightPx: UInt32(size.height))
            try renderer.restage()
        }
        wake()
    }

    /// One frame: time passes, notices are told, and what changed is drawn.
    public func draw(in view: MTKView) {
        attempt {
            let frame = try book.step(nowUs: Fingers.microseconds(CACurrentMediaTime()))
            isPaused = !frame.needsFrame
            if frame.draw { try show(frame) }
            if frame.notices > 0 {
                for notice in try book.notices() { tell(notice) }
            }
        }
    }

    private func show(_ frame: FrameInfo) throws {
        try renderer.update(frame)
        try fetchPages()
        guard
            let pass = currentRenderPassDescriptor,
            let drawable = currentDrawable,
            let commands = renderer.queue.makeCommandBuffer()
        else {
            // The picture is owed: asked for again at the next frame.
            try book.redraw()
            return wake()
        }
        try renderer.draw(frame, into: pass, with: commands)
        commands.present(drawable)
        commands.commit()
    }

    /// Asks for the pictures of the pages that are seen, then of their neighbours, and drops those far away.
    private func fetchPages() throws {
        let open = Int(try book.page())
        let near = (open - 4...open + 5).filter { !renderer.hasPage($0) }
        renderer.keepPages { abs($0 - open) <= 12 }
        let count = source.pageCount
        let height = Int(drawableSize.height)
        for page in renderer.missingPages() + near where page >= 0 && page < count {
            guard asked.insert(page).inserted else { continue }
            pictureQueue.async { [weak self, source] in
                let picture = source.picture(page: page, height: height)
                DispatchQueue.main.async { self?.take(picture, of: page) }
            }
        }
    }

    private func take(_ picture: PagePicture?, of page: Int) {
        // A page that could not be drawn stays asked for: it is blank, and not tried at every frame.
        guard let picture else { return }
        asked.remove(page)
        attempt {
            try renderer.setPage(page, picture)
            try book.redraw()
        }
        wake()
    }
}
#endif
