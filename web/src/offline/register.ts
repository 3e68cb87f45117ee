import { texts } from "../texts";
import { make } from "../ui/dom";
import { notice } from "../ui/notices";
import type { FromOffline, ToOffline } from "./worker";

const words = texts.offline;

let isBegun = false;

/** Reports a newer build, if the app is cached on the device. */
export function watchOffline(): void {
  if (navigator.serviceWorker?.controller) void keepOffline();
}

/**
 * Caches the app on the device, if it is served over a secure connection, and not during development. The start page
 * alone does not load the engine.
 */
export async function keepOffline(): Promise<void> {
  if (isBegun) return;
  isBegun = true;
  const { serviceWorker } = navigator;
  if (!import.meta.env.PROD || !serviceWorker) return;
  const script = new URL("offline.js", document.baseURI);
  // The app also works without a service worker.
  const registration = await serviceWorker.register(script, { updateViaCache: "none" }).catch(() => undefined);
  if (!registration) return;
  watch(registration);
  const { active } = await serviceWorker.ready;
  // The name of the page's script identifies the page's build.
  if (!serviceWorker.controller) active?.postMessage({ claim: import.meta.url } satisfies ToOffline);
}

function watch(registration: ServiceWorkerRegistration): void {
  const { serviceWorker } = navigator;
  const look = () => {
    const { active, waiting } = registration;
    if (active && waiting) tell(waiting);
  };
  look();
  registration.addEventListener("updatefound", () => registration.installing?.addEventListener("statechange", look));
  // A page may stay open for days: look for a newer build when it becomes visible.
  document.addEventListener("visibilitychange", () => {
    if (!document.hidden && serviceWorker.controller) registration.update().catch(() => undefined);
  });
}

/** Reports a newer build that is cached and waits to be used. */
function tell(waiting: ServiceWorker): void {
  const button = make("button", { type: "button", class: "button", "data-testid": "update" }, words.reload);
  const said = make("p", {});
  notice("update", words.update, [words.update_help], [button, said]);
  waiting.addEventListener("statechange", () => waiting.state === "activated" && location.reload());
  button.addEventListener("click", () => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = ({ data }: MessageEvent<FromOffline>) => (said.textContent = words.others(data.others));
    waiting.postMessage({ takeOver: true } satisfies ToOffline, [port2]);
  });
}
