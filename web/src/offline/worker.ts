/**
 * Service worker of the app: it caches all files of one build and serves only these, so that files of two builds do not
 * mix.
 */

interface LastingEvent extends Event {
  waitUntil(work: Promise<unknown>): void;
}

interface FetchedEvent extends LastingEvent {
  request: Request;
  respondWith(answer: Promise<Response>): void;
}

/** The part of a service worker's global scope that this worker uses. */
interface WorkerScope {
  /** Paths of the files of this build, with a digest of each; the build writes them in front of this script. */
  kingpost_files: Record<string, string>;
  registration: { scope: string };
  clients: {
    claim(): Promise<void>;
    matchAll(options: { type: "window"; includeUncontrolled: true }): Promise<{ url: string }[]>;
  };
  skipWaiting(): Promise<void>;
  addEventListener(type: "install" | "activate", listener: (event: LastingEvent) => void): void;
  addEventListener(type: "fetch", listener: (event: FetchedEvent) => void): void;
  addEventListener(type: "message", listener: (event: LastingEvent & MessageEvent<ToOffline>) => void): void;
}

/** `claim`: the page asks this worker to serve it from now on. `takeOver`: the page asks for the newer build. */
export type ToOffline = { claim: string } | { takeOver: true };
/** Number of other windows with the older build: after an update they would mix files of the two builds. */
export type FromOffline = { others: number };

declare const self: WorkerScope;
const files = self.kingpost_files;
const folder = self.registration.scope;
const opened = () => caches.open(`kingpost ${folder}`);

self.addEventListener("install", (event) => event.waitUntil(keepAll()));
self.addEventListener("activate", (event) => event.waitUntil(dropOthers()));
self.addEventListener("fetch", (event) => {
  const path = pathOf(event.request.url);
  if (event.request.method === "GET" && path !== null) event.respondWith(kept(path, event.request));
});
self.addEventListener("message", (event) => {
  const { data, ports } = event;
  event.waitUntil("claim" in data ? claim(data.claim) : takeOver(ports[0]));
});

/**
 * Caches all files of this build; files that an older build has cached are not fetched again. If one file fails, the
 * build is not installed.
 */
async function keepAll(): Promise<void> {
  const cache = await opened();
  const keep = async (path: string) => {
    if (!(await cache.match(keyOf(path)))) await cache.put(keyOf(path), await fetched(path));
  };
  await Promise.all(Object.keys(files).map(keep));
}

/**
 * Fetches a file of this build; throws if the file on the host has another digest, because it then belongs to another
 * build.
 */
async function fetched(path: string): Promise<Response> {
  const response = await fetch(new URL(path, folder), { cache: "no-cache" });
  const content = await response.arrayBuffer();
  if (!response.ok || (await digestOf(content)) !== files[path]) throw new Error(`${path} is not that of this build`);
  const headers = new Headers(response.headers);
  // These headers describe the compressed bytes.
  for (const name of ["content-encoding", "content-length"]) headers.delete(name);
  return new Response(content, { headers });
}

async function digestOf(content: ArrayBuffer): Promise<string> {
  const bytes = new Uint8Array(await crypto.subtle.digest("SHA-256", content));
  return Array.from(bytes.subarray(0, 8), (byte) => byte.toString(16).padStart(2, "0")).join("");
}

async function dropOthers(): Promise<void> {
  const cache = await opened();
  const ours = new Set(Object.keys(files).map(keyOf));
  const others = (await cache.keys()).filter(({ url }) => !ours.has(url));
  await Promise.all(others.map((request) => cache.delete(request)));
}

/** Returns a cached file, or fetches it: a browser with little storage may have dropped it. */
async function kept(path: string, request: Request): Promise<Response> {
  return (await (await opened()).match(keyOf(path))) ?? fetch(request);
}

/** Takes control of the open pages, if the page that asks for it is of this build. */
async function claim(script: string): Promise<void> {
  if (pathOf(script) !== null) await self.clients.claim();
}

async function takeOver(port: MessagePort): Promise<void> {
  const windows = await self.clients.matchAll({ type: "window", includeUncontrolled: true });
  const others = windows.filter(({ url }) => url.startsWith(folder)).length - 1;
  if (others > 0) port.postMessage({ others } satisfies FromOffline);
  else await self.skipWaiting();
}

/** Returns the path of a file of this build, without the query; null for another address. */
function pathOf(url: string): string | null {
  const { origin, pathname } = new URL(url);
  const place = origin + pathname;
  if (!place.startsWith(folder)) return null;
  const path = decodeURIComponent(place.slice(folder.length)).replace(/^index\.html$/, "");
  return Object.hasOwn(files, path) ? path : null;
}

function keyOf(path: string): string {
  return new URL(`${path}?digest=${files[path]}`, folder).href;
}
