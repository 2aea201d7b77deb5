// A zip file without compression, which pictures do not need (PKWARE appnote 6.3.10, sections 4.3.7, 4.3.12 and 4.3.16).

const table = Uint32Array.from({ length: 256 }, (_, byte) => {
  let sum = byte;
  for (let bit = 0; bit < 8; ++bit) sum = sum & 1 ? 0xedb88320 ^ (sum >>> 1) : sum >>> 1;
  return sum;
});

export function crc32(bytes: Uint8Array): number {
  let sum = 0xffffffff;
  for (const byte of bytes) sum = table[(sum ^ byte) & 255] ^ (sum >>> 8);
  return (sum ^ 0xffffffff) >>> 0;
}

/** Little-endian numbers of 2 or 4 bytes. */
function header(...fields: [bytes: 2 | 4, value: number][]): Uint8Array<ArrayBuffer> {
  const out = new Uint8Array(fields.reduce((sum, [bytes]) => sum + bytes, 0));
  let at = 0;
  for (const [bytes, value] of fields) for (let k = 0; k < bytes; ++k) out[at++] = (value >>> (8 * k)) & 255;
  return out;
}

const midnight1980 = 33; // 1 January 1980, the first date of the format: the same frames give the same file

export interface ZipEntry {
  name: string; // ASCII
  bytes: Uint8Array<ArrayBuffer>;
}

export function zip(entries: ZipEntry[]): Blob {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  const directory: Uint8Array<ArrayBuffer>[] = [];
  const sizeOf = (list: Uint8Array[]) => list.reduce((sum, part) => sum + part.length, 0);
  let offset = 0;
  for (const { name, bytes } of entries) {
    const label = new TextEncoder().encode(name);
    const common: [2 | 4, number][] = [[2, 20], [2, 0], [2, 0], [2, 0], [2, midnight1980], [4, crc32(bytes)], [4, bytes.length], [4, bytes.length], [2, label.length], [2, 0]];
    const local = header([4, 0x04034b50], ...common);
    directory.push(header([4, 0x02014b50], [2, 20], ...common, [2, 0], [2, 0], [2, 0], [4, 0], [4, offset]), label);
    parts.push(local, label, bytes);
    offset += local.length + label.length + bytes.length;
  }
  const end = header([4, 0x06054b50], [2, 0], [2, 0], [2, entries.length], [2, entries.length], [4, sizeOf(directory)], [4, offset], [2, 0]);
  return new Blob([...parts, ...directory, end], { type: "application/zip" });
}
