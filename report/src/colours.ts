// Colour maps. Magnitudes: viridis (S. van der Walt and N. Smith, CC0), perceptually uniform. Increases from zero: light to dark. Signed: blue to red through grey, symmetric about 0
// (after K. Moreland, Diverging Color Maps for Scientific Visualization, 2009). Labels: ten cyclic colours.

export type Kind = "magnitude" | "increase" | "signed" | "number";

const points: Record<Kind, string> = {
  magnitude: "440154 482475 414487 355f8d 2a788e 21918c 22a884 44bf70 7ad151 bddf26 fde725",
  increase: "cdd6dc e4dcc0 efc57f ea9a4f d8653a b23a30 7e1b26 4a0f1c",
  signed: "3b4cc0 5a78e4 7b9ff9 9ebeff c0d4f5 dddcdc f2cbb7 f7ac8e ee8468 d65244 b40426",
  number: "9a9fa5 4e79a7 f28e2b 59a14f e15759 76b7b2 edc948 b07aa1 9c755f ff9da7 86bcb6",
};

function rgb(hex: string): number[] {
  return [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16));
}

/** 256 RGBA colours; for labels, the first is that of 0 and the others repeat cyclically. */
export function table(kind: Kind): Uint8Array<ArrayBuffer> {
  const out = new Uint8Array(new ArrayBuffer(4 * 256));
  const given = points[kind].split(" ").map(rgb);
  for (let k = 0; k < 256; ++k) {
    let colour: number[];
    if (kind === "number") {
      colour = k === 0 ? given[0] : given[1 + ((k - 1) % (given.length - 1))];
    } else {
      const at = (k / 255) * (given.length - 1);
      const below = Math.min(Math.floor(at), given.length - 2);
      colour = [0, 1, 2].map((c) => given[below][c] + (at - below) * (given[below + 1][c] - given[below][c]));
    }
    out.set([...colour.map(Math.round), 255], 4 * k);
  }
  return out;
}

/** The colours of a map from its lowest to its highest value, equally spaced. */
export function stops(kind: Kind): string[] {
  return points[kind].split(" ").map((hex) => `#${hex}`);
}

/** The same as a CSS gradient from bottom to top. */
export function gradient(kind: Kind): string {
  return `linear-gradient(to top, ${stops(kind).join(", ")})`;
}

export function colourOfNumber(number: number): string {
  const given = stops("number");
  return number === 0 ? given[0] : given[1 + ((number - 1) % (given.length - 1))];
}

/** Line colours that are distinguishable on light and dark backgrounds. */
export const lines = ["#3b82c4", "#e0812b", "#3f9d4f", "#d1495b", "#8a63c7", "#8c6d4f", "#c96bb0", "#7a828a", "#a8a032", "#2fa5b5"];
