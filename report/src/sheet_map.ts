// Damage of a sheet from above: of every column of particles through the thickness the largest or the mean damage, at their reference positions.
import { BodyData, ImpactorData } from "./bodies";
import { table } from "./colours";
import { element } from "./dom";
import { elementOf } from "./legend";
import { scaled, text, withUnit } from "./units";

const thin = 0.4; // of the next larger extent: what is thicker is no sheet

interface Sheet {
  body: BodyData;
  axes: [number, number, number]; // to the right, upwards, through the thickness
  low: [number, number]; // [m] of the plotted rectangle
  counts: [number, number];
  cells: Uint32Array; // of every particle
  middle: number; // [m] half thickness
}

/** The cells of a thin body; undefined for others. */
function sheetOf(body: BodyData): Sheet | undefined {
  if (!body.array("damage")) return undefined;
  const spacing = body.about["spacing [m]"];
  const extents = body.about.undeformed.map(({ low, high }) => high - low + spacing);
  const through = extents.indexOf(Math.min(...extents));
  const [right, up] = [0, 1, 2].filter((axis) => axis !== through);
  if (!(extents[through] <= thin * Math.min(extents[right], extents[up]))) return undefined;
  const low = body.about.undeformed.map((each) => each.low);
  const high = body.about.undeformed.map((each) => each.high);
  const counts: [number, number] = [Math.round((high[right] - low[right]) / spacing) + 1, Math.round((high[up] - low[up]) / spacing) + 1];
  const cells = new Uint32Array(body.about.shown);
  for (let i = 0; i < cells.length; ++i) {
    const column = Math.round((body.undeformed[3 * i + right] - low[right]) / spacing);
    const row = Math.round((body.undeformed[3 * i + up] - low[up]) / spacing);
    cells[i] = row * counts[0] + column;
  }
  return { body, axes: [right, up, through], low: [low[right] - spacing / 2, low[up] - spacing / 2], counts, cells, middle: (low[through] + high[through]) / 2 };
}

/** Ends of the lines in which the panels of an impactor cut the plane at half thickness [m], four numbers each. */
function outline(impactor: ImpactorData, picture: number, { axes: [right, up, through], middle }: Sheet): number[] {
  const m = impactor.about.motions[picture];
  const { corners } = impactor;
  const vertices = impactor.deformed(picture);
  const moved = new Float32Array(vertices.length);
  for (let k = 0; k < vertices.length; k += 3)
    for (let axis = 0; axis < 3; ++axis) moved[k + axis] = m[4 * axis] * vertices[k] + m[4 * axis + 1] * vertices[k + 1] + m[4 * axis + 2] * vertices[k + 2] + m[4 * axis + 3];
  const out: number[] = [];
  for (let panel = 0; panel < corners.length; panel += 4) {
    const count = corners[panel + 3] < 0 ? 3 : 4;
    const cuts: number[] = [];
    for (let k = 0; k < count; ++k) {
      const a = 3 * corners[panel + k];
      const b = 3 * corners[panel + ((k + 1) % count)];
      const [below, above] = [moved[a + through] - middle, moved[b + through] - middle];
      if (below < 0 === above < 0) continue;
      const share = below / (below - above);
      cuts.push(moved[a + right] + share * (moved[b + right] - moved[a + right]), moved[a + up] + share * (moved[b + up] - moved[a + up]));
    }
    if (cuts.length === 4) out.push(...cuts); // a warped panel that is cut twice is omitted
  }
  return out;
}

/** About five round numbers from low to high. */
function ticksOf(low: number, high: number): number[] {
  const rough = (high - low) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5].find((each) => each * power >= rough) ?? 10);
  const out: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) out.push(k * step);
  return out;
}

export class SheetMap {
  private readonly sheets: { sheet: Sheet; canvas: HTMLCanvasElement; legend: HTMLElement; caption: HTMLElement }[] = [];
  private readonly how = element("select", { id: "through", title: "Value of a column of particles through the thickness" }, new Option("largest", "largest"), new Option("mean", "mean"));
  private frame = 0;

  /** Bodies have their reference positions by now. */
  constructor(
    private readonly home: HTMLElement,
    bodies: BodyData[],
    private readonly impactors: ImpactorData[],
  ) {
    home.append(element("div", { className: "bar" }, element("label", {}, "Damage through the thickness ", this.how)));
    for (const body of bodies) {
      const sheet = sheetOf(body);
      if (!sheet) continue;
      const canvas = element("canvas", { className: "map" });
      const [legend, caption] = [element("div", { className: "scale" }), element("p")];
      home.append(element("div", { className: "sheet" }, caption, canvas, legend));
      this.sheets.push({ sheet, canvas, legend, caption });
    }
    this.how.onchange = () => this.draw();
    new ResizeObserver(() => this.draw()).observe(home);
  }

  get isEmpty(): boolean {
    return this.sheets.length === 0;
  }

  setFrame(frame: number): void {
    this.frame = frame;
    this.draw();
  }

  /** Draws where the page is visible, with the given width or that of the page. */
  draw(width = this.home.clientWidth - 16): void {
    if (width > 0) for (const each of this.sheets) this.drawSheet(each, width);
  }

  private drawSheet({ sheet, canvas, legend, caption }: SheetMap["sheets"][number], width: number): void {
    const { body, axes, counts, cells, middle } = sheet;
    const picture = body.shownAt(this.frame);
    const lowest = [0, 1].map((k) => sheet.low[k] + body.about.offsets[picture][axes[k]]);
    const damage = body.values("damage", picture, 0);
    const values = new Float32Array(counts[0] * counts[1]);
    const members = new Uint32Array(values.length);
    const isMean = this.how.value === "mean";
    cells.forEach((cell, i) => {
      if (Number.isNaN(damage[i])) return; // not in this frame
      values[cell] = isMean ? values[cell] + damage[i] : Math.max(values[cell], damage[i]);
      ++members[cell];
    });
    let most = 0;
    const image = new ImageData(counts[0], counts[1]);
    const colours = table("increase");
    values.forEach((value, cell) => {
      if (members[cell] === 0) return; // transparent
      const shown = isMean ? value / members[cell] : value;
      most = Math.max(most, shown);
      const colour = 4 * Math.round(255 * Math.min(shown, 1));
      const pixel = 4 * ((counts[1] - 1 - Math.floor(cell / counts[0])) * counts[0] + (cell % counts[0]));
      image.data.set(colours.subarray(colour, colour + 4), pixel);
    });
    const cellsOnly = element("canvas", { width: counts[0], height: counts[1] });
    cellsOnly.getContext("2d")!.putImageData(image, 0, 0);

    const spacing = body.about["spacing [m]"];
    const around = 0.06 * Math.max(...counts) * spacing; // [m] where an impactor is seen before it arrives
    const size = counts.map((count) => count * spacing + 2 * around);
    const low = lowest.map((each) => each - around);
    const margin = { left: 52, bottom: 38, top: 6, right: 12 };
    const perMetre = Math.min((width - margin.left - margin.right) / size[0], 560 / size[1]);
    const [wide, tall] = [size[0] * perMetre, size[1] * perMetre];
    const ratio = Math.max(2, window.devicePixelRatio);
    const [across, down] = [margin.left + wide + margin.right, margin.top + tall + margin.bottom];
    Object.assign(canvas, { width: Math.round(across * ratio), height: Math.round(down * ratio) });
    Object.assign(canvas.style, { width: `${across}px`, aspectRatio: `${canvas.width} / ${canvas.height}` });
    const context = canvas.getContext("2d")!;
    context.scale(ratio, ratio);
    const style = getComputedStyle(document.documentElement);
    const [ink, accent] = ["--ink", "--accent"].map((name) => style.getPropertyValue(name).trim());
    const x = (metres: number) => margin.left + (metres - low[0]) * perMetre;
    const y = (metres: number) => margin.top + tall - (metres - low[1]) * perMetre;
    context.imageSmoothingEnabled = false;
    context.drawImage(cellsOnly, x(lowest[0]), y(lowest[1]) - counts[1] * spacing * perMetre, counts[0] * spacing * perMetre, counts[1] * spacing * perMetre);
    context.strokeStyle = context.fillStyle = ink;
    context.strokeRect(margin.left, margin.top, wide, tall);

    const unit = scaled("m", Math.max(...[0, 1].map((k) => Math.max(Math.abs(low[k]), Math.abs(low[k] + size[k])))));
    context.font = "12px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "top";
    for (const tick of ticksOf(low[0], low[0] + size[0])) {
      context.fillRect(x(tick) - 0.5, margin.top + tall, 1, 4);
      context.fillText(text(tick / unit.factor, 4), x(tick), margin.top + tall + 6);
    }
    context.fillText(`${"xyz"[axes[0]]} [${unit.unit}]`, margin.left + wide / 2, margin.top + tall + 22);
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (const tick of ticksOf(low[1], low[1] + size[1])) {
      context.fillRect(margin.left - 4, y(tick) - 0.5, 4, 1);
      context.fillText(text(tick / unit.factor, 4), margin.left - 6, y(tick));
    }
    context.save();
    context.translate(10, margin.top + tall / 2);
    context.rotate(-Math.PI / 2);
    context.textAlign = "center";
    context.fillText(`${"xyz"[axes[1]]} [${unit.unit}]`, 0, 0);
    context.restore();

    context.beginPath();
    context.rect(margin.left, margin.top, wide, tall);
    context.clip();
    context.beginPath();
    for (const impactor of this.impactors) {
      const ends = outline(impactor, impactor.shownAt(this.frame), sheet);
      for (let k = 0; k < ends.length; k += 4) {
        context.moveTo(x(ends[k]), y(ends[k + 1]));
        context.lineTo(x(ends[k + 2]), y(ends[k + 3]));
      }
    }
    context.strokeStyle = accent;
    context.lineWidth = 2;
    context.stroke();

    const names = this.impactors.map((each) => each.about.name).join(", ");
    caption.textContent = `${body.about.name}, reference positions${names ? `; outline: ${names} at ${"xyz"[axes[2]]} = ${withUnit(middle, "m")}` : ""}`;
    canvas.setAttribute("aria-label", `Map of the damage of ${body.about.name}; largest value ${text(most, 3)}`);
    canvas.dataset.largest = String(most);
    legend.replaceChildren(elementOf({ title: `damage, ${this.how.value}`, unit: "", range: { low: 0, high: most > 0 ? 1 : 0 }, kind: "increase", where: "in this frame" }));
  }
}
