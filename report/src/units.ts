// Number formatting: four digits, SI prefixes where useful.

const prefixed = new Set(["N", "Pa", "J", "m", "s", "N m", "N s", "W", "m/s"]);
const prefixes: [number, string][] = [
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
  [1e-9, "n"],
];

export interface Scaled {
  factor: number; // value of one scaled unit in the unit
  unit: string;
}

/** The prefixed unit in which numbers up to `largest` are short; the unit itself below nano. */
export function scaled(unit: string, largest: number): Scaled {
  if (!prefixed.has(unit) || !(largest >= 1e-9) || !Number.isFinite(largest)) return { factor: 1, unit };
  if (unit === "m" || unit === "s" || unit === "m/s") if (largest >= 1 && largest < 1e6) return { factor: 1, unit };
  const [factor, prefix] = prefixes.find(([factor]) => largest >= factor)!;
  return { factor, unit: prefix + unit };
}

/** The same for an axis, whose ticks need numbers about 1: below nano with a power of ten. */
export function scaledForAxis(unit: string, largest: number): Scaled {
  if (!(largest > 0 && largest < 1e-9)) return scaled(unit, largest);
  const factor = 10 ** Math.floor(Math.log10(largest));
  return { factor, unit: `${text(factor)} ${unit}` };
}

export function text(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const out = size >= 1e6 || size < 1e-4 ? value.toExponential(digits - 1).replace(/\.?0+e/, "e") : String(Number(value.toPrecision(digits)));
  return out.replace("-", "−").replace("e+", "e").replace("e-", "e−");
}

export function withUnit(value: number, unit: string): string {
  const { factor, unit: short } = scaled(unit, Math.abs(value));
  return `${text(value / factor)}${short ? ` ${short}` : ""}`;
}
