// The tables: tabs, sorting, filters, and the way from a row to the picture.
import {make} from "./dom.js";

const numeric = new Intl.Collator("en", {numeric: true, sensitivity: "base"});

/** Numbers are sorted as numbers ("1,234", "≥ 2.5", "–" last), the rest as people read it. */
function keyOf(cell) {
  const text = cell?.textContent.trim() ?? "";
  if (!cell?.classList.contains("number")) return text;
  const number = parseFloat(text.replaceAll(",", "").replace(/^[^\d+-]*/, ""));
  return Number.isNaN(number) ? Infinity : number;
}

function compare(a, b) {
  if (typeof a === "number" && typeof b === "number") return a === b ? 0 : a - b;
  return numeric.compare(String(a), String(b));
}

function makeSortable(table) {
  const heads = [...table.tHead.rows[0].cells], body = table.tBodies[0];
  heads.forEach((head, column) => {
    const sort = () => {
      const order = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
      heads.forEach((other) => other.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", order === 1 ? "ascending" : "descending");
      const rows = [...body.rows].map((row) => ({row, key: keyOf(row.cells[column])}));
      rows.sort((a, b) => order * compare(a.key, b.key));
      body.append(...rows.map(({row}) => row));
    };
    head.replaceChildren(make("button", {onclick: sort, title: head.title || null}, ...head.childNodes));
    head.removeAttribute("title");
  });
}

/** What a row is about: {bead}, {face} (number in the file) or {element}; null for nothing. */
export function subjectOf(row) {
  const {bead, face, element} = row.dataset;
  if (element !== undefined) return {element: Number(element)};
  if (bead !== undefined) return {bead: Number(bead)};
  if (face !== undefined) return {number: Number(face)};
  return null;
}

export class Tables {
  /**
   * @param {HTMLElement} host the sections that the program has written
   * @param {{go: (subject: object) => void, point: (subject: object | null) => void}} reactions
   */
  constructor(host, reactions) {
    this.host = host;
    this.reactions = reactions;
    this.sections = [...host.querySelectorAll(":scope > section")];
    this.tabs = make("div", {role: "tablist", class: "tabs", "aria-label": "Tables"});
    this.tools = make("div", {class: "table-tools"});
    host.prepend(make("div", {class: "dock-bar"}, this.tabs, this.tools));
    this.sections.forEach((section) => this.#tab(section));
    for (const table of host.querySelectorAll("table.sortable")) makeSortable(table), this.#link(table);
    this.open(this.sections.find((s) => s.id === "beads") ?? this.sections[0]);
  }

  #tab(section) {
    const heading = section.querySelector("h2"), count = section.dataset.count;
    const bad = section.id === "quality" && Number(count) > 0;
    const tab = make("button", {role: "tab", id: `tab-${section.id}`, "aria-controls": section.id, class: bad ? "bad" : null,
                                onclick: () => this.open(section)}, heading.textContent,
                     count === undefined ? null : make("small", {}, section.id === "quality" ? (bad ? `${count} ✗` : "✓") : count));
    tab.addEventListener("keydown", (event) => {
      const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
      if (!step) return;
      event.preventDefault();
      const next = this.sections[(this.sections.indexOf(section) + step + this.sections.length) % this.sections.length];
      this.open(next);
      next.tab.focus();
    });
    section.tab = tab;
    section.setAttribute("role", "tabpanel");
    section.setAttribute("aria-labelledby", tab.id);
    const table = section.querySelector("table");
    if (table) section.tools = this.#filters(section, table);
    this.tabs.append(tab);
  }

  #filters(section, table) {
    const text = make("input", {type: "search", placeholder: "Filter", "aria-label": `Filter ${section.querySelector("h2").textContent}`,
                                oninput: () => apply()});
    const found = make("span", {class: "quiet", role: "status"});
    const tools = [text, found];
    let kind = null;
    if (section.id === "beads") {
      const names = [...new Set([...table.tBodies[0].rows].map((row) => row.cells[1].textContent))].sort();
      kind = make("select", {"aria-label": "Kind", onchange: () => apply()}, make("option", {value: ""}, "all kinds"),
                  ...names.map((name) => make("option", {value: name}, name)));
      tools.unshift(kind);
    }
    const apply = () => {
      const words = text.value.toLowerCase().split(/\s+/).filter(Boolean);
      let shown = 0;
      for (const row of table.tBodies[0].rows) {
        const content = row.textContent.toLowerCase();
        row.hidden = !words.every((word) => content.includes(word)) || Boolean(kind?.value && row.cells[1].textContent !== kind.value);
        shown += !row.hidden;
      }
      const all = table.tBodies[0].rows.length;
      found.textContent = shown === all ? "" : `${shown} of ${all}`;
      this.reactions.filtered?.(section.id, table);
    };
    return tools;
  }

  #link(table) {
    for (const row of table.tBodies[0].rows) {
      const subject = subjectOf(row);
      if (!subject) continue;
      row.tabIndex = 0;
      row.classList.add("linked");
      row.addEventListener("click", () => {
        if (!String(getSelection())) this.reactions.go(subject);
      });
      row.addEventListener("keydown", (event) => {
        if (event.key === "Enter" || event.key === " ") {
          event.preventDefault();
          this.reactions.go(subject);
        }
        const step = {ArrowDown: 1, ArrowUp: -1}[event.key];
        if (!step) return;
        event.preventDefault();
        let next = row;
        do next = step > 0 ? next.nextElementSibling : next.previousElementSibling;
        while (next && (next.hidden || next.tabIndex < 0));
        next?.focus();
      });
      row.addEventListener("mouseenter", () => this.reactions.point(subject));
      row.addEventListener("mouseleave", () => this.reactions.point(null));
      row.addEventListener("focus", () => this.reactions.point(subject));
      row.addEventListener("blur", () => this.reactions.point(null));
    }
  }

  open(section) {
    for (const other of this.sections) {
      const on = other === section;
      other.classList.toggle("open", on);
      other.tab.setAttribute("aria-selected", String(on));
      other.tab.tabIndex = on ? 0 : -1;
    }
    this.tools.replaceChildren(...(section.tools ?? []));
    this.current = section;
  }

  openById(id) {
    const section = this.sections.find((s) => s.id === id);
    if (section) this.open(section);
    return section;
  }

  focusFilter() { this.tools.querySelector("input[type=search]")?.focus(); }

  /** The browser's own way to empty the field tells nobody of it when the field loses the focus. */
  clearFilter() {
    const field = this.tools.querySelector("input[type=search]");
    if (!field) return;
    field.value = "";
    field.dispatchEvent(new Event("input"));
  }

  /** Marks the row of what has been chosen, and brings it into sight. */
  mark(selector, scroll) {
    for (const row of this.host.querySelectorAll("tr.chosen")) row.classList.remove("chosen"), row.removeAttribute("aria-current");
    if (!selector) return;
    for (const row of this.host.querySelectorAll(selector)) {
      row.classList.add("chosen");
      row.setAttribute("aria-current", "true");
      if (scroll && this.current?.contains(row)) row.scrollIntoView({block: "nearest"});
    }
  }
}
