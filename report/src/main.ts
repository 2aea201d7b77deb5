// Report of a run: decodes the embedded data, and synchronises 3-D view, curves and controls in time.
import "./style.css";
import { BodyData, ImpactorData, Quantity, Range, joined, quantitiesOf, rangeOf } from "./bodies";
import { Curves } from "./curves";
import { Description, json, unpacked } from "./data";
import { Legend, colouredRange, elementOf } from "./legend";
import { Json, showBalance, showChecks, showDeck, showHeader, showNotes, showRun } from "./pages";
import { film, pictureWith, plainName, save } from "./save";
import { SheetMap } from "./sheet_map";
import { Stage, View } from "./stage";
import { bindTabs } from "./tabs";
import { drawTriad } from "./triad";
import { scaled, text, withUnit } from "./units";

function byId<T extends HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

const about = json<Description>("description");
const run = json<{ [key: string]: Json }>("run");
const times = about?.["times [s]"] ?? [];
const bodies = (about?.bodies ?? []).map((body) => new BodyData(body));
const impactors = (about?.impactors ?? []).map((impactor) => new ImpactorData(impactor));
const quantities = quantitiesOf(bodies);

let stage: Stage | undefined;
let curves: Curves | undefined;
let map: SheetMap | undefined;
let legends: Legend[] = [];
let isFilming = false;
let ready = 0; // number of decoded frames
let current = 0; // index of the shown frame
let playing = 0; // timer handle; 0 while paused
let probed: { body: number; particle: number } | undefined;

const colour = byId<HTMLSelectElement>("colour");
const panels = byId<HTMLSelectElement>("panels");
const range = byId<HTMLSelectElement>("range");
const low = byId<HTMLInputElement>("low");
const high = byId<HTMLInputElement>("high");
const slider = byId<HTMLInputElement>("slider");
const speed = byId<HTMLSelectElement>("speed");
const clip = byId<HTMLSelectElement>("clip");
const position = byId<HTMLInputElement>("position");
const canvas = byId<HTMLCanvasElement>("canvas");

function quantity(): Quantity {
  return quantities.find(({ key }) => key === colour.value) ?? quantities[0];
}

function warp(): number {
  const value = Number(byId<HTMLInputElement>("warp").value);
  return Number.isFinite(value) && value >= 0 ? value : 1;
}

/** Colour range of the particles: as selected, symmetric about 0 for signed quantities. Displacements along an axis that are only rounding are 0. */
function rangeShown(values: Float32Array[]): Range {
  if (range.value === "given" && low.value !== "" && high.value !== "") return { low: Number(low.value), high: Number(high.value) };
  const { key, kind } = quantity();
  const ofRun = (name: string) => joined(bodies.map((body) => body.rangeOfRun(name)));
  const found = range.value === "picture" ? joined(values.map(rangeOf)) : ofRun(key);
  if (kind === "magnitude" && range.value === "run") return { low: 0, high: found.high };
  if (kind !== "signed") return found;
  const largest = Math.max(Math.abs(found.low), Math.abs(found.high));
  return largest < 1e-9 * ofRun("displacement").high ? { low: 0, high: 0 } : { low: -largest, high: largest };
}

function show(): void {
  if (times.length === 0) return;
  const { key, kind, label, unit } = quantity();
  legends = [];
  if (bodies.length > 0) {
    const values = bodies.map((body, number) => body.values(key, body.shownAt(current), number));
    const shown = rangeShown(values);
    if (range.value !== "given") {
      low.value = String(Number(shown.low.toPrecision(4)));
      high.value = String(Number(shown.high.toPrecision(4)));
    }
    bodies.forEach((body, number) => stage?.showBody(number, body.shownAt(current), values[number], kind, colouredRange(shown, kind)));
    if (key === "body") legends.push({ title: "body", names: bodies.map((body) => body.about.name) });
    else if (key === "fragment") legends.push({ title: "fragment", names: ["0, the heaviest", "1", "2", "3 and so on, cyclic"] });
    else legends.push({ title: label, unit, range: shown, kind, where: range.value === "picture" ? "in this frame" : "throughout" });
  }
  if (impactors.length > 0) {
    const name = panels.value;
    const values = impactors.map((impactor) => (name && impactor.rangeOfRun(name) ? impactor.values(name, impactor.shownAt(current)) : undefined));
    const known = values.filter((each) => each !== undefined);
    const shown = range.value === "picture" ? joined(known.map(rangeOf)) : joined(impactors.map((impactor) => impactor.rangeOfRun(name)));
    impactors.forEach((impactor, number) => stage?.showImpactor(number, impactor.shownAt(current), values[number], colouredRange(shown, "increase")));
    const unit = impactors[0].about.arrays.find((array) => array.name === name)?.unit ?? "";
    if (known.length > 0) legends.push({ title: name.replaceAll("_", " "), unit, range: shown, kind: "increase", where: range.value === "picture" ? "in this frame" : "throughout" });
  }
  byId("scales").replaceChildren(...legends.map(elementOf));
  slider.value = String(current);
  const { factor, unit: timeUnit } = scaled("s", times[times.length - 1]);
  byId("now").textContent = `t = ${text(times[current] / factor)} ${timeUnit} · frame ${current + 1} of ${times.length}`;
  slider.setAttribute("aria-valuetext", byId("now").textContent ?? "");
  curves?.setTime(times[current]);
  map?.setFrame(current);
  tell();
}

function goTo(picture: number): void {
  current = Math.min(Math.max(picture, 0), Math.max(ready - 1, 0));
  show();
}

function goToTime(time: number): void {
  let nearest = 0;
  for (let k = 1; k < ready; ++k) if (Math.abs(times[k] - time) < Math.abs(times[nearest] - time)) nearest = k;
  goTo(nearest);
}

function play(on: boolean): void {
  clearInterval(playing);
  playing = 0;
  if (on && ready > 1) playing = window.setInterval(() => goTo(current + 1 < ready ? current + 1 : ready < times.length ? current : 0), 1000 / Number(speed.value));
  byId("play").textContent = playing ? "Pause" : "Play";
}

/** Values at the selected particle. */
function tell(): void {
  const home = byId("probe");
  home.hidden = !probed;
  if (!probed) return;
  const { body, particle } = probed;
  const data = bodies[body];
  const picture = data.shownAt(current);
  if (data.isWritten(picture)?.[particle] === 0) {
    home.textContent = `${data.about.name}\nnot in this frame`;
    return;
  }
  const value = (key: string) => data.values(key, picture, body)[particle];
  const u = ["x", "y", "z"].map((axis) => value(`displacement_${axis}`));
  const place = u.map((each, axis) => data.undeformed[3 * particle + axis] + data.about.offsets[picture][axis] + each);
  const lines = [
    data.about.name,
    `at (${place.map((each) => text(each)).join(", ")}) m`,
    `displacement ${withUnit(Math.hypot(...u), "m")}`,
  ];
  if (data.array("damage")) lines.splice(2, 0, `damage ${text(value("damage"), 3)}`);
  if (data.array("speed")) lines.push(`speed ${withUnit(value("speed"), "m/s")}`);
  if (data.array("plastic_strain")) lines.push(`plastic strain ${text(value("plastic_strain"), 3)}`);
  if (data.array("fragment")) lines.push(`fragment ${value("fragment")}`);
  home.textContent = lines.join("\n");
}

function showClip(): void {
  const axis = "xyz".indexOf(clip.value[1] ?? "-");
  byId("plane").hidden = axis < 0;
  if (!stage) return;
  if (axis < 0) {
    stage.setClip(undefined, 1, 0);
    return;
  }
  const least = stage.low.getComponent(axis);
  const most = stage.high.getComponent(axis);
  const at = least + Number(position.value) * (most - least);
  byId("place").textContent = `${clip.value[1]} = ${withUnit(at, "m")}`;
  stage.setClip(axis, clip.value[0] === "+" ? 1 : -1, at);
}

/** `paper`: width in pixels of the charts and the map on paper. */
function setTheme(dark: boolean, paper?: number): void {
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  byId("theme").textContent = dark ? "Light" : "Dark";
  const style = getComputedStyle(document.documentElement);
  stage?.setGround(style.getPropertyValue(paper ? "--paper" : "--ground").trim());
  curves?.draw(paper);
  map?.draw(paper);
}

function isDark(): boolean {
  return document.documentElement.dataset.theme === "dark";
}

/** On paper everything is light, and a copy replaces the view, which would show what was drawn before. */
function bindPrinter(): void {
  let wasDark = false;
  window.addEventListener("beforeprint", () => {
    wasDark = isDark();
    setTheme(false, 640);
    if (stage) byId("space").prepend(stage.copy(2));
  });
  window.addEventListener("afterprint", () => {
    document.querySelector("#space > canvas:not(#canvas)")?.remove();
    setTheme(wasDark);
  });
}

function pictureNow(ratio: number): Promise<Blob> {
  const overlay = { title: document.title, time: byId("now").textContent ?? "", legends, triad: document.querySelector<SVGElement>("#triad")! };
  return pictureWith(stage!.copy(ratio), ratio, overlay);
}

/** Saves the frames as pictures; a second call stops that. Pictures rather than a video: every browser gives every frame, at the same size, without loss. */
async function saveFilm(): Promise<void> {
  if (!stage || ready === 0 || isFilming) {
    isFilming = false;
    return;
  }
  play(false);
  isFilming = true;
  const before = current;
  const button = byId("save-film");
  button.textContent = "Stop";
  byId("loading").hidden = false;
  try {
    const frames = ready;
    const pictures = await film(frames, async (frame) => {
      byId<HTMLProgressElement>("progress").value = frame;
      byId("doing").textContent = `Picture ${frame + 1} of ${frames}`;
      goTo(frame);
      return isFilming ? pictureNow(1) : undefined;
    });
    if (pictures) save(pictures, `${plainName(document.title)}_frames.zip`);
  } finally {
    isFilming = false;
    button.textContent = "Film";
    byId("loading").hidden = true;
    goTo(before);
  }
}

const viewOfKey: { [key: string]: View } = { "1": "+x", "2": "-x", "3": "+y", "4": "-y", "5": "+z", "6": "-z", "7": "iso", f: "fit" };

function bindKeys(): void {
  document.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    const isTyping = target.matches("input:not([type=range]):not([type=checkbox]), select, textarea");
    if (isTyping || event.ctrlKey || event.metaKey || event.altKey) return;
    const isSlider = target.matches("input[type=range]") && target !== slider;
    const view = viewOfKey[event.key.toLowerCase()];
    if (event.key === " " && !target.matches("button, summary, input[type=checkbox], a")) play(!playing);
    else if (event.key === "ArrowLeft" && !isSlider && target !== canvas) goTo(current - 1);
    else if (event.key === "ArrowRight" && !isSlider && target !== canvas) goTo(current + 1);
    else if (event.key === "Home" && !isSlider) goTo(0);
    else if (event.key === "End" && !isSlider) goTo(times.length - 1);
    else if (view) stage?.view(view);
    else if (event.key.toLowerCase() === "d") setTheme(!isDark());
    else if (event.key === "?") byId<HTMLDialogElement>("keys").showModal();
    else return;
    event.preventDefault();
  });
}

function bindControls(): void {
  const has = (array: string) => bodies.some((body) => body.array(array));
  const first = has("damage") && (has("fragment") || !has("speed")) ? "damage" : "speed";
  colour.replaceChildren(...quantities.map(({ key, label, unit }) => new Option(unit ? `${label} [${unit}]` : label, key, false, key === first)));
  const names = [...new Set(impactors.flatMap((impactor) => impactor.about.arrays.map((array) => array.name)))];
  panels.replaceChildren(new Option("plain", ""), ...names.map((name) => new Option(name.replaceAll("_", " "), name)));
  byId("impactors").hidden = impactors.length === 0;
  for (const each of [colour, panels, low, high]) each.addEventListener("change", show);
  range.addEventListener("change", () => {
    byId("given").hidden = range.value !== "given";
    show();
  });
  const particles = () => stage?.setParticles(Number(byId<HTMLInputElement>("size").value), warp());
  byId("size").addEventListener("input", particles);
  byId("warp").addEventListener("input", particles);
  const surfaces = () => stage?.setPanels(Number(byId<HTMLInputElement>("opacity").value), byId<HTMLInputElement>("edges").checked);
  byId("opacity").addEventListener("input", surfaces);
  byId("edges").addEventListener("change", surfaces);
  clip.addEventListener("change", showClip);
  position.addEventListener("input", showClip);
  for (const button of document.querySelectorAll<HTMLElement>("[data-view]")) button.addEventListener("click", () => stage?.view(button.dataset.view as View));
  byId("play").addEventListener("click", () => play(!playing));
  byId("previous").addEventListener("click", () => goTo(current - 1));
  byId("next").addEventListener("click", () => goTo(current + 1));
  slider.addEventListener("input", () => goTo(Number(slider.value)));
  speed.addEventListener("change", () => play(playing !== 0));
  byId("theme").addEventListener("click", () => setTheme(!isDark()));
  byId("help").addEventListener("click", () => byId<HTMLDialogElement>("keys").showModal());
  byId("save").hidden = !stage;
  byId("save-picture").addEventListener("click", async () => save(await pictureNow(2), `${plainName(document.title)}_frame_${current + 1}.png`));
  byId("save-film").addEventListener("click", saveFilm);
  let pressed = { x: 0, y: 0 };
  canvas.addEventListener("pointerdown", (event) => (pressed = { x: event.clientX, y: event.clientY }));
  canvas.addEventListener("click", (event) => {
    if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > 4) return; // the camera was rotated
    probed = stage?.hit(
      event.offsetX,
      event.offsetY,
      bodies.map((body) => body.shownAt(current)),
      warp(),
    );
    tell();
  });
}

/** Largest diagonal of a body [m]; 1 without bodies. */
function sizeOfBodies(): number {
  return Math.max(0, ...bodies.map((body) => Math.hypot(...body.about.undeformed.map(({ low, high }) => high - low)))) || 1;
}

/** Decodes frame by frame; decoded frames can be viewed meanwhile. */
async function load(): Promise<void> {
  const progress = byId<HTMLProgressElement>("progress");
  if (about?.history) curves = new Curves(byId("curves"), about.history.columns, about.history.rows, await unpacked("history"), sizeOfBodies(), goToTime, (table) =>
      save(new Blob([table], { type: "text/csv" }), `${plainName(document.title)}_curves.csv`),
    );
  else byId("curves").append(Object.assign(document.createElement("p"), { textContent: "No curves: history.csv was missing or damaged." }));
  showBalance(byId("checks"), curves?.balance());
  for (const body of bodies) {
    await body.readUndeformed();
    stage?.addBody(body);
  }
  for (const impactor of impactors) {
    await impactor.readSurface();
    stage?.addImpactor(impactor);
  }
  map = new SheetMap(byId("map"), bodies, impactors);
  byId("tab-map").hidden = map.isEmpty;
  byId("map").classList.toggle("absent", map.isEmpty);
  slider.max = String(Math.max(times.length - 1, 0));
  progress.max = times.length;
  for (let time = 0; time < times.length; ++time) {
    for (const series of [...bodies, ...impactors]) if (series.about.pictures[series.pictures.length] === time) await series.readPicture();
    // a body without readable first frame starts with a later one: nothing is shown before all bodies have a frame
    if (![...bodies, ...impactors].every((series) => series.pictures.length > 0)) continue;
    if (ready === 0) {
      ready = time + 1;
      stage?.view("iso");
      show();
    }
    ready = time + 1;
    progress.value = ready;
    byId("doing").textContent = `Frame ${ready} of ${times.length}`;
    await new Promise((resolve) => setTimeout(resolve)); // yields to the browser
  }
  show();
  byId("loading").hidden = true;
  document.documentElement.dataset.state = "ready";
}

/** View, toolbar and player; without them the pages are as wide as the window. */
function showStage(on: boolean): void {
  byId("stage").hidden = !on;
  document.querySelector("main")!.classList.toggle("flat", !on);
}

function start(): void {
  if (!about) {
    byId("doing").textContent = "This page contains no run. Create a report with `perimpact report DIR`.";
    byId("progress").hidden = true;
    return;
  }
  showHeader(run, about, bodies, impactors);
  showRun(byId("run-page"), run);
  showChecks(byId("checks"), run);
  showDeck(byId("deck"), run);
  showNotes(byId("notes"), about);
  showStage(times.length > 0);
  try {
    if (times.length > 0) stage = new Stage(canvas, (camera) => drawTriad(byId("triad"), camera.matrixWorldInverse));
  } catch {
    byId("nothing").hidden = false;
  }
  bindControls();
  bindTabs((page) => {
    if (page.id === "map") map?.draw();
  });
  bindPrinter();
  bindKeys();
  setTheme(window.matchMedia("(prefers-color-scheme: dark)").matches);
  load().catch((fault: unknown) => {
    byId("doing").textContent = fault instanceof Error ? fault.message : String(fault);
    byId("progress").hidden = true;
    showStage(true); // which has the sentence
    document.documentElement.dataset.state = "failed";
  });
}

start();
