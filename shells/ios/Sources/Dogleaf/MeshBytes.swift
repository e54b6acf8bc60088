// Views of memory that is not ours.

extension MeshView {
    /// The vertices where the core keeps them: valid as long as the ``Book`` is not freed, read between two of its calls.
    public var bytes: UnsafeRawBufferPointer { memory(address, byteLen) }
}

extension IndexView {
    /// The indices where the core keeps them: 16 bits each, the same in every frame.
    public var bytes: UnsafeRawBufferPointer { memory(address, byteLen) }
}

private func memory(_ address: UInt64, _ length: UInt64) -> UnsafeRawBufferPointer {
    UnsafeRawBufferPointer(start: UnsafeRawPointer(bitPattern: UInt(address)), count: Int(length))
}
