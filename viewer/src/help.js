// The list of keys.
import {make} from "./dom.js";
import {views} from "./camera_rig.js";
import {layers} from "./layers.js";

const groups = () => [
  ["Mouse and touch", [["drag", "turn"], ["shift or right button, drag", "move"], ["wheel, pinch", "zoom"],
                       ["click", "choose an element; its bead on double click"]]],
  ["Picture", [["← ↑ → ↓", "turn (picture has the focus)"], ["shift and arrows", "move"], ["+ −", "zoom"], ["F", "show all"],
               ["Z", "zoom to what is chosen"], ["Esc", "nothing chosen"],
               ...Object.values(views).map((view) => [view.key, `view: ${view.name.toLowerCase()}`])]],
  ["Layers", layers.map((layer) => [layer.key.toUpperCase(), layer.name.toLowerCase()])],
  ["Tables", [["/", "filter"], ["[ ]", "bead before, next bead"], ["↑ ↓", "row before, next row"], ["Enter", "zoom to the row's bead, face or element"],
              ["?", "this list"]]],
];

export function makeHelp() {
  const dialog = make("dialog", {class: "help", "aria-label": "Keys"},
      make("form", {method: "dialog"}, make("button", {class: "close", "aria-label": "Close"}, "×")),
      make("h2", {}, "Keys"),
      make("div", {class: "columns"}, ...groups().map(([name, rows]) =>
          make("section", {}, make("h3", {}, name), make("dl", {}, ...rows.flatMap(([key, what]) =>
              [make("dt", {}, make("kbd", {}, key)), make("dd", {}, what)]))))));
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  document.body.append(dialog);
  return dialog;
}
