// Fingers as the core tells them apart.

/// Gives each touch a small number while it lasts: the first finger is 0, a second one 1.
struct Fingers {
    private var numbers: [ObjectIdentifier: UInt8] = [:]

    /// The number of a touch; a new touch takes the smallest free one.
    mutating func number(of touch: ObjectIdentifier) -> UInt8 {
        if let known = numbers[touch] { return known }
        let taken = Set(numbers.values)
        let free = (0..<64).first { !taken.contains($0) } ?? 63
        numbers[touch] = free
        return free
    }

    /// The touch is over.
    mutating func forget(_ touch: ObjectIdentifier) {
        numbers[touch] = nil
    }

    /// Microseconds of a time in seconds, in the same clock.
    static func microseconds(_ seconds: Double) -> UInt64 {
        UInt64(max(0, seconds * 1_000_000))
    }
}
