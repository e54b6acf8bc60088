// Promise: what a page loads is no larger than stated.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, gzipSync } from "node:zlib";
import { holds } from "./harness.mjs";

/** Bytes at most, packed by gzip: the core, and all modules of the package. */
const BOUNDS = { "simd.wasm": 140_000, "scalar.wasm": 135_000, "modules": 40_000 };

export default async function run(bench) {
    await bench.test("sizes keep their bounds", () => {
        const folder = join(bench.out, "dogleaf");
        const modules = readdirSync(folder).filter((name) => name.endsWith(".js")).map((name) => join(folder, name));
        const parts = {
            "simd.wasm": [join(folder, "wasm/simd.wasm")],
            "scalar.wasm": [join(folder, "wasm/scalar.wasm")],
            "modules": [...modules, join(folder, "wasm/dogleaf.js")],
        };
        console.log("| what a page loads | bytes | gzip | brotli | bound, gzip |\n|---|---|---|---|---|");
        const wrong = [];
        for (const [name, files] of Object.entries(parts)) {
            const all = Buffer.concat(files.map((file) => readFileSync(file)));
            const packed = gzipSync(all, { level: 9 }).length;
            const sizes = [all.length, packed, brotliCompressSync(all).length, BOUNDS[name]];
            console.log(`| ${name} | ${sizes.map((n) => n.toLocaleString("en")).join(" | ")} |`);
            if (packed > BOUNDS[name]) wrong.push(`${name}: ${packed} bytes packed`);
        }
        holds(wrong.length === 0, wrong.join(", "));
    });
}
