/**
 * A service worker that replaces the one that keeps the app: it takes away what that one kept, and itself. `kingpost serve`
 * answers with it, for what it serves can be another with every start, and is on this machine anyway.
 */

interface LeavingScope {
  registration: { scope: string; unregister(): Promise<boolean> };
  clients: { matchAll(options: { type: "window" }): Promise<{ url: string; navigate(url: string): Promise<unknown> }[]> };
  skipWaiting(): Promise<void>;
  addEventListener(type: "install" | "activate", listener: (event: Event & { waitUntil(work: Promise<unknown>): void }) => void): void;
}

const scope = self as unknown as LeavingScope;

scope.addEventListener("install", (event) => event.waitUntil(scope.skipWaiting()));
scope.addEventListener("activate", (event) => event.waitUntil(leave()));

async function leave(): Promise<void> {
  await caches.delete(`kingpost ${scope.registration.scope}`);
  await scope.registration.unregister();
  // Pages that were answered by the other one load anew.
  const windows = await scope.clients.matchAll({ type: "window" });
  await Promise.all(windows.map((window) => window.navigate(window.url)));
}
