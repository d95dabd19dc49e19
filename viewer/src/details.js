// What is known of the thing under the pointer (a tip) and of the thing that was chosen (a card).
import {grouped, make, short} from "./dom.js";

const kindName = {I: "I bead", generic: "generic bead", annular: "annular bead"};

export class Details {
  constructor(stage, host, close) {
    this.stage = stage;
    this.tip = make("div", {class: "tip", role: "tooltip", hidden: true});
    this.card = make("aside", {class: "card", "aria-live": "polite", "aria-label": "Chosen", hidden: true});
    this.close = close;
    host.append(this.tip, this.card);
  }

  #region(bead, numbers) {
    const found = this.stage.scene.beadById.get(bead);
    const face = numbers.length > 1 ? `${numbers.length} faces` : `face ${numbers[0]}`;
    return found ? `bead ${bead}, ${found.shape} (${kindName[found.kind]}), ${face}` : `sheet, ${face}`;
  }

  /** @param {{element?: number, face?: number} | null} what */
  showTip(what, x, y) {
    this.tip.hidden = !what;
    if (!what) return;
    const {mesh, faces} = this.stage.scene, measure = this.stage.coloring?.measure;
    const lines = [];
    if (what.element !== undefined) {
      const value = measure?.values[what.element];
      if (measure) lines.push(make("b", {}, `${measure.name} ${Number.isNaN(value) ? "–" : short(value)}${measure.unit && ` ${measure.unit}`}`));
      lines.push(`element ${what.element + 1}`, this.#region(mesh.bead[what.element], [mesh.face[what.element]]));
    } else {
      lines.push(this.#region(faces[what.face].bead, faces[what.face].numbers));
    }
    this.tip.replaceChildren(...lines.map((line) => make("div", {}, line)));
    const {clientWidth: width, clientHeight: height} = this.tip.parentElement;
    this.tip.style.left = `${Math.min(x + 14, width - this.tip.offsetWidth - 6)}px`;
    this.tip.style.top = `${y + 18 + this.tip.offsetHeight > height ? y - this.tip.offsetHeight - 10 : y + 18}px`;
  }

  /** At the left, or at the right where the pointer is there: it must not come under a double click. */
  showCard(what, at = null) {
    this.card.hidden = !what;
    if (!what) return;
    this.card.classList.toggle("right", at !== null && at[0] < this.card.parentElement.clientWidth / 2);
    const rows = what.element !== undefined ? this.#elementRows(what.element)
        : what.bead !== undefined ? this.#beadRows(what.bead) : this.#faceRows(what.face);
    this.card.replaceChildren(
        make("button", {class: "close", "aria-label": "Close", title: "Close (Esc)", onclick: () => this.close()}, "×"),
        make("h3", {}, rows.title),
        make("dl", {}, ...rows.pairs.flatMap(([name, value, bad]) =>
            [make("dt", {}, name), make("dd", {class: bad ? "fails" : null}, value)])));
  }

  /** Pixels that it takes at the left. */
  get covers() {
    if (this.card.hidden || this.card.classList.contains("right")) return 0;
    return Math.min(this.card.offsetWidth + 12, this.card.parentElement.clientWidth / 2);
  }

  #elementRows(e) {
    const {mesh} = this.stage.scene, corners = [...mesh.corners.subarray(4 * e, 4 * e + 4)];
    const isTriangle = corners[2] === corners[3];
    if (isTriangle) corners.pop();
    const pairs = [["in", this.#region(mesh.bead[e], [mesh.face[e]])], ["nodes", corners.map((n) => n + 1).join(", ")]];
    for (const measure of mesh.measures) {
      const value = measure.values[e];
      if (Number.isNaN(value)) continue;
      const bad = measure.failing.includes(e);
      pairs.push([measure.name, `${short(value)}${measure.unit && ` ${measure.unit}`}${bad ? " ✗" : ""}`, bad]);
    }
    return {title: `${isTriangle ? "Triangle" : "Quad"} ${e + 1}`, pairs};
  }

  #beadRows(id) {
    const row = document.querySelector(`#beads tr[data-bead="${id}"]`);
    const heads = [...(row?.closest("table").tHead.rows[0].cells ?? [])];
    const pairs = heads.map((head, k) => [head.textContent, row.cells[k].textContent.trim()])
        .filter(([name, value]) => value && name !== "id" && name !== "kind" && name !== "shape");
    const bead = this.stage.scene.beadById.get(id);
    return {title: `Bead ${id}: ${bead.shape}, ${kindName[bead.kind]}`, pairs};
  }

  #faceRows(index) {
    const {numbers, bead} = this.stage.scene.faces[index];
    const reason = [...document.querySelectorAll(`#faces tr[data-face="${numbers[0]}"] td`)].at(-1)?.textContent;
    const elements = this.stage.elementsOf({face: index}).length;
    const pairs = [];
    if (numbers.length > 1) pairs.push(["made of faces", numbers.join(", ")]);
    if (bead) pairs.push(["bead", String(bead)]);
    if (reason) pairs.push(["no bead, since", reason]);
    if (elements) pairs.push(["elements", grouped(elements)]);
    return {title: `Face ${numbers[0]}`, pairs};
  }
}
