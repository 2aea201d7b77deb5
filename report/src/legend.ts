// Legends of colours: as elements of the page, and painted into a picture. What is zero, or constant, is stated instead of a colour bar.
import { Range } from "./bodies";
import { Kind, colourOfNumber, gradient, stops } from "./colours";
import { element } from "./dom";
import { scaled, text, withUnit } from "./units";

export type Legend = { title: string; unit: string; range: Range; kind: Kind; where: string } | { title: string; names: string[] };

function isConstant(range: Range): boolean {
  return range.low === range.high;
}

/** The range to colour by: a constant gets the colour of the lowest value, zero of a signed quantity the middle one. */
export function colouredRange(range: Range, kind: Kind): Range {
  if (!isConstant(range)) return range;
  return kind === "signed" ? { low: range.low - 1, high: range.low + 1 } : { low: range.low, high: range.low + 1 };
}

/** Caption and ticks from top to bottom, or the sentence that replaces the bar. */
function words(title: string, unit: string, range: Range, where: string): { caption: string; ticks: string[] } {
  if (isConstant(range)) return { caption: `${title}: ${withUnit(range.low, unit)} ${where}`, ticks: [] };
  const { factor, unit: short } = scaled(unit, Math.max(Math.abs(range.low), Math.abs(range.high)));
  const ticks = [4, 3, 2, 1, 0].map((k) => text((range.low + ((range.high - range.low) * k) / 4) / factor, 3));
  return { caption: `${title} [${short || "–"}]`, ticks };
}

export function elementOf(legend: Legend): HTMLElement {
  if ("names" in legend) {
    const rows = legend.names.map((name, number) => {
      const patch = element("span", { className: "patch" });
      patch.style.background = colourOfNumber(number);
      return element("div", {}, patch, name);
    });
    return element("figure", { className: "legend" }, element("figcaption", { textContent: legend.title }), ...rows);
  }
  const { caption, ticks } = words(legend.title, legend.unit, legend.range, legend.where);
  const out = element("figure", {}, element("figcaption", { textContent: caption }));
  if (ticks.length === 0) return out;
  const strip = element("div", { className: "strip" });
  strip.style.background = gradient(legend.kind);
  out.append(strip, element("div", { className: "ticks" }, ...ticks.map((tick) => element("span", { textContent: tick }))));
  return out;
}

const lineHeight = 17;
const barHeight = 150;

/** Paints a legend with its upper right corner at the given place; returns its height. */
export function paint(legend: Legend, context: CanvasRenderingContext2D, right: number, top: number, colours: { paper: string; ink: string }): number {
  context.font = "12px system-ui, sans-serif";
  const isLabels = "names" in legend;
  const { caption, ticks } = isLabels ? { caption: legend.title, ticks: legend.names } : words(legend.title, legend.unit, legend.range, legend.where);
  const wide = 16 + Math.max(context.measureText(caption).width, ...ticks.map((tick) => context.measureText(tick).width + 24));
  const tall = 8 + lineHeight + (ticks.length === 0 ? 0 : isLabels ? ticks.length * lineHeight + 4 : barHeight + 12);
  const left = right - wide;
  context.fillStyle = colours.paper;
  context.fillRect(left, top, wide, tall);
  context.fillStyle = colours.ink;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillText(caption, left + 8, top + 4 + lineHeight / 2);
  const first = top + lineHeight + 10;
  if (!isLabels && ticks.length > 0) {
    const colouring = context.createLinearGradient(0, first + barHeight, 0, first);
    stops(legend.kind).forEach((colour, k, all) => colouring.addColorStop(k / (all.length - 1), colour));
    context.fillStyle = colouring;
    context.fillRect(left + 8, first, 14, barHeight);
  }
  ticks.forEach((tick, k) => {
    const y = isLabels ? first + (k + 0.5) * lineHeight - 4 : first + (barHeight * k) / (ticks.length - 1);
    if (isLabels) {
      context.fillStyle = colourOfNumber(k);
      context.fillRect(left + 8, y - 5, 10, 10);
    }
    context.fillStyle = colours.ink;
    context.fillText(tick, left + 28, y);
  });
  return tall;
}
