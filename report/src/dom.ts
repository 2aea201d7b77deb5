/** Creates an element with properties and children. */
export function element<Name extends keyof HTMLElementTagNameMap>(name: Name, properties: object = {}, ...inside: (Node | string)[]): HTMLElementTagNameMap[Name] {
  const out = document.createElement(name);
  Object.assign(out, properties);
  out.append(...inside);
  return out;
}
