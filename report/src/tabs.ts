// The tabs of the pages beside the view.
import { element } from "./dom";

function select(tab: HTMLElement, shown: (page: HTMLElement) => void): void {
  for (const each of document.querySelectorAll<HTMLElement>("[role=tab]")) {
    const chosen = each === tab;
    each.setAttribute("aria-selected", String(chosen));
    each.tabIndex = chosen ? 0 : -1;
    const page = document.getElementById(each.getAttribute("aria-controls")!)!;
    page.hidden = !chosen;
    if (chosen) shown(page);
  }
}

/** `shown` is called with a page that becomes visible. Each page gets its title, which is seen on paper. */
export function bindTabs(shown: (page: HTMLElement) => void): void {
  const tabs = [...document.querySelectorAll<HTMLElement>("[role=tab]")];
  tabs.forEach((tab, k) => {
    document.getElementById(tab.getAttribute("aria-controls")!)!.prepend(element("h2", { className: "on-paper", textContent: tab.textContent }));
    tab.addEventListener("click", () => select(tab, shown));
    tab.addEventListener("keydown", (event) => {
      const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
      if (by === 0) return;
      let next = k;
      do next = (next + by + tabs.length) % tabs.length;
      while (tabs[next].hidden);
      event.stopPropagation();
      select(tabs[next], shown);
      tabs[next].focus();
    });
  });
}
