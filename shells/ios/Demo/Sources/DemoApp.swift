// A reader: one PDF, its page kept between runs.

import SwiftUI

@main
struct DemoApp: App {
    var body: some Scene {
        WindowGroup { ReaderScreen() }
    }
}
