import { texts } from "../texts";
import { make } from "../ui/dom";
import { notice } from "../ui/notices";
import type { FromOffline, ToOffline } from "./worker";

const words = texts.offline;

let isBegun = false;

/** Where the app is kept on the device already, it says when a newer build is there. */
export function watchOffline(): void {
  if (navigator.serviceWorker?.controller) void keepOffline();
}

/** Keeps the app on the device, where it is served safely. Who only looks at the start page is spared the engine. Not while developing. */
export async function keepOffline(): Promise<void> {
  if (isBegun) return;
  isBegun = true;
  const { serviceWorker } = navigator;
  if (!import.meta.env.PROD || !serviceWorker) return;
  const script = new URL("offline.js", document.baseURI);
  // Without it the app runs all the same.
  const registration = await serviceWorker.register(script, { updateViaCache: "none" }).catch(() => undefined);
  if (!registration) return;
  watch(registration);
  const { active } = await serviceWorker.ready;
  // What the page was loaded with stands in the name of its script.
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
  // A page may stay open for days.
  document.addEventListener("visibilitychange", () => {
    if (!document.hidden && serviceWorker.controller) registration.update().catch(() => undefined);
  });
}

/** A newer build is kept, and waits. */
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
