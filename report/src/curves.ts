// Curves of history.csv: one chart per unit with a common time axis, synchronised with the shown frame.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { ArrayReader, Column, floats } from "./data";
import { lines } from "./colours";
import { element } from "./dom";
import { scaled, scaledForAxis, text, withUnit } from "./units";

interface Curve extends Column {
  values: Float32Array;
  span: number; // largest less smallest value
  largest: number; // magnitude
}

const sets: [string, (column: Column) => boolean][] = [
  ["Force", ({ name }) => /(^|\.)(force_[xyz]|torque)$/.test(name)],
  ["Motion", ({ name }) => /(^|\.)(position|velocity)_[xyz]$/.test(name)],
  ["Energy", ({ unit }) => unit === "J"], // works and dissipations too
  ["Totals", ({ name }) => /^total\./.test(name)],
];
const shownAtFirst = new Set(["Force", "Energy"]);
const mostAtFirst = 8; // per unit
const negligible = 1e-9; // of the other components: rounding
// of the largest span of the unit: less than `flat` is a horizontal line, less than `small` lies on the axis, more than `high` leaves the others no room
const [flat, small, high] = [1e-3, 0.01, 4];
const alike = 0.03; // largest difference of two curves, of the span of either

/** Energy balance of the run [J]; `exchanged`: docs/guide/results.md. */
export interface Balance {
  error: number;
  exchanged: number;
}

function ownerOf(name: string): string {
  return name.split(".", 1)[0];
}

export class Curves {
  private readonly curves: Curve[] = [];
  private readonly time: Float32Array;
  private readonly chosen = new Set<number>();
  private readonly more = new Map<string, number>(); // columns of the selected set that are not shown, by unit
  private readonly impactors: Set<string>; // their names
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
      const values = floats(numbers);
      const [low, high] = values.reduce(([low, high], value) => [value < low ? value : low, value > high ? value : high], [Infinity, -Infinity]);
      this.curves.push({ ...column, values, span: high - low, largest: Math.max(-low, high, 0) });
      at = end;
    }
    this.time = this.curves.shift()!.values;
    this.impactors = new Set(this.curves.filter(({ name }) => name.endsWith(".position_x")).map(({ name }) => ownerOf(name)));
    this.timeScale = scaled("s", Math.abs(this.time[rows - 1]));
    this.build();
    this.choose((column) => sets.some(([set, belongs]) => shownAtFirst.has(set) && belongs(column)));
    new ResizeObserver(() => this.resize()).observe(home);
  }

  private largest(k: number): number {
    return this.curves[k].largest;
  }

  /** Of the columns of history.csv; undefined without energy_balance_error, as of bodies that are relaxed. */
  balance(): Balance | undefined {
    const largestOf = (pattern: RegExp) => this.curves.filter(({ name }) => pattern.test(name)).map(({ largest }) => largest);
    const [error] = largestOf(/^total\.energy_balance_error$/);
    const works = largestOf(/\.(contact_work|work)$/).reduce((sum, each) => sum + each, 0);
    return error === undefined ? undefined : { error, exchanged: works || Math.max(0, ...largestOf(/^total\.energy$/)) };
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

  private isGauge(name: string): boolean {
    return this.impactors.has(ownerOf(name)) && name.split(".").length > 2;
  }

  private areAlike(k: number, other: number): boolean {
    const [a, b] = [this.curves[k], this.curves[other]];
    const most = alike * Math.max(a.span, b.span);
    return a.values.every((value, row) => Math.abs(value - b.values[row]) <= most);
  }

  /**
   * Of loads those on impactors, if any; of other units the curves of the impactors, then those that vary the most; without those that would be flat beside others, as forces normal to a plane of
   * symmetry, that would flatten others, as the energy of a ship, or that are nearly a curve before them, as a gauge that takes all of the force.
   */
  private choose(belongs: (column: Column) => boolean): void {
    this.chosen.clear();
    this.more.clear();
    const sets = new Map<string, number[]>();
    this.curves.forEach((curve, k) => {
      if (belongs(curve)) sets.set(curve.unit, [...(sets.get(curve.unit) ?? []), k]);
    });
    const isOwn = (k: number) => Number(this.impactors.has(ownerOf(this.curves[k].name)) && !this.isGauge(this.curves[k].name));
    for (const [unit, members] of sets) {
      // loads on impactors are those that a run is made for: reactions of boundary conditions would flatten them
      const onImpactors = members.filter((k) => (unit === "N" || unit === "N m") && this.impactors.has(ownerOf(this.curves[k].name)));
      const candidates = onImpactors.length > 0 ? onImpactors : members;
      const widest = Math.max(...candidates.map((k) => this.curves[k].span));
      const shown: number[] = [];
      for (const k of candidates.sort((a, b) => isOwn(b) - isOwn(a) || this.curves[b].span - this.curves[a].span)) {
        const { span, largest } = this.curves[k];
        if (shown.length < mostAtFirst && span > flat * widest && largest > small * widest && largest < high * widest && !shown.some((other) => this.areAlike(k, other))) shown.push(k);
      }
      for (const k of shown) this.chosen.add(k);
      this.more.set(unit, members.length - shown.length);
    }
    if (this.chosen.size === 0) for (const k of [...sets.values()].flat().slice(0, mostAtFirst)) this.chosen.add(k); // all are constant
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
        this.more.clear();
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
    for (const [unit, numbers] of units) {
      this.plots.push(this.chart(unit, numbers));
      if (this.more.get(unit)) this.charts.append(element("p", { className: "more", textContent: `${this.more.get(unit)} more under Columns` }));
    }
    this.charts.append(...zeros.map((zero) => element("p", { className: "zero", textContent: zero })));
    if (typeof min === "number" && typeof max === "number" && (min > this.time[0] / this.timeScale.factor || max < this.time[this.time.length - 1] / this.timeScale.factor))
      for (const plot of this.plots) plot.setScale("x", { min, max });
    for (const plot of this.plots) plot.batch(() => {}); // draws at once: otherwise a later microtask would, too late for paper, and empty the legend
    this.setTime(this.now);
  }

  private chart(unit: string, numbers: number[]): uPlot {
    const largest = Math.max(...numbers.map((k) => this.largest(k)));
    const { factor, unit: short } = scaledForAxis(unit, largest);
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
        legend: { live: true, markers: { dash: (plot, n) => (plot.series[n].dash ? "dashed" : "solid") } },
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
            dash: this.isGauge(this.curves[k].name) ? [6, 4] : undefined,
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
              u.ctx.setLineDash([]);
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
