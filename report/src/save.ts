// Files that the browser saves: a picture of the 3-D view, a film as one picture per frame, curves.
import { element } from "./dom";
import { Legend, paint } from "./legend";
import { ZipEntry, zip } from "./zip";

export function save(blob: Blob, name: string): void {
  const address = URL.createObjectURL(blob);
  element("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000); // the download has begun by then
}

/** The part of a file's name that says which run it is of. */
export function plainName(title: string): string {
  return title.replace(/[^A-Za-z0-9]+/g, "_").replace(/^_+|_+$/g, "").slice(0, 60) || "report";
}

/** What is painted on the 3-D view: title, time and legends. Sizes are those of the screen. */
export interface Overlay {
  title: string;
  time: string;
  legends: Legend[];
  triad: SVGElement;
}

async function pictureOf(svg: SVGElement): Promise<HTMLImageElement> {
  const copy = svg.cloneNode(true) as SVGElement;
  const [from, to] = [svg, copy].map((each) => [each, ...each.querySelectorAll("*")]);
  from.forEach((each, k) => {
    const { stroke, strokeWidth, fill, fontSize, fontFamily, textAnchor, dominantBaseline } = getComputedStyle(each);
    Object.assign((to[k] as SVGElement).style, { stroke, strokeWidth, fill, fontSize, fontFamily, textAnchor, dominantBaseline });
  });
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(copy.outerHTML)}`;
  await image.decode();
  return image;
}

/** The view with its legends as PNG; `view` has `ratio` pixels per one of the page, and is painted on. */
export async function pictureWith(view: HTMLCanvasElement, ratio: number, overlay: Overlay): Promise<Blob> {
  const context = view.getContext("2d")!;
  context.scale(ratio, ratio);
  const [wide, tall] = [view.width / ratio, view.height / ratio];
  const style = getComputedStyle(document.documentElement);
  const [paper, ink, faint] = ["--paper", "--ink", "--faint"].map((name) => style.getPropertyValue(name).trim());
  let top = 12;
  for (const legend of overlay.legends) top += 12 + paint(legend, context, wide - 12, top, { paper, ink });
  context.drawImage(await pictureOf(overlay.triad), 6, tall - 78, 72, 72);
  context.textAlign = "left";
  context.textBaseline = "top";
  context.fillStyle = ink;
  context.font = "600 14px system-ui, sans-serif";
  context.fillText(overlay.title, 12, 12, wide - 24);
  context.fillStyle = faint;
  context.font = "13px system-ui, sans-serif";
  context.fillText(overlay.time, 12, 32);
  return new Promise((resolve, reject) => view.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("The browser could not write the picture."))), "image/png"));
}

/** One picture per frame in a zip file; `frame` shows a frame and gives its picture, or undefined to stop. */
export async function film(frames: number, frame: (number: number) => Promise<Blob | undefined>): Promise<Blob | undefined> {
  const entries: ZipEntry[] = [];
  for (let k = 0; k < frames; ++k) {
    const picture = await frame(k);
    if (!picture) return undefined;
    entries.push({ name: `frame_${String(k).padStart(4, "0")}.png`, bytes: new Uint8Array(await picture.arrayBuffer()) });
  }
  return zip(entries);
}
