import { make } from "./dom";

/** Hands a file over to the browser. */
export function download(name: string, content: Blob): void {
  const href = URL.createObjectURL(content);
  make("a", { href, download: name }).click();
  // After the click the browser has begun to read it.
  setTimeout(() => URL.revokeObjectURL(href), 60_000);
}
