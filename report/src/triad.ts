// The directions of the axes, in a corner of the view.
import { Matrix4 } from "three";

export function drawTriad(home: Element, toCamera: Matrix4): void {
  const { elements } = toCamera;
  const parts = [0, 1, 2].map((axis) => {
    const [x, y, depth] = [elements[4 * axis], elements[4 * axis + 1], elements[4 * axis + 2]];
    const name = "xyz"[axis];
    return { depth, svg: `<g class="axis-${name}"><line x2="${24 * x}" y2="${-24 * y}"/><text x="${33 * x}" y="${-33 * y}">${name}</text></g>` };
  });
  home.innerHTML = parts
    .sort((a, b) => a.depth - b.depth)
    .map(({ svg }) => svg)
    .join("");
}
