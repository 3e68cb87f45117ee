/** Bytes as a short text for an address: deflated, in base64url without padding. */
export async function packed(bytes: Uint8Array): Promise<string> {
  const parts: string[] = [];
  await each(through(bytes, new CompressionStream("deflate-raw")), (part) => parts.push(String.fromCharCode(...part)));
  return btoa(parts.join("")).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** Unpacks the bytes. Throws a RangeError if there are more than `most`, and another error if they are damaged. */
export async function unpacked(text: string, most: number): Promise<Uint8Array> {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
  const parts: Uint8Array[] = [];
  let length = 0;
  await each(through(bytes, new DecompressionStream("deflate-raw")), (part) => {
    length += part.length;
    if (length > most) throw new RangeError(`more than ${most} bytes`);
    parts.push(part);
  });
  return new Uint8Array(await new Blob(parts as BlobPart[]).arrayBuffer());
}

function through(bytes: Uint8Array, stream: GenericTransformStream): ReadableStream<Uint8Array> {
  return new Blob([bytes as BlobPart]).stream().pipeThrough(stream as ReadableWritablePair<Uint8Array, Uint8Array<ArrayBuffer>>);
}

/** Part by part, so that the reader can stop early. */
async function each(stream: ReadableStream<Uint8Array>, take: (part: Uint8Array) => void): Promise<void> {
  const reader = stream.getReader();
  try {
    for (let next = await reader.read(); !next.done; next = await reader.read()) take(next.value);
  } catch (why) {
    await reader.cancel().catch(() => undefined);
    throw why;
  }
}
