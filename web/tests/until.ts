import { vi } from "vitest";

/** Waits until an assertion holds, also on a slow machine. */
export const until = (found: () => void) => vi.waitFor(found, { timeout: 60_000, interval: 1 });

/** Gives all pending tasks many turns of the event loop. */
export async function turns(): Promise<void> {
  for (let turn = 0; turn < 50; turn++) await new Promise((resolve) => setTimeout(resolve));
}
