// Side pages from run.json: run, checks, deck, about.
import { Balance } from "./curves";
import { Description } from "./data";
import { element } from "./dom";
import { text, withUnit } from "./units";

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
type Members = { [key: string]: Json };

function isMembers(value: Json | undefined): value is Members {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function members(value: Json | undefined): Members {
  return isMembers(value) ? value : {};
}

/** A table of names and values. */
function rows(entries: [string, string][]): HTMLTableElement {
  return element(
    "table",
    { className: "rows" },
    element("tbody", {}, ...entries.map(([name, what]) => element("tr", {}, element("th", { scope: "row", textContent: name }), element("td", { textContent: what })))),
  );
}

/** Splits "wall_time [s]" into the quantity `wall time` and the unit `s`. */
function parted(key: string): { name: string; unit: string } {
  const found = /^(.*) \[([^\]]*)\]$/.exec(key);
  return { name: (found ? found[1] : key).replaceAll("_", " "), unit: found ? found[2] : "" };
}

function inWords(value: Json, unit: string): string {
  if (typeof value === "number") return unit ? withUnit(value, unit) : Number.isInteger(value) ? value.toLocaleString("en").replaceAll(",", " ") : text(value, 6);
  if (Array.isArray(value)) return value.every((each) => typeof each === "number") ? `${value.map((each) => text(each as number)).join(", ")}${unit ? ` ${unit}` : ""}` : value.map((each) => inWords(each, "")).join(", ");
  if (typeof value === "boolean") return value ? "yes" : "no";
  return value === null ? "–" : String(value);
}

/** A value as a tree: plain members as rows, nested ones collapsed. */
function tree(value: Members): HTMLElement {
  const out = element("div");
  const plain = Object.entries(value).filter(([, each]) => !isMembers(each));
  if (plain.length > 0) {
    out.append(
      rows(
        plain.map(([key, each]) => {
          const { name, unit } = parted(key);
          return [name, inWords(each, unit)];
        }),
      ),
    );
  }
  for (const [key, each] of Object.entries(value)) if (isMembers(each)) out.append(element("details", {}, element("summary", { textContent: parted(key).name }), tree(each)));
  return out;
}

function byId(id: string): HTMLElement {
  return document.getElementById(id)!;
}

interface Counts {
  about: { particles?: number; panels?: number };
}

export function showHeader(run: Members | undefined, about: Description, bodies: Counts[], impactors: Counts[]): void {
  const title = typeof run?.title === "string" && run.title ? run.title : about.folder || "perimpact report";
  document.title = title;
  byId("title").textContent = title;
  const outcome = byId("outcome");
  outcome.hidden = false;
  outcome.textContent = typeof run?.outcome === "string" ? run.outcome : "unfinished";
  outcome.dataset.outcome = outcome.textContent;
  const count = (number: number) => number.toLocaleString("en").replaceAll(",", " ");
  const sum = (numbers: (number | undefined)[]) => numbers.reduce<number>((all, each) => all + (each ?? 0), 0);
  const facts: string[] = [];
  if (typeof run?.["time [s]"] === "number") facts.push(withUnit(run["time [s]"], "s"));
  if (typeof run?.steps === "number") facts.push(`${count(run.steps)} steps`);
  const particles = sum(bodies.map((body) => body.about.particles));
  if (particles > 0) facts.push(`${count(particles)} particles`);
  if (about["times [s]"].length === 0) facts.push("no frames");
  if (impactors.length > 0) facts.push(`${count(sum(impactors.map((impactor) => impactor.about.panels)))} panels`);
  const warnings = Array.isArray(run?.warnings) ? run.warnings.length : 0;
  if (warnings > 0) facts.push(`${warnings} warning${warnings > 1 ? "s" : ""}`);
  byId("facts").textContent = facts.join(" · ");
}

function list(sentences: string[]): HTMLUListElement {
  return element("ul", { className: "sentences" }, ...sentences.map((sentence) => element("li", { textContent: sentence })));
}

function missing(home: HTMLElement, what: string): void {
  home.append(element("p", { textContent: `${what}: run.json was missing or damaged when this report was written.` }));
}

function warningsOf(run: Members): string[] {
  return Array.isArray(run.warnings) ? run.warnings.map((each) => inWords(each, "")) : [];
}

export function showRun(home: HTMLElement, run: Members | undefined): void {
  if (!run) return missing(home, "No information about the run");
  if (typeof run.failure === "string") home.append(element("h2", { textContent: "Failure" }), list([run.failure]));
  const keys = ["outcome", "program", "steps", "time [s]", "resumed_at_steps", "threads", "wall_time [s]", "state_hash"];
  home.append(
    rows(
      keys
        .filter((key) => key in run)
        .map((key) => {
          const { name, unit } = parted(key);
          return [name, unit === "s" && name === "wall time" ? `${text(run[key] as number)} s` : inWords(run[key], unit)];
        }),
    ),
  );
  const warnings = warningsOf(run);
  home.append(element("h2", { textContent: warnings.length > 0 ? `Warnings (${warnings.length})` : "Warnings" }));
  home.append(warnings.length > 0 ? list(warnings) : element("p", { textContent: "None." }));

  const timers = Object.entries(members(run["timers [s]"])) as [string, number][];
  if (timers.length > 0) {
    const total = timers.reduce((sum, [, seconds]) => sum + seconds, 0) || 1;
    const body = timers.map(([name, seconds]) =>
      element(
        "tr",
        {},
        element("th", { scope: "row", textContent: name }),
        element("td", { className: "number", textContent: `${text(seconds)} s` }),
        element("td", { className: "number", textContent: `${((100 * seconds) / total).toFixed(1)} %` }),
        element("td", {}, element("meter", { min: 0, max: 1, value: seconds / total })),
      ),
    );
    home.append(element("h2", { textContent: "Wall-clock time by phase" }), element("table", { className: "rows" }, element("tbody", {}, ...body)));
  }
  for (const [what, title] of [
    ["bodies", "Body"],
    ["impactors", "Impactor"],
  ])
    for (const [name, each] of Object.entries(members(run[what]))) home.append(element("details", {}, element("summary", { textContent: `${title} ${name}` }), tree(members(each))));
}

/** Defect counts of a surface report, 0 for a sound surface, with their descriptions. */
const repairs: [string, string][] = [
  ["degenerate", "degenerate panels, removed"],
  ["duplicate", "duplicate panels, removed"],
  ["back_to_back", "panels back to back"],
  ["non_manifold_edges", "non-manifold edges"],
  ["cut_edges", "edges cut open"],
  ["rewound", "panels reoriented"],
  ["flipped", "components oriented outward"],
  ["boundary_edges", "boundary edges"],
];

function verdict(isGood: boolean, good: string, bad: string): HTMLElement {
  return element("p", { className: isGood ? "good" : "look", textContent: isGood ? `✓ ${good}` : `! ${bad}` });
}

export function showChecks(home: HTMLElement, run: Members | undefined): void {
  if (!run) return missing(home, "No information about the checks");
  const stability = members(run.stability);
  const [step, estimate, exact] = ["step [s]", "estimate [s]", "exact [s]"].map((key) => stability[key]);
  if (typeof step === "number") {
    home.append(element("h2", { textContent: "Time step" }));
    if (typeof exact === "number") home.append(verdict(step <= exact, `${((100 * step) / exact).toFixed(0)} % of the exact stable limit`, "above the exact stable limit"));
    else if (typeof estimate === "number") home.append(verdict(step <= estimate, `${((100 * step) / estimate).toFixed(0)} % of the safe estimate`, "above the safe estimate"));
    const known: [string, Json | undefined][] = [
      ["step", step],
      ["safe estimate", estimate],
      ["exact limit", exact],
    ];
    home.append(rows(known.map(([name, value]) => [name, typeof value === "number" ? withUnit(value, "s") : "not computed"])));
  } else if (typeof run["increment [s]"] === "number") {
    home.append(element("h2", { textContent: "Increment" }), rows([["load increment of the dynamic relaxation", withUnit(run["increment [s]"] as number, "s")]]));
  }
  for (const [name, each] of Object.entries(members(run.impactors))) {
    const impactor = members(each);
    const surface = members(impactor.surface);
    home.append(element("h2", { textContent: `Surface of ${name}` }));
    const faults = repairs.filter(([key]) => typeof surface[key] === "number" && (surface[key] as number) > 0);
    const isClosed = surface.closure === "closed";
    home.append(verdict(isClosed && faults.length === 0, "closed, no repairs needed", isClosed ? "closed after repairs" : "open: it has boundary edges"));
    if (faults.length > 0) home.append(rows(faults.map(([key, what]) => [what, inWords(surface[key], "")])));
    const facts = ["panels", "triangles", "components", "area [m2]", "volume [m3]", "shortest_edge [m]", "longest_edge [m]"];
    home.append(
      rows(
        facts
          .filter((key) => key in surface)
          .map((key) => {
            const { name: quantity, unit } = parted(key);
            return [quantity, inWords(surface[key], unit)];
          }),
      ),
    );
    for (const [body, found] of Object.entries(members(impactor.detection))) {
      const contact = members(found);
      const odd = ["initial_overlap", "entered_inside", "unresolved_penetrations"].filter((key) => typeof contact[key] === "number" && (contact[key] as number) > 0);
      home.append(element("h3", { textContent: `Contact with ${body}` }));
      home.append(
        verdict(odd.length === 0, "no particle started, entered or remained inside", odd.map((key) => `${parted(key).name}: ${inWords(contact[key], "")}`).join(", ")),
      );
      home.append(tree(contact));
    }
  }
}

const mostImbalance = 0.01; // of the energy exchanged

/** Ahead of the other checks. */
export function showBalance(home: HTMLElement, balance: Balance | undefined): void {
  if (!balance) return;
  const { error, exchanged } = balance;
  const share = error / exchanged;
  const found = `the largest energy balance error is ${text(100 * share, 2)} % of the energy exchanged`;
  const check = element(
    "section",
    {},
    element("h2", { textContent: "Energy balance" }),
    exchanged > 0 ? verdict(share <= mostImbalance, found, `${found}: above 1 %, a shorter time step is advisable`) : verdict(error === 0, "no error", "no energy was exchanged, but the balance has an error"),
    rows([
      ["largest error", withUnit(error, "J")],
      ["energy exchanged", withUnit(exchanged, "J")],
    ]),
  );
  home.querySelector(".on-paper")!.after(check);
}

/** A word in YAML, quoted where necessary to preserve it. */
function yamlWord(value: Json): string {
  if (typeof value !== "string") return JSON.stringify(value);
  return /^[A-Za-z][\w ./()%-]*$/.test(value) && !/^(true|false|null|yes|no|on|off|y|n|nan|inf)$/i.test(value) && value.trim() === value ? value : JSON.stringify(value);
}

/** JSON as block YAML; short lists and maps on one line. */
export function yaml(value: Json, indent = ""): string {
  const flow = (each: Json): string =>
    Array.isArray(each) ? `[${each.map(flow).join(", ")}]` : isMembers(each) ? `{${Object.entries(each).map(([key, inner]) => `${yamlWord(key)}: ${flow(inner)}`).join(", ")}}` : typeof each === "string" ? JSON.stringify(each) : yamlWord(each);
  if (isMembers(value)) {
    return Object.entries(value)
      .map(([key, each]) => {
        const isDeep = (isMembers(each) || (Array.isArray(each) && each.some((inner) => typeof inner === "object"))) && flow(each).length > 60;
        return isDeep ? `${indent}${yamlWord(key)}:\n${yaml(each, `${indent}  `)}` : `${indent}${yamlWord(key)}: ${typeof each === "object" && each !== null ? flow(each) : yamlWord(each)}\n`;
      })
      .join("");
  }
  if (Array.isArray(value)) return value.map((each) => `${indent}- ${flow(each)}\n`).join("");
  return `${indent}${yamlWord(value)}\n`;
}

export function showDeck(home: HTMLElement, run: Members | undefined): void {
  if (!run || !isMembers(run.setup)) return missing(home, "No information about the deck");
  const deck = yaml(run.setup);
  const save = element("a", { textContent: "Save as deck.yaml", download: "deck.yaml", href: URL.createObjectURL(new Blob([deck], { type: "text/yaml" })) });
  home.append(element("p", {}, "With all defaults, in SI units; it reproduces the run. ", save), element("pre", { tabIndex: 0, textContent: deck }));
}

/** Missing, damaged or thinned data; precision of the numbers. */
export function showNotes(home: HTMLElement, about: Description): void {
  home.append(element("h2", { textContent: about.notes.length > 0 ? `Omitted data (${about.notes.length})` : "Omitted data" }));
  home.append(about.notes.length > 0 ? list(about.notes) : element("p", { textContent: "None: all frames and particles of the run are included." }));
  home.append(element("h2", { textContent: "Precision" }));
  for (const body of about.bodies) {
    const half = (array: { step: number; unit: string }) => withUnit(array.step / 2, array.unit);
    const largest = (arrays: { step: number; unit: string }[]) => arrays.reduce((a, b) => (b.step > a.step ? b : a));
    home.append(
      element("h3", { textContent: `${body.name}: ${body.shown.toLocaleString("en").replaceAll(",", " ")} particles` }),
      rows([
        ["reference positions, per axis", `± ${half(largest(body.undeformed))}`],
        ...body.arrays.filter((array) => array.step > 0 && array.name !== "fragment").map((array): [string, string] => [array.name.replaceAll("_", " "), `± ${array.unit ? half(array) : text(array.step / 2)}`]),
      ]),
    );
  }
  home.append(
    element("p", { textContent: "Positions are reference positions plus displacements. Curves have seven digits; panels and their motion have single precision. The files in the results folder have full precision." }),
  );
  home.append(element("p", { textContent: "This page is self-contained and makes no network requests. It uses three.js (MIT licence) and uPlot (MIT licence)." }));
}
