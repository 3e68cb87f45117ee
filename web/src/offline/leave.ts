/**
 * Service worker that replaces the worker that caches the app, and removes the cached files and itself. `kingpost
 * serve` sends it, because a local server can serve another build at each start.
 */

interface LeavingScope {
  registration: { scope: string; unregister(): Promise<boolean> };
  clients: { matchAll(options: { type: "window" }): Promise<{ url: string; navigate(url: string): Promise<unknown> }[]> };
  skipWaiting(): Promise<void>;
  addEventListener(type: "install" | "activate", listener: (event: Event & { waitUntil(work: Promise<unknown>): void }) => void): void;
}

declare const self: LeavingScope;

self.addEventListener("install", (event) => event.waitUntil(self.skipWaiting()));
self.addEventListener("activate", (event) => event.waitUntil(leave()));

async function leave(): Promise<void> {
  await caches.delete(`kingpost ${self.registration.scope}`);
  await self.registration.unregister();
  // Reload the pages that the other worker has served.
  const windows = await self.clients.matchAll({ type: "window" });
  await Promise.all(windows.map((window) => window.navigate(window.url)));
}

export {};
