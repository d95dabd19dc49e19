// What stands in where there is no WebGL: the flat picture, which can be moved and zoomed.
import {make} from "./dom.js";
import {unpackedText} from "./scene_data.js";

function makeMovable(svg) {
  const home = svg.getAttribute("viewBox").split(" ").map(Number);
  let box = [...home], last = null;
  svg.removeAttribute("width");
  svg.removeAttribute("height");
  const show = () => svg.setAttribute("viewBox", box.join(" "));
  const perPixel = () => Math.max(box[2] / svg.clientWidth, box[3] / svg.clientHeight);
  const zoom = (factor, x = box[0] + box[2] / 2, y = box[1] + box[3] / 2) => {
    const width = Math.min(home[2] * 4, Math.max(home[2] / 400, box[2] * factor)), f = width / box[2];
    box = [x - (x - box[0]) * f, y - (y - box[1]) * f, width, box[3] * f];
    show();
  };
  const reset = () => {
    box = [...home];
    show();
  };
  svg.addEventListener("wheel", (event) => {
    event.preventDefault();
    const r = svg.getBoundingClientRect(), s = perPixel();
    zoom(Math.exp(event.deltaY * 0.0015), box[0] + box[2] / 2 + (event.clientX - r.left - r.width / 2) * s,
         box[1] + box[3] / 2 + (event.clientY - r.top - r.height / 2) * s);
  }, {passive: false});
  svg.addEventListener("pointerdown", (event) => {
    last = [event.clientX, event.clientY];
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener("pointermove", (event) => {
    if (!last) return;
    const s = perPixel();
    box[0] -= (event.clientX - last[0]) * s, box[1] -= (event.clientY - last[1]) * s;
    last = [event.clientX, event.clientY];
    show();
  });
  for (const name of ["pointerup", "pointercancel"]) svg.addEventListener(name, () => { last = null; });
  const button = (name, text, run) => make("button", {title: name, "aria-label": name, onclick: run}, text);
  return make("div", {class: "toolbar", role: "toolbar", "aria-label": "Picture"}, button("Zoom in", "+", () => zoom(0.7)),
              button("Zoom out", "−", () => zoom(1 / 0.7)), button("Show all", "Fit", reset));
}

/** @param {HTMLElement} host @param {string} reason why there is no 3-D picture */
export async function showFlatPicture(host, reason) {
  const packed = document.getElementById("flat-picture");
  host.append(make("p", {class: "notice", role: "status"}, packed ? `No 3-D view: ${reason}. This is the flat picture.`
                                                                 : `No 3-D view: ${reason}. The tables below hold all results.`));
  if (!packed) return;
  const holder = make("div", {class: "flat"});
  holder.innerHTML = await unpackedText(packed.textContent);
  host.append(holder, makeMovable(holder.querySelector("svg")));
}
