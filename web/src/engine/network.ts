import { texts } from "../texts";
import { faultOfNetwork } from "./faults";

/** Timeout for loading a file, ms. */
const LONGEST_MS = 60_000;
/** Status codes by which a server reports a missing file. */
const NOT_THERE = [404, 410];

/** Fetches the text at an address; null if the file does not exist. Throws a fault if this is unknown. */
export async function fetchText(url: string): Promise<string | null> {
  const response = await fetched(url);
  if (NOT_THERE.includes(response.status)) return null;
  if (!response.ok) throw faultOfNetwork(url, said(response));
  return response.text();
}

export async function fetched(url: string): Promise<Response> {
  try {
    return await fetch(url, { signal: AbortSignal.timeout(LONGEST_MS) });
  } catch (thrown) {
    throw faultOfNetwork(url, thrown instanceof Error && thrown.name === "TimeoutError" ? texts.engine.too_long : texts.engine.no_connection);
  }
}

export function said({ status, statusText }: Response): string {
  return texts.engine.answered(`${status} ${statusText}`.trimEnd());
}
