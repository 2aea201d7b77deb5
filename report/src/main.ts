// Report of a run: decodes the embedded data, and synchronises 3-D view, curves and controls in time.
import "./style.css";
import { BodyData, ImpactorData, Quantity, Range, joined, quantitiesOf, rangeOf } from "./bodies";
import { Kind, colourOfNumber, gradient } from "./colours";
import { Curves } from "./curves";
import { Description, json, unpacked } from "./data";
import { Json, showChecks, showDeck, showNotes, showRun } from "./pages";
import { Stage, View } from "./stage";
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

/** Colour range of the particles: as selected, symmetric about 0 for signed quantities. */
function rangeShown(values: Float32Array[]): Range {
  if (range.value === "given" && low.value !== "" && high.value !== "") return { low: Number(low.value), high: Number(high.value) };
  const { key, kind } = quantity();
  const found = range.value === "picture" ? joined(values.map(rangeOf)) : joined(bodies.map((body) => body.rangeOfRun(key)));
  if (kind === "magnitude" && range.value === "run") return { low: 0, high: found.high };
  if (kind !== "signed") return found;
  const largest = Math.max(Math.abs(found.low), Math.abs(found.high));
  return { low: -largest, high: largest };
}

function scale(title: string, unit: string, shown: Range, kind: Kind): HTMLElement {
  const home = document.createElement("figure");
  const { factor, unit: short } = scaled(unit, Math.max(Math.abs(shown.low), Math.abs(shown.high)));
  const caption = document.createElement("figcaption");
  caption.textContent = `${title} [${short || "–"}]`;
  const strip = document.createElement("div");
  strip.className = "strip";
  strip.style.background = gradient(kind);
  const ticks = document.createElement("div");
  ticks.className = "ticks";
  for (let k = 4; k >= 0; --k) {
    const tick = document.createElement("span");
    tick.textContent = text((shown.low + ((shown.high - shown.low) * k) / 4) / factor, 3);
    ticks.append(tick);
  }
  home.append(caption, strip, ticks);
  return home;
}

/** Legend of the colours of labels. */
function legend(title: string, names: string[]): HTMLElement {
  const home = document.createElement("figure");
  home.className = "legend";
  const caption = document.createElement("figcaption");
  caption.textContent = title;
  home.append(caption);
  names.forEach((name, number) => {
    const row = document.createElement("div");
    const patch = document.createElement("span");
    patch.className = "patch";
    patch.style.background = colourOfNumber(number);
    row.append(patch, name);
    home.append(row);
  });
  return home;
}

function show(): void {
  if (times.length === 0) return;
  const { key, kind, label, unit } = quantity();
  const scales: HTMLElement[] = [];
  if (bodies.length > 0) {
    const values = bodies.map((body, number) => body.values(key, body.shownAt(current), number));
    const shown = rangeShown(values);
    if (range.value !== "given") {
      low.value = String(Number(shown.low.toPrecision(4)));
      high.value = String(Number(shown.high.toPrecision(4)));
    }
    bodies.forEach((body, number) => stage?.showBody(number, body.shownAt(current), values[number], kind, shown));
    if (key === "body") scales.push(legend("body", bodies.map((body) => body.about.name)));
    else if (key === "fragment") scales.push(legend("fragment", ["0, the heaviest", "1", "2", "3 and so on, cyclic"]));
    else scales.push(scale(label, unit, shown, kind));
  }
  if (impactors.length > 0) {
    const name = panels.value;
    const values = impactors.map((impactor) => (name && impactor.rangeOfRun(name) ? impactor.values(name, impactor.shownAt(current)) : undefined));
    const known = values.filter((each) => each !== undefined);
    const shown = range.value === "picture" ? joined(known.map(rangeOf)) : joined(impactors.map((impactor) => impactor.rangeOfRun(name)));
    impactors.forEach((impactor, number) => stage?.showImpactor(number, impactor.shownAt(current), values[number], shown));
    if (known.length > 0) scales.push(scale(name.replaceAll("_", " "), impactors[0].about.arrays.find((array) => array.name === name)?.unit ?? "", shown, "increase"));
  }
  byId("scales").replaceChildren(...scales);
  slider.value = String(current);
  const { factor, unit: timeUnit } = scaled("s", times[times.length - 1]);
  byId("now").textContent = `t = ${text(times[current] / factor)} ${timeUnit} · frame ${current + 1} of ${times.length}`;
  slider.setAttribute("aria-valuetext", byId("now").textContent ?? "");
  curves?.setTime(times[current]);
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
  const value = (key: string) => data.values(key, picture, body)[particle];
  const u = ["x", "y", "z"].map((axis) => value(`displacement_${axis}`));
  const place = u.map((each, axis) => data.undeformed[3 * particle + axis] + each);
  const lines = [
    data.about.name,
    `at (${place.map((each) => text(each)).join(", ")}) m`,
    `damage ${text(value("damage"), 3)}`,
    `displacement ${withUnit(Math.hypot(...u), "m")}`,
    `speed ${withUnit(value("speed"), "m/s")}`,
  ];
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

function drawTriad(): void {
  if (!stage) return;
  const { elements } = stage.camera.matrixWorldInverse;
  const parts = [0, 1, 2].map((axis) => {
    const [x, y, depth] = [elements[4 * axis], elements[4 * axis + 1], elements[4 * axis + 2]];
    const name = "xyz"[axis];
    return { depth, svg: `<g class="axis-${name}"><line x2="${24 * x}" y2="${-24 * y}"/><text x="${33 * x}" y="${-33 * y}">${name}</text></g>` };
  });
  byId("triad").innerHTML = parts
    .sort((a, b) => a.depth - b.depth)
    .map(({ svg }) => svg)
    .join("");
}

function setTheme(dark: boolean): void {
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  byId("theme").textContent = dark ? "Light" : "Dark";
  stage?.setGround(getComputedStyle(document.documentElement).getPropertyValue("--ground").trim());
  curves?.draw();
}

function isDark(): boolean {
  return document.documentElement.dataset.theme === "dark";
}

function selectTab(tab: HTMLElement): void {
  for (const each of document.querySelectorAll<HTMLElement>("[role=tab]")) {
    const chosen = each === tab;
    each.setAttribute("aria-selected", String(chosen));
    each.tabIndex = chosen ? 0 : -1;
    byId(each.getAttribute("aria-controls")!).hidden = !chosen;
  }
}

function bindTabs(): void {
  const tabs = [...document.querySelectorAll<HTMLElement>("[role=tab]")];
  tabs.forEach((tab, k) => {
    tab.addEventListener("click", () => selectTab(tab));
    tab.addEventListener("keydown", (event) => {
      const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
      if (by === 0) return;
      const next = tabs[(k + by + tabs.length) % tabs.length];
      event.stopPropagation();
      selectTab(next);
      next.focus();
    });
  });
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
  const mayBreak = bodies.some((body) => body.array("fragment"));
  colour.replaceChildren(...quantities.map(({ key, label, unit }) => new Option(unit ? `${label} [${unit}]` : label, key, false, key === (mayBreak ? "damage" : "speed"))));
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

function showHeader(): void {
  const title = typeof run?.title === "string" && run.title ? run.title : (about?.folder ?? "perimpact report");
  document.title = title;
  byId("title").textContent = title;
  const outcome = byId("outcome");
  outcome.hidden = false;
  outcome.textContent = typeof run?.outcome === "string" ? run.outcome : "unfinished";
  outcome.dataset.outcome = outcome.textContent;
  const particles = bodies.reduce((sum, body) => sum + body.about.particles, 0);
  const count = (number: number) => number.toLocaleString("en").replaceAll(",", " ");
  const facts: string[] = [];
  if (typeof run?.["time [s]"] === "number") facts.push(withUnit(run["time [s]"], "s"));
  if (typeof run?.steps === "number") facts.push(`${count(run.steps)} steps`);
  if (particles > 0) facts.push(`${count(particles)} particles`);
  if (impactors.length > 0) facts.push(`${count(impactors.reduce((sum, impactor) => sum + impactor.about.panels, 0))} panels`);
  const warnings = Array.isArray(run?.warnings) ? run.warnings.length : 0;
  if (warnings > 0) facts.push(`${warnings} warning${warnings > 1 ? "s" : ""}`);
  byId("facts").textContent = facts.join(" · ");
}

/** Decodes frame by frame; decoded frames can be viewed meanwhile. */
async function load(): Promise<void> {
  const progress = byId<HTMLProgressElement>("progress");
  if (about?.history) curves = new Curves(byId("curves"), about.history.columns, about.history.rows, await unpacked("history"), goToTime);
  else byId("curves").append(Object.assign(document.createElement("p"), { textContent: "No curves: history.csv was missing or damaged." }));
  if (bodies.length + impactors.length === 0) byId("nothing").hidden = false;
  for (const body of bodies) {
    await body.readUndeformed();
    stage?.addBody(body);
  }
  for (const impactor of impactors) {
    await impactor.readSurface();
    stage?.addImpactor(impactor);
  }
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

function start(): void {
  if (!about) {
    byId("doing").textContent = "This page contains no run. Create a report with `perimpact report DIR`.";
    byId("progress").hidden = true;
    return;
  }
  showHeader();
  showRun(byId("run-page"), run);
  showChecks(byId("checks"), run);
  showDeck(byId("deck"), run);
  showNotes(byId("notes"), about);
  try {
    stage = new Stage(canvas, drawTriad);
  } catch {
    byId("nothing").hidden = false;
    byId("nothing").textContent = "No 3-D view: WebGL 2 is disabled in this browser. Curves and the other pages are available.";
  }
  bindControls();
  bindTabs();
  bindKeys();
  setTheme(window.matchMedia("(prefers-color-scheme: dark)").matches);
  load().catch((fault: unknown) => {
    byId("doing").textContent = fault instanceof Error ? fault.message : String(fault);
    byId("progress").hidden = true;
    document.documentElement.dataset.state = "failed";
  });
}

start();
