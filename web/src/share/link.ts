import { digestOf } from "../engine/digest";
import type { Fault } from "../engine/engine";
import { texts } from "../texts";
import { packed, unpacked } from "./packing";
import { sharedRunOf } from "./shared_run";
import type { SharedRun } from "./shared_run";

/** Version in the prefix of a link: `#k1=`, then the result of `packed`, a point, and a digest of the content. */
const VERSION = 1;
const KEY = /^k(\d+)$/;
/**
 * Largest length of the text after the `#`, characters: browsers accept more, but messengers and mail programs
 * truncate.
 */
export const LONGEST = 64_000;
/** Largest content of a link, bytes: a hundred scenarios. Without this limit a short link could unpack to gigabytes. */
const LARGEST = 2_000_000;

/** Returns the part of an address, from the `#` on, that opens a run. */
export async function hashOf(run: SharedRun): Promise<string> {
  const json = JSON.stringify(run);
  const bytes = new TextEncoder().encode(json);
  const hash = `#k${VERSION}=${await packed(bytes)}.${digestOf(bytes)}`;
  if (hash.length > LONGEST || bytes.length > LARGEST) throw faultOfLink(texts.share.too_large(hash.length, LONGEST));
  return hash;
}

/** Reads the run in an address; throws a fault of the kind `link` with the reason if there is none. */
export async function runIn(hash: string): Promise<SharedRun> {
  const { version, text } = entryOf(hash) ?? { version: VERSION, text: "" };
  if (version > VERSION) throw faultOfLink(texts.share.newer);
  if (text.length > LONGEST) throw faultOfLink(texts.share.too_long(text.length, LONGEST));
  const [content, digest] = text.split(".");
  if (!content || digest?.length !== digestOf().length) throw faultOfLink(texts.share.cut);
  const bytes = await unpacked(content, LARGEST).catch((why: unknown) => {
    throw faultOfLink(why instanceof RangeError ? texts.share.too_much(LARGEST) : texts.share.broken);
  });
  const run = digestOf(bytes) === digest ? sharedRunOf(parsed(bytes)) : null;
  if (!run) throw faultOfLink(texts.share.broken);
  return run;
}

function entryOf(hash: string): { version: number; text: string } | null {
  for (const [key, text] of new URLSearchParams(hash.slice(1))) {
    const found = KEY.exec(key);
    if (found) return { version: Number(found[1]), text };
  }
  return null;
}

function parsed(bytes: Uint8Array): unknown {
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    return null;
  }
}

function faultOfLink(message: string): Fault {
  return { kind: "link", message };
}
