/** Returns a short digest of texts and numbers: FNV-1a over their bytes, 32 bits, in hexadecimal. */
export function digestOf(...parts: readonly (string | ArrayBufferView)[]): string {
  let hash = 0x811c9dc5;
  for (const part of parts) {
    for (const byte of bytesOf(part)) hash = Math.imul(hash ^ byte, 0x01000193);
  }
  return (hash >>> 0).toString(16).padStart(8, "0");
}

function bytesOf(part: string | ArrayBufferView): Uint8Array {
  if (typeof part === "string") return new TextEncoder().encode(part);
  return new Uint8Array(part.buffer, part.byteOffset, part.byteLength);
}
