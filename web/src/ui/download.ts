import { make } from "./dom";

/** Hands a file over to the browser. */
export function download(name: string, content: Blob): void {
  const href = URL.createObjectURL(content);
  make("a", { href, download: name }).click();
  // The browser has begun to read it once the click is through.
  setTimeout(() => URL.revokeObjectURL(href), 60_000);
}
