// Every test of the web shell: `node all.mjs FOLDER NATIVE DOGLEAF [FILE,..]`, as `cargo ci web` calls it.
import { resolve } from "node:path";
import { Bench } from "./harness.mjs";

const [out, native, program] = process.argv.slice(2, 5).map((path) => resolve(path));
const only = process.argv[5];
const bench = await Bench.open(out, native, program);
const FILES = ["sizes", "hashes", "mesh", "picture", "turn", "rest", "files", "access", "offline", "memory", "cost", "times"];
for (const name of FILES.filter((name) => !only || only.split(",").includes(name))) {
    const { default: run } = await import(`./${name}.mjs`);
    await run(bench);
}
process.exitCode = (await bench.close()) ? 0 : 1;
