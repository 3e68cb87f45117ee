import { vi } from "vitest";

/** Waits until what is looked for has come, on a slow machine too. */
export const until = (found: () => void) => vi.waitFor(found, { timeout: 60_000, interval: 1 });

/** Lets everything that waits for a turn of the event loop have many of them. */
export async function turns(): Promise<void> {
  for (let turn = 0; turn < 50; turn++) await new Promise((resolve) => setTimeout(resolve));
}
