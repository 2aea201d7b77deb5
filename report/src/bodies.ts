// Decoded bodies and impactors, frame by frame.
import { ArrayReader, Body, Impactor, Numbers, PackedArray, floats, unpacked } from "./data";
import { Kind } from "./colours";

/** Minimum and maximum. */
export interface Range {
  low: number;
  high: number;
}

function include(range: Range | undefined, low: number, high: number): Range {
  return range ? { low: Math.min(range.low, low), high: Math.max(range.high, high) } : { low, high };
}

/** The frame of a series shown at a time: the last decoded one up to it. */
function shownAt(pictures: number[], ready: number, time: number): number {
  let found = -1;
  for (let k = 0; k < ready && pictures[k] <= time; ++k) found = k;
  return Math.max(found, 0);
}

/** A quantity for colouring particles or panels. */
export interface Quantity {
  key: string;
  label: string;
  unit: string;
  kind: Kind; // "number": labels such as fragments and bodies
}

export class BodyData {
  undeformed = new Float32Array(0);
  readonly pictures: Numbers[][] = [];
  private readonly readers: ArrayReader[];
  private readonly ranges = new Map<string, Range>();

  constructor(readonly about: Body) {
    this.readers = about.arrays.map((array) => new ArrayReader(array.bytes));
  }

  async readUndeformed(): Promise<void> {
    const bytes = await unpacked(this.about.id);
    const count = this.about.shown;
    this.undeformed = new Float32Array(3 * count);
    let at = 0;
    for (let axis = 0; axis < 3; ++axis) {
      const { bytes: width, low, step } = this.about.undeformed[axis];
      const { numbers, end } = new ArrayReader(width).next(bytes, at, count);
      for (let i = 0; i < count; ++i) this.undeformed[3 * i + axis] = low + step * numbers[i];
      at = end;
    }
  }

  async readPicture(): Promise<void> {
    const bytes = await unpacked(`${this.about.id}_${this.about.pictures[this.pictures.length]}`);
    let at = 0;
    const arrays: Numbers[] = [];
    for (const reader of this.readers) {
      const { numbers, end } = reader.next(bytes, at, this.about.shown);
      arrays.push(numbers);
      at = end;
    }
    this.pictures.push(arrays);
  }

  shownAt(time: number): number {
    return shownAt(this.about.pictures, this.pictures.length, time);
  }

  array(name: string): { about: PackedArray; number: number } | undefined {
    const number = this.about.arrays.findIndex((array) => array.name === name);
    return number < 0 ? undefined : { about: this.about.arrays[number], number };
  }

  /** 1 for particles that are in a frame, 0 for others; undefined where all particles are in all frames. */
  isWritten(picture: number): Numbers | undefined {
    const found = this.array("is_written");
    return found && this.pictures[picture][found.number];
  }

  /** The values of a quantity in a frame; NaN for particles that are not in it. */
  values(key: string, picture: number, body: number): Float32Array {
    const out = this.allValues(key, picture, body);
    this.isWritten(picture)?.forEach((is, i) => {
      if (!is) out[i] = NaN;
    });
    return out;
  }

  private allValues(key: string, picture: number, body: number): Float32Array {
    const count = this.about.shown;
    const out = new Float32Array(count);
    const arrays = this.pictures[picture];
    if (key === "body") return out.fill(body);
    if (key === "displacement") {
      const [x, y, z] = this.about.arrays;
      for (let i = 0; i < count; ++i) out[i] = Math.hypot(x.low + x.step * arrays[0][i], y.low + y.step * arrays[1][i], z.low + z.step * arrays[2][i]);
      return out;
    }
    const found = this.array(key);
    if (!found) return out;
    const { low, step } = found.about;
    const numbers = arrays[found.number];
    for (let i = 0; i < count; ++i) out[i] = low + step * numbers[i];
    return out;
  }

  /** Over all decoded frames. That of damage is 0 to 1, or 0 where nothing is damaged. */
  rangeOfRun(key: string): Range {
    const found = this.array(key);
    if (found && key !== "damage") return { low: found.about.low, high: found.about.high };
    let range = this.ranges.get(key);
    if (!range) {
      for (let picture = 0; picture < this.pictures.length; ++picture) {
        const { low, high } = rangeOf(this.values(key, picture, 0));
        range = include(range, low, high);
        if (key === "damage" && high > 0) {
          this.ranges.set(key, { low: 0, high: 1 });
          return { low: 0, high: 1 };
        }
      }
      range ??= { low: 0, high: 0 };
      if (this.pictures.length === this.about.pictures.length) this.ranges.set(key, range);
    }
    return range;
  }
}

export class ImpactorData {
  vertices = new Float32Array(0);
  corners = new Int32Array(0); // four per panel, the last one -1 for triangles
  readonly pictures: Numbers[][] = [];
  private readonly deformations: Numbers[][] = [];
  private readonly readers: ArrayReader[];
  private readonly deformationReaders: ArrayReader[];

  constructor(readonly about: Impactor) {
    this.readers = about.arrays.map((array) => new ArrayReader(array.bytes));
    this.deformationReaders = about.deformation.map((array) => new ArrayReader(array.bytes));
  }

  get isDeformed(): boolean {
    return this.about.deformation.length > 0;
  }

  async readSurface(): Promise<void> {
    const bytes = await unpacked(this.about.id);
    const { vertices, panels } = this.about;
    this.vertices = new Float32Array(3 * vertices);
    this.corners = new Int32Array(4 * panels);
    let at = 0;
    for (let axis = 0; axis < 3; ++axis) {
      const { numbers, end } = new ArrayReader(4).next(bytes, at, vertices);
      floats(numbers).forEach((value, i) => (this.vertices[3 * i + axis] = value));
      at = end;
    }
    for (let corner = 0; corner < 4; ++corner) {
      const { numbers, end } = new ArrayReader(4).next(bytes, at, panels);
      numbers.forEach((value, i) => (this.corners[4 * i + corner] = value));
      at = end;
    }
  }

  async readPicture(): Promise<void> {
    const arrays: Numbers[] = [];
    const deformation: Numbers[] = [];
    if (this.readers.length > 0 || this.isDeformed) {
      const bytes = await unpacked(`${this.about.id}_${this.about.pictures[this.pictures.length]}`);
      let at = 0;
      for (const reader of this.readers) {
        const { numbers, end } = reader.next(bytes, at, this.about.panels);
        arrays.push(numbers);
        at = end;
      }
      for (const reader of this.deformationReaders) {
        const { numbers, end } = reader.next(bytes, at, this.about.vertices);
        deformation.push(numbers);
        at = end;
      }
    }
    this.deformations.push(deformation);
    this.pictures.push(arrays);
  }

  /** The vertices of a frame, deformed, before the motion of the surface. */
  deformed(picture: number): Float32Array {
    if (!this.isDeformed) return this.vertices;
    const out = Float32Array.from(this.vertices);
    this.deformations[picture].forEach((numbers, axis) => {
      const { low, step } = this.about.deformation[axis];
      numbers.forEach((value, vertex) => (out[3 * vertex + axis] += low + step * value));
    });
    return out;
  }

  shownAt(time: number): number {
    return shownAt(this.about.pictures, this.pictures.length, time);
  }

  values(key: string, picture: number): Float32Array {
    const number = this.about.arrays.findIndex((array) => array.name === key);
    if (number < 0) return new Float32Array(this.about.panels);
    const { low, step } = this.about.arrays[number];
    return Float32Array.from(this.pictures[picture][number], (value) => low + step * value);
  }

  rangeOfRun(key: string): Range | undefined {
    const array = this.about.arrays.find((each) => each.name === key);
    return array && { low: array.low, high: array.high };
  }
}

export function rangeOf(values: Float32Array): Range {
  let low = Infinity;
  let high = -Infinity;
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low > high ? { low: 0, high: 0 } : { low, high };
}

export function joined(ranges: (Range | undefined)[]): Range {
  let out: Range | undefined;
  for (const range of ranges) if (range) out = include(out, range.low, range.high);
  return out ?? { low: 0, high: 0 };
}

/** The quantities for colouring the particles of these bodies. */
export function quantitiesOf(bodies: BodyData[]): Quantity[] {
  const out: Quantity[] = [
    { key: "damage", label: "damage", unit: "", kind: "increase" },
    { key: "displacement", label: "displacement", unit: "m", kind: "magnitude" },
    { key: "speed", label: "speed", unit: "m/s", kind: "magnitude" },
    { key: "displacement_x", label: "displacement x", unit: "m", kind: "signed" },
    { key: "displacement_y", label: "displacement y", unit: "m", kind: "signed" },
    { key: "displacement_z", label: "displacement z", unit: "m", kind: "signed" },
    { key: "plastic_strain", label: "plastic strain", unit: "", kind: "increase" },
  ].filter(({ key }) => key === "displacement" || bodies.some((body) => body.array(key))) as Quantity[];
  if (bodies.length > 1) out.push({ key: "body", label: "body", unit: "", kind: "number" });
  if (bodies.some((body) => body.array("fragment"))) out.push({ key: "fragment", label: "fragment", unit: "", kind: "number" });
  return out;
}
