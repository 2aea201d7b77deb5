// Curves of history.csv: one chart per unit with a common time axis, synchronised with the shown frame.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { ArrayReader, Column, floats } from "./data";
import { lines } from "./colours";
import { element } from "./dom";
import { scaled, text, withUnit } from "./units";

interface Curve extends Column {
  values: Float32Array;
}

const sets: [string, (name: string) => boolean][] = [
  ["Force", (name) => /(^|\.)(force_[xyz]|torque)$/.test(name)],
  ["Motion", (name) => /(^|\.)(position|velocity)_[xyz]$/.test(name)],
  ["Energy", (name) => /energy$/.test(name)],
];
const mostAtFirst = 8;

export class Curves {
  private readonly curves: Curve[] = [];
  private readonly time: Float32Array;
  private readonly chosen = new Set<number>();
  private readonly charts = element("div");
  private readonly boxes: HTMLInputElement[] = [];
  private plots: uPlot[] = [];
  private now = 0;
  private readonly timeScale: { factor: number; unit: string };

  constructor(
    private readonly home: HTMLElement,
    columns: Column[],
    rows: number,
    bytes: Uint8Array,
    private readonly goTo: (time: number) => void,
  ) {
    let at = 0;
    for (const column of columns) {
      const { numbers, end } = new ArrayReader(4).next(bytes, at, rows);
      this.curves.push({ ...column, values: floats(numbers) });
      at = end;
    }
    this.time = this.curves.shift()!.values;
    this.timeScale = scaled("s", Math.abs(this.time[rows - 1]));
    this.build();
    this.choose((name) => sets.some(([set, belongs]) => set !== "Motion" && belongs(name)));
    new ResizeObserver(() => this.resize()).observe(home);
  }

  /** Range of a curve. */
  private span(k: number): number {
    let low = Infinity;
    let high = -Infinity;
    for (const value of this.curves[k].values) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
    return high - low;
  }

  /** The first curves of a set, without those that are negligible relative to others of their unit, as forces normal to a plane of symmetry. */
  private choose(belongs: (name: string) => boolean): void {
    this.chosen.clear();
    const members = this.curves.map((_, k) => k).filter((k) => belongs(this.curves[k].name));
    const largest = new Map<string, number>();
    for (const k of members) largest.set(this.curves[k].unit, Math.max(largest.get(this.curves[k].unit) ?? 0, this.span(k)));
    for (const k of members) if (this.chosen.size < mostAtFirst && this.span(k) > 1e-6 * largest.get(this.curves[k].unit)!) this.chosen.add(k);
    this.boxes.forEach((box, k) => (box.checked = this.chosen.has(k)));
    this.draw();
  }

  private build(): void {
    const bar = element("div", { className: "bar" });
    for (const [name, belongs] of sets) bar.append(element("button", { type: "button", textContent: name, onclick: () => this.choose(belongs) }));
    const filter = element("input", { type: "search", placeholder: "part of a name", ariaLabel: "Filters columns by name" });
    const list = element("div", { className: "columns" });
    const rows = this.curves.map(({ name, unit }, k) => {
      const box = element("input", { type: "checkbox" });
      box.onchange = () => {
        if (box.checked) this.chosen.add(k);
        else this.chosen.delete(k);
        this.draw();
      };
      this.boxes.push(box);
      return element("label", {}, box, ` ${name}${unit && unit !== "-" ? ` [${unit}]` : ""}`);
    });
    filter.oninput = () => rows.forEach((row, k) => (row.hidden = !this.curves[k].name.includes(filter.value.trim())));
    list.append(...rows);
    this.home.append(bar, element("details", {}, element("summary", { textContent: `Columns (${this.curves.length})` }), filter, list), this.charts);
  }

  private style(name: string): string {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  }

  /** Rebuilds the charts after a change of columns or of the theme. */
  draw(): void {
    for (const plot of this.plots) plot.destroy();
    this.plots = [];
    this.charts.replaceChildren();
    const units = new Map<string, number[]>();
    for (const k of [...this.chosen].sort((a, b) => a - b)) units.set(this.curves[k].unit, [...(units.get(this.curves[k].unit) ?? []), k]);
    if (units.size === 0) this.charts.append(element("p", { textContent: "No column is selected." }));
    for (const [unit, numbers] of units) this.plots.push(this.chart(unit, numbers));
    this.setTime(this.now);
  }

  private chart(unit: string, numbers: number[]): uPlot {
    let largest = 0;
    for (const k of numbers) for (const value of this.curves[k].values) if (Math.abs(value) > largest) largest = Math.abs(value);
    const { factor, unit: short } = scaled(unit, largest);
    const time = Array.from(this.time, (value) => value / this.timeScale.factor);
    const ink = this.style("--ink");
    const grid = { stroke: this.style("--line"), width: 1 };
    const axis = { stroke: ink, grid, ticks: grid, font: "12px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif" };
    const plot: uPlot = new uPlot(
      {
        width: Math.max(this.home.clientWidth - 16, 200),
        height: 210,
        scales: { x: { time: false } },
        cursor: { sync: { key: "time" }, y: false, focus: { prox: 24 }, drag: { x: true, y: false } },
        legend: { live: true },
        axes: [
          { ...axis, label: `time [${this.timeScale.unit}]`, labelSize: 18, size: 34 },
          { ...axis, label: short && short !== "-" ? `[${short}]` : "[–]", labelSize: 18, size: 58, values: (_, ticks) => ticks.map((tick) => text(tick)) },
        ],
        series: [
          { label: "time", value: (_, value) => (value === null ? "–" : withUnit(value * this.timeScale.factor, "s")) },
          ...numbers.map((k, n) => ({
            label: this.curves[k].name,
            stroke: lines[n % lines.length],
            width: 1.5,
            points: { show: false },
            value: (_: uPlot, value: number | null) => (value === null ? "–" : withUnit(value * factor, unit === "-" ? "" : unit)),
          })),
        ],
        hooks: {
          draw: [
            (u) => {
              const x = u.valToPos(this.now / this.timeScale.factor, "x", true);
              if (x < u.bbox.left - 1 || x > u.bbox.left + u.bbox.width + 1) return; // outside the zoomed range
              u.ctx.save();
              u.ctx.strokeStyle = this.style("--accent");
              u.ctx.lineWidth = 2;
              u.ctx.beginPath();
              u.ctx.moveTo(x, u.bbox.top);
              u.ctx.lineTo(x, u.bbox.top + u.bbox.height);
              u.ctx.stroke();
              u.ctx.restore();
            },
          ],
        },
      },
      [time, ...numbers.map((k) => Array.from(this.curves[k].values, (value) => value / factor))],
      this.charts,
    );
    plot.over.addEventListener("click", () => {
      if (plot.cursor.left !== undefined && plot.cursor.left >= 0) this.goTo(plot.posToVal(plot.cursor.left, "x") * this.timeScale.factor);
    });
    return plot;
  }

  private resize(): void {
    for (const plot of this.plots) plot.setSize({ width: Math.max(this.home.clientWidth - 16, 200), height: plot.height });
  }

  /** Legends show the last row up to the time unless the cursor selects another. */
  setTime(time: number): void {
    this.now = time;
    let row = 0;
    let behind = this.time.length;
    while (behind - row > 1) {
      const middle = (row + behind) >> 1;
      if (this.time[middle] <= time * (1 + 1e-6)) row = middle; // times are single precision here
      else behind = middle;
    }
    for (const plot of this.plots) {
      plot.redraw(false);
      plot.setLegend({ idx: row }, false);
    }
  }
}
