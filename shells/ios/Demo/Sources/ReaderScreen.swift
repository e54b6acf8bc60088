// The one screen of the demo.

import Dogleaf
import SwiftUI
import UniformTypeIdentifiers

/// A book, the page it is open at, and buttons for those who do not drag.
struct ReaderScreen: View {
    @State private var url = Bundle.main.url(forResource: "old-verses", withExtension: "pdf")
    @State private var page = 0
    @State private var isChoosing = false
    @StateObject private var remote = Remote()

    var body: some View {
        VStack(spacing: 0) {
            if let url {
                BookScreen(url: url, remote: remote) { page = $0 }.id(url).ignoresSafeArea()
            } else {
                Text("No book").frame(maxWidth: .infinity, maxHeight: .infinity)
            }
            HStack {
                Button("Previous") { remote.turn(false) }
                Spacer()
                Text("Page \(page)").monospacedDigit()
                Spacer()
                Button("Open…") { isChoosing = true }
                Button("Next") { remote.turn(true) }
            }
            .padding()
        }
        .fileImporter(isPresented: $isChoosing, allowedContentTypes: [.pdf]) { result in
            if let chosen = try? result.get(), chosen.startAccessingSecurityScopedResource() { url = chosen }
        }
    }
}

/// What buttons ask of the view.
final class Remote: ObservableObject {
    weak var view: BookView?

    func turn(_ forward: Bool) {
        view?.turn(forward: forward)
    }
}
