import { make } from "./dom";

/** Saves a file through the browser. */
export function download(name: string, content: Blob): void {
  const href = URL.createObjectURL(content);
  make("a", { href, download: name }).click();
  // By then the browser has begun to read the file.
  setTimeout(() => URL.revokeObjectURL(href), 60_000);
}
