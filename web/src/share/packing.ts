type Bytes = Uint8Array<ArrayBuffer>;

/** Packs bytes as a short text for an address: compressed by deflate, in base64url without padding. */
export async function packed(bytes: Bytes): Promise<string> {
  const parts: string[] = [];
  await each(through(bytes, new CompressionStream("deflate-raw")), (part) => parts.push(String.fromCharCode(...part)));
  return btoa(parts.join("")).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** Unpacks the bytes. Throws a RangeError if there are more than `most`, and another error if they are damaged. */
export async function unpacked(text: string, most: number): Promise<Bytes> {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
  const parts: Bytes[] = [];
  let length = 0;
  await each(through(bytes, new DecompressionStream("deflate-raw")), (part) => {
    length += part.length;
    if (length > most) throw new RangeError(`more than ${most} bytes`);
    parts.push(part);
  });
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

function through(bytes: Bytes, stream: CompressionStream | DecompressionStream): ReadableStream<Bytes> {
  return new Blob([bytes]).stream().pipeThrough(stream);
}

/** Reads a stream part by part, so that reading can stop early. */
async function each(stream: ReadableStream<Bytes>, take: (part: Bytes) => void): Promise<void> {
  const reader = stream.getReader();
  try {
    for (let next = await reader.read(); !next.done; next = await reader.read()) take(next.value);
  } catch (why) {
    await reader.cancel().catch(() => undefined);
    throw why;
  }
}
