// A small server for a folder: `node serve.mjs FOLDER [PORT]`. Nothing a page could not have from any other.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize, sep } from "node:path";
import { pathToFileURL } from "node:url";

const KINDS = {
    ".html": "text/html; charset=utf-8", ".css": "text/css", ".js": "text/javascript", ".mjs": "text/javascript",
    ".json": "application/json", ".wasm": "application/wasm", ".pdf": "application/pdf", ".png": "image/png",
    ".svg": "image/svg+xml", ".webmanifest": "application/manifest+json",
};
/** A page alone in its process has a finer clock: what a step costs is read with it. */
const ALONE = { "Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp" };

/** Serves a folder on this machine alone; answers its address and how to end it. */
export function serve(folder, port = 0) {
    const server = createServer(async (request, response) => {
        const path = decodeURIComponent(new URL(request.url ?? "/", "http://localhost").pathname);
        const file = normalize(join(folder, path.endsWith("/") ? `${path}index.html` : path));
        try {
            if (!file.startsWith(normalize(folder + sep))) throw new Error("outside");
            const body = await readFile(file);
            response.writeHead(200, { "Content-Type": KINDS[extname(file)] ?? "application/octet-stream", ...ALONE });
            response.end(body);
        } catch {
            response.writeHead(404, { "Content-Type": "text/plain" });
            response.end("there is no such file");
        }
    });
    return new Promise((resolve) => {
        server.listen(port, "127.0.0.1", () => {
            const stop = () => new Promise((done) => {
                server.close(done);
                server.closeAllConnections();
            });
            resolve({ url: `http://localhost:${server.address().port}`, stop });
        });
    });
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
    const [folder, port] = process.argv.slice(2);
    const { url } = await serve(folder, Number(port ?? 8080));
    console.log(`the page is at ${url}/`);
}
