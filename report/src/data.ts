// Data that `perimpact report` embeds in the page: one element `description`, and encoded numbers in separate elements (docs/guide/report.md).

export interface PackedArray {
  name: string;
  unit: string;
  bytes: 1 | 2 | 4;
  low: number;
  high: number;
  step: number;
}

export interface Body {
  name: string;
  id: string;
  particles: number;
  shown: number;
  "spacing [m]": number;
  undeformed: PackedArray[];
  arrays: PackedArray[];
  pictures: number[]; // indices into times
  offsets: number[][]; // [m] per picture, of the reference positions; other than zero after a window has moved
}

export interface Impactor {
  name: string;
  id: string;
  vertices: number;
  panels: number;
  arrays: PackedArray[];
  deformation: PackedArray[]; // displacements of the vertices along x, y and z before the motion; empty for a rigid surface
  pictures: number[];
  motions: number[][]; // 3 × 4 matrices
}

export interface Column {
  name: string;
  unit: string;
}

export interface Description {
  format: number;
  folder: string;
  notes: string[];
  "times [s]": number[];
  bodies: Body[];
  impactors: Impactor[];
  history?: { rows: number; columns: Column[] };
}

export type Numbers = Uint8Array | Uint16Array | Uint32Array;

/** The JSON in the element of that name; undefined where it is missing or damaged. */
export function json<T>(id: string): T | undefined {
  const text = document.getElementById(id)?.textContent;
  if (!text) return undefined;
  try {
    return JSON.parse(text) as T;
  } catch {
    return undefined;
  }
}

/** The bytes in an element. The element is removed, since its text needs more memory. */
export async function unpacked(id: string): Promise<Uint8Array> {
  const element = document.getElementById(id);
  if (!element) throw new Error(`The file is truncated: ${id} is missing. Create it again with perimpact report.`);
  const text = atob(element.textContent ?? "");
  element.remove();
  const packed = new Uint8Array(text.length);
  for (let k = 0; k < packed.length; ++k) packed[k] = text.charCodeAt(k);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** One array, frame by frame: each frame stores the residuals of a prediction from the previous ones. */
export class ArrayReader {
  private before: Numbers | undefined;
  private beforeThat: Numbers | undefined;

  constructor(private readonly bytes: 1 | 2 | 4) {}

  /** The numbers of the next frame, from `offset`, and the offset after them. */
  next(from: Uint8Array, offset: number, count: number): { numbers: Numbers; end: number } {
    const { bytes } = this;
    const numbers = bytes === 1 ? new Uint8Array(count) : bytes === 2 ? new Uint16Array(count) : new Uint32Array(count);
    const prediction = from[offset];
    const inTime = prediction % 3;
    const along = prediction >= 3;
    const first = offset + 1;
    const { before, beforeThat } = this;
    let last = 0;
    for (let i = 0; i < count; ++i) {
      let folded = from[first + i];
      if (bytes > 1) folded |= from[first + count + i] << 8;
      if (bytes > 2) folded |= (from[first + 2 * count + i] << 16) | (from[first + 3 * count + i] << 24);
      let off = (folded >>> 1) ^ -(folded & 1);
      if (along) off = (off + last) | 0;
      last = off;
      const predicted = inTime === 0 ? 0 : inTime === 1 ? before![i] : 2 * before![i] - beforeThat![i];
      numbers[i] = predicted + off; // modulo 2^(8 bytes), by the type of the array
    }
    this.beforeThat = before;
    this.before = numbers;
    return { numbers, end: first + bytes * count };
  }
}

/** 32-bit words reinterpreted as floats. */
export function floats(numbers: Numbers): Float32Array {
  return new Float32Array((numbers as Uint32Array).buffer);
}
