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
  ["Totals", (name) => /^total\./.test(name)],
];
const shownAtFirst = new Set(["Force", "Energy"]);
const mostAtFirst = 8; // per unit
const negligible = 1e-9; // of the other components: rounding

export class Curves {
  private readonly curves: Curve[] = [];
  private readonly time: Float32Array;
  private readonly chosen = new Set<number>();
  private readonly charts = element("div");
  private readonly boxes: HTMLInputElement[] = [];
  private plots: uPlot[] = [];
  private now = 0;
  private width = 200;
  private readonly timeScale: { factor: number; unit: string };

  constructor(
    private readonly home: HTMLElement,
    columns: Column[],
    rows: number,
    bytes: Uint8Array,
    private readonly size: number, // [m] lever of the moments that rounding of forces may cause
    private readonly goTo: (time: number) => void,
    private readonly saveTable: (table: string) => void,
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
    this.choose((name) => sets.some(([set, belongs]) => shownAtFirst.has(set) && belongs(name)));
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

  private largest(k: number): number {
    let out = 0;
    for (const value of this.curves[k].values) out = Math.max(out, Math.abs(value));
    return out;
  }

  /** What is said of a curve that is zero, exactly or but for rounding; undefined for others. */
  private zero(k: number): string | undefined {
    const { name } = this.curves[k];
    const own = this.largest(k);
    if (own === 0) return `${name} is 0 throughout.`;
    const parts = /^(.*\.)([a-z_]+)_[xyz]$/.exec(name);
    if (!parts) return undefined;
    const [, owner, quantity] = parts;
    const others = (stem: string) => Math.max(0, ...["x", "y", "z"].map((axis) => this.curves.findIndex((each) => each.name === `${owner}${stem}_${axis}`)).filter((each) => each >= 0).map((each) => this.largest(each)));
    const lever = quantity === "moment" ? this.size * others("force") : 0;
    if (own < negligible * others(quantity)) return `${name} is 0 but for rounding: below ${text(negligible)} of the other components.`;
    return own < negligible * lever ? `${name} is 0 but for rounding: below ${text(negligible)} of force times size of the bodies.` : undefined;
  }

  /** The first curves of a set, without those that vary too little to be seen beside others of their unit, as forces normal to a plane of symmetry, or that would flatten them, as the energy of a ship. */
  private choose(belongs: (name: string) => boolean): void {
    this.chosen.clear();
    const members = this.curves.map((_, k) => k).filter((k) => belongs(this.curves[k].name));
    const largest = new Map<string, number>();
    const count = new Map<string, number>();
    for (const k of members) largest.set(this.curves[k].unit, Math.max(largest.get(this.curves[k].unit) ?? 0, this.span(k)));
    for (const k of members) {
      const { unit } = this.curves[k];
      const already = count.get(unit) ?? 0;
      if (already >= mostAtFirst || !(this.span(k) > 1e-6 * largest.get(unit)!) || this.largest(k) > 10 * largest.get(unit)!) continue;
      this.chosen.add(k);
      count.set(unit, already + 1);
    }
    if (this.chosen.size === 0) for (const k of members.slice(0, mostAtFirst)) this.chosen.add(k); // all are constant
    this.boxes.forEach((box, k) => (box.checked = this.chosen.has(k)));
    this.draw();
  }

  private inOrder(): number[] {
    return [...this.chosen].sort((a, b) => a - b);
  }

  /** The selected curves as a table: all rows, nine digits, which single precision needs. */
  private table(): string {
    const number = (value: number) => String(Number(value.toPrecision(9)));
    const columns = this.inOrder().map((k) => this.curves[k]);
    const rows = [["time [s]", ...columns.map(({ name, unit }) => `${name} [${unit}]`)].join(",")];
    this.time.forEach((time, row) => rows.push([time, ...columns.map(({ values }) => values[row])].map(number).join(",")));
    return `${rows.join("\n")}\n`;
  }

  private build(): void {
    const bar = element("div", { className: "bar" });
    for (const [name, belongs] of sets) bar.append(element("button", { type: "button", textContent: name, onclick: () => this.choose(belongs) }));
    bar.append(element("span", { className: "space" }), element("button", { type: "button", id: "save-table", title: "Saves the selected columns, all rows", textContent: "Save CSV", onclick: () => this.saveTable(this.table()) }));
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

  /** Rebuilds the charts after a change of columns or of the theme; the zoom is kept. `width` is that of the page, or of paper. */
  draw(width = this.home.clientWidth - 16): void {
    this.width = Math.max(width, 200);
    const { min, max } = this.plots[0]?.scales.x ?? {};
    for (const plot of this.plots) plot.destroy();
    this.plots = [];
    this.charts.replaceChildren();
    const units = new Map<string, number[]>();
    const zeros: string[] = [];
    for (const k of this.inOrder()) {
      const zero = this.zero(k);
      if (zero) zeros.push(zero);
      else units.set(this.curves[k].unit, [...(units.get(this.curves[k].unit) ?? []), k]);
    }
    if (this.chosen.size === 0) this.charts.append(element("p", { textContent: "No column is selected." }));
    for (const [unit, numbers] of units) this.plots.push(this.chart(unit, numbers));
    this.charts.append(...zeros.map((zero) => element("p", { className: "zero", textContent: zero })));
    if (typeof min === "number" && typeof max === "number" && (min > this.time[0] / this.timeScale.factor || max < this.time[this.time.length - 1] / this.timeScale.factor))
      for (const plot of this.plots) plot.setScale("x", { min, max });
    for (const plot of this.plots) plot.batch(() => {}); // draws at once: otherwise a later microtask would, too late for paper, and empty the legend
    this.setTime(this.now);
  }

  private chart(unit: string, numbers: number[]): uPlot {
    const largest = Math.max(...numbers.map((k) => this.largest(k)));
    const { factor, unit: short } = scaled(unit, largest);
    const time = Array.from(this.time, (value) => value / this.timeScale.factor);
    const ink = this.style("--ink");
    const grid = { stroke: this.style("--line"), width: 1 };
    const axis = { stroke: ink, grid, ticks: grid, font: "12px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif" };
    const plot: uPlot = new uPlot(
      {
        width: this.width,
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
    if (this.home.clientWidth === 0 || window.matchMedia("print").matches) return;
    this.width = Math.max(this.home.clientWidth - 16, 200);
    for (const plot of this.plots) plot.setSize({ width: this.width, height: plot.height });
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
    for (const plot of this.plots)
      plot.batch(() => {
        plot.redraw(false);
        plot.setLegend({ idx: row }, false);
      });
  }
}
