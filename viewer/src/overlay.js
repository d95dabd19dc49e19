// Labels of beads, the scale bar and the axes: drawn flat over the picture, so that letters stay crisp.

/** 1, 2 or 5 times a power of ten, at most `length`. */
function roundLength(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return power * [5, 2, 1].find((m) => m * power <= length * 1.0000001);
}

export class Overlay {
  constructor(host) {
    this.canvas = document.createElement("canvas");
    this.canvas.className = "overlay";
    this.canvas.setAttribute("aria-hidden", "true");
    this.context = this.canvas.getContext("2d");
    host.append(this.canvas);
  }

  resize(width, height, ratio) {
    this.width = width, this.height = height, this.ratio = ratio;
    this.canvas.width = Math.round(width * ratio), this.canvas.height = Math.round(height * ratio);
  }

  draw(stage) {
    const c = this.context;
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.clearRect(0, 0, this.width, this.height);
    this.theme = stage.theme;
    if (stage.visible.labels) this.#labels(stage);
    this.#scaleBar(stage.rig);
    this.#axes(stage.rig);
  }

  #text(text, x, y) {
    const c = this.context;
    c.lineWidth = 3.5, c.lineJoin = "round";
    c.strokeStyle = this.theme.halo, c.fillStyle = this.theme.ink;
    c.strokeText(text, x, y);
    c.fillText(text, x, y);
  }

  /** The chosen bead first, then in the order of the table; what would cover another label is left out. */
  #labels({scene, rig, chosen}) {
    const c = this.context, taken = [];
    c.font = "600 12px system-ui, sans-serif";
    c.textAlign = "center", c.textBaseline = "middle";
    const beads = [...scene.beads].sort((a, b) => (b.id === chosen?.bead) - (a.id === chosen?.bead));
    for (const bead of beads) {
      const [x, y] = rig.project(bead.at), text = `${bead.id} ${bead.shape}`, half = c.measureText(text).width / 2 + 4;
      if (x < -half || y < -10 || x > this.width + half || y > this.height + 10) continue;
      if (taken.some((t) => Math.abs(t[0] - x) < t[2] + half && Math.abs(t[1] - y) < 17)) continue;
      taken.push([x, y, half]);
      this.#text(text, x, y);
    }
  }

  #scaleBar(rig) {
    const c = this.context, length = roundLength(130 * rig.pixel), pixels = length / rig.pixel;
    const right = this.width - 18, y = this.height - 16;
    c.font = "12px system-ui, sans-serif";
    c.textAlign = "center", c.textBaseline = "alphabetic";
    c.strokeStyle = this.theme.ink, c.lineWidth = 1.5;
    c.beginPath();
    c.moveTo(right - pixels, y - 5), c.lineTo(right - pixels, y), c.lineTo(right, y), c.lineTo(right, y - 5);
    c.stroke();
    this.#text(`${Number(length.toPrecision(3))} mm`, right - pixels / 2, y - 7);
  }

  #axes(rig) {
    const c = this.context, {right, up, eye} = rig.frame(), x0 = 40, y0 = this.height - 40, size = 26;
    c.font = "600 11px system-ui, sans-serif";
    c.textAlign = "center", c.textBaseline = "middle";
    const colors = ["#d55e00", "#009e73", "#3d8fd1"];
    const order = [0, 1, 2].sort((a, b) => eye[a] - eye[b]);
    for (const k of order) {
      const x = x0 + right[k] * size, y = y0 - up[k] * size;
      c.strokeStyle = colors[k], c.lineWidth = 2;
      c.beginPath();
      c.moveTo(x0, y0), c.lineTo(x, y);
      c.stroke();
      this.#text("XYZ"[k], x0 + right[k] * (size + 9), y0 - up[k] * (size + 9));
    }
  }
}
