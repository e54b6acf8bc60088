// Keeps the whole page, so that it opens without a network. `cargo ci web` fills in the version and the files.
const VERSION = "@VERSION@";
const FILES = ["@FILES@"];
const CACHE = `dogleaf-${VERSION}`;

self.addEventListener("install", (event) => {
    event.waitUntil((async () => {
        const cache = await caches.open(CACHE);
        await cache.addAll(["./", ...FILES]);
        await self.skipWaiting();
    })());
});

self.addEventListener("activate", (event) => {
    event.waitUntil((async () => {
        for (const name of await caches.keys()) if (name.startsWith("dogleaf-") && name !== CACHE) await caches.delete(name);
        await self.clients.claim();
    })());
});

self.addEventListener("fetch", (event) => {
    if (event.request.method !== "GET" || !event.request.url.startsWith(self.location.origin)) return;
    event.respondWith((async () => {
        const kept = await caches.match(event.request, { ignoreSearch: true, cacheName: CACHE });
        return kept ?? fetch(event.request);
    })());
});
