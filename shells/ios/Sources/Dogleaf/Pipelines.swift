// The programs of the renderer, compiled once.

#if canImport(Metal)
import Foundation
import Metal

/// Why a renderer could not be made.
public enum RendererError: Error {
    /// The device gave no memory, no queue or no encoder.
    case outOfMemory
    /// The shaders are not in the package's bundle, or do not compile; the text says more.
    case shaders(String)
}

/// Pipelines and what they share.
struct Pipelines {
    let page: MTLRenderPipelineState
    let shadow: MTLRenderPipelineState
    let grain: MTLRenderPipelineState
    let nearest: MTLDepthStencilState

    static let grainFormat = MTLPixelFormat.rgba8Unorm

    init(device: MTLDevice, colour: MTLPixelFormat, depth: MTLPixelFormat, samples: Int) throws {
        let library = try Self.library(device)
        func pipeline(
            _ vertex: String, _ fragment: String?, _ colour: MTLPixelFormat, _ depth: MTLPixelFormat,
            samples: Int = 1
        ) throws -> MTLRenderPipelineState {
            let of = MTLRenderPipelineDescriptor()
            of.vertexFunction = try Self.function(vertex, in: library)
            of.fragmentFunction = try fragment.map { try Self.function($0, in: library) }
            of.colorAttachments[0].pixelFormat = colour
            of.depthAttachmentPixelFormat = depth
            of.rasterSampleCount = samples
            return try device.makeRenderPipelineState(descriptor: of)
        }
        page = try pipeline("page_vertex", "page_fragment", colour, depth, samples: samples)
        shadow = try pipeline("shadow_vertex", nil, .invalid, DepthMaps.format)
        grain = try pipeline("grain_vertex", "grain_fragment", Self.grainFormat, .invalid)
        let less = MTLDepthStencilDescriptor()
        less.depthCompareFunction = .less
        less.isDepthWriteEnabled = true
        guard let nearest = device.makeDepthStencilState(descriptor: less) else { throw RendererError.outOfMemory }
        self.nearest = nearest
    }

    /// Compiled by Xcode; from its text where only SwiftPM built the package.
    private static func library(_ device: MTLDevice) throws -> MTLLibrary {
        if let compiled = try? device.makeDefaultLibrary(bundle: .module) { return compiled }
        guard let url = Bundle.module.url(forResource: "Shaders", withExtension: "metal") else {
            throw RendererError.shaders("neither default.metallib nor Shaders.metal is in the bundle")
        }
        return try device.makeLibrary(source: String(contentsOf: url, encoding: .utf8), options: nil)
    }

    private static func function(_ name: String, in library: MTLLibrary) throws -> MTLFunction {
        guard let found = library.makeFunction(name: name) else { throw RendererError.shaders("no \(name)") }
        return found
    }
}
#endif
