// Files inside a zip, read where they lie: only what a page needs is ever in memory.

const END = 0x06054b50;
const ENTRY = 0x02014b50;
const LOCAL = 0x04034b50;
/** A comment at the end is at most this long, and what stands before it. */
const TAIL = 65_535 + 22;
/** Bytes of a directory and of one file at most. */
const MOST_DIRECTORY = 16 << 20;
const MOST_FILE = 128 << 20;

/**
 * @param {Blob} blob
 * @param {number} from
 * @param {number} to
 */
async function bytes(blob, from, to) {
    return new DataView(await blob.slice(from, to).arrayBuffer());
}

/**
 * The files of an archive.
 * @param {Blob} blob
 * @returns {Promise<{ name: string, blob: () => Promise<Blob> }[]>}
 */
export async function files(blob) {
    const tail = await bytes(blob, Math.max(0, blob.size - TAIL), blob.size);
    let end = tail.byteLength - 22;
    while (end >= 0 && tail.getUint32(end, true) !== END) end -= 1;
    if (end < 0) throw new Error("is no sound archive");
    const [size, at] = [tail.getUint32(end + 12, true), tail.getUint32(end + 16, true)];
    if (size > MOST_DIRECTORY || at + size > blob.size) throw new Error("is no sound archive");
    const list = await bytes(blob, at, at + size);
    const found = [];
    for (let n = 0; n + 46 <= list.byteLength && list.getUint32(n, true) === ENTRY;) {
        const named = list.getUint16(n + 28, true);
        const beside = list.getUint16(n + 30, true) + list.getUint16(n + 32, true);
        const text = new Uint8Array(list.buffer, n + 46, Math.min(named, list.byteLength - n - 46));
        const entry = {
            flags: list.getUint16(n + 8, true),
            method: list.getUint16(n + 10, true),
            packed: list.getUint32(n + 20, true),
            size: list.getUint32(n + 24, true),
            at: list.getUint32(n + 42, true),
        };
        found.push({ name: new TextDecoder().decode(text), blob: () => unpack(blob, entry) });
        n += 46 + named + beside;
    }
    return found;
}

/**
 * @param {Blob} blob
 * @param {{ flags: number, method: number, packed: number, size: number, at: number }} entry
 */
async function unpack(blob, { flags, method, packed, size, at }) {
    if (flags & 1) throw new Error("is locked with a password");
    if (size > MOST_FILE || packed > MOST_FILE) throw new Error("holds a file that is too large");
    const head = await bytes(blob, at, at + 30);
    if (head.byteLength < 30 || head.getUint32(0, true) !== LOCAL) throw new Error("is no sound archive");
    const start = at + 30 + head.getUint16(26, true) + head.getUint16(28, true);
    const data = blob.slice(start, start + packed);
    if (method === 0) return data;
    if (method !== 8) throw new Error("is packed in a way that is not known here");
    return inflated(data.stream().pipeThrough(new DecompressionStream("deflate-raw")));
}

/**
 * What is said of its size need not be so: stops where it grows too large.
 * @param {ReadableStream<Uint8Array>} stream
 */
async function inflated(stream) {
    const parts = [];
    let size = 0;
    const reader = stream.getReader();
    for (let { done, value } = await reader.read(); !done && value; { done, value } = await reader.read()) {
        size += value.byteLength;
        if (size > MOST_FILE) throw new Error("holds a file that is too large");
        parts.push(value);
    }
    return new Blob(parts);
}
