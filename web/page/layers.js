// The ground as cards: one for each layer, to drag, and one for what lies below.

const SLOWEST = 20, FASTEST = 1000; // m/s, ends of the slider
const FIELDS = {
  thickness: ["Thickness", "m", "thickness"],
  poisson: ["Poisson ν", "", "poisson"],
  density: ["Density", "kg/m³", "density"],
  damping: ["Damping", "%", "damping_ratio"],
};

// A number of the program to four digits, what was typed as it is.
const short = (value) => (typeof value === "number" ? String(Number(value.toPrecision(4))) : value);
const along = (speed) => Math.round((1000 * Math.log(speed / SLOWEST)) / Math.log(FASTEST / SLOWEST));
const speedAt = (place) => Number((SLOWEST * (FASTEST / SLOWEST) ** (place / 1000)).toPrecision(3));

// Fields of one material at the key `path`, changing `material`.
function materialFields(name, path, material, keys, changed) {
  const field = (key, label, unit, spelt) => {
    const input = node("input", { inputmode: "decimal", "data-keys": `${path}.${spelt}`, "aria-label": `${name}: ${label}${unit && ` [${unit}]`}` });
    input.value = short(material[key]);
    input.oninput = () => ((material[key] = input.value), changed());
    return input;
  };
  const number = field("shear_speed", "shear wave speed", "m/s", "shear_speed");
  const slider = node("input", { type: "range", min: 0, max: 1000, "aria-label": `${name}: shear wave speed, slider` });
  const follow = () => {
    const speed = Number(material.shear_speed);
    if (speed > 0) slider.value = along(speed);
    slider.setAttribute("aria-valuetext", `${short(material.shear_speed)} m/s`);
  };
  slider.oninput = () => {
    material.shear_speed = speedAt(Number(slider.value));
    number.value = short(material.shear_speed);
    follow();
    changed(true);
  };
  number.addEventListener("input", follow);
  follow();
  const labelled = (key) => {
    const [label, unit, spelt] = FIELDS[key];
    return node("label", { class: "small" }, label, node("span", { class: "unit" }, field(key, label, unit, spelt), ` ${unit}`));
  };
  return [
    node("div", { class: "slide" }, node("span", { "aria-hidden": "true" }, "c", node("sub", {}, "s")), slider, node("span", { class: "unit" }, number, " m/s")),
    node("div", { class: "row" }, ...keys.map(labelled)),
  ];
}

class Layers {
  constructor(list, base, changed) {
    Object.assign(this, { list, base, changed });
  }

  show(ground) {
    this.ground = ground;
    this.list.replaceChildren(...ground.layers.map((layer, i) => this.card(layer, i)));
    this.showBase();
  }

  card(layer, i) {
    const name = `Layer ${i + 1}`, path = `soil.layer[${i}]`;
    const handle = node("button", { type: "button", class: "handle", "aria-label": `${name}: move with the arrow keys, or drag`, title: "drag, or arrow keys" }, "⠿");
    const remove = node("button", { type: "button", class: "remove", "aria-label": `Delete layer ${i + 1}`, title: "delete" }, "✕");
    const card = node("li", { class: "layer", "data-keys": path }, node("div", { class: "head" }, handle, node("b", {}, layer.name ? `${name}: ${layer.name}` : name), remove),
      ...materialFields(name, path, layer, ["thickness", "poisson", "density", "damping"], this.changed));
    remove.onclick = () => this.edit((layers) => layers.splice(i, 1));
    handle.onkeydown = (event) => {
      const to = i + { ArrowUp: -1, ArrowDown: 1 }[event.key];
      if (!(to >= 0 && to < this.ground.layers.length)) return;
      event.preventDefault();
      this.move(i, to);
      this.list.children[to].querySelector(".handle").focus();
    };
    handle.onpointerdown = (event) => this.drag(event, handle, card, i);
    return card;
  }

  // Neighbours change places with the card as the pointer passes their middle; the card stays in the document, or it would lose the pointer.
  drag(event, handle, card, from) {
    handle.setPointerCapture(event.pointerId);
    card.classList.add("dragged");
    handle.onpointermove = ({ clientY }) => {
      const middle = (other) => other.getBoundingClientRect().top + other.offsetHeight / 2;
      const { previousElementSibling: above, nextElementSibling: below } = card;
      if (above && clientY < middle(above)) card.after(above);
      else if (below && clientY > middle(below)) card.before(below);
    };
    handle.onpointerup = handle.onpointercancel = () => {
      handle.onpointermove = null;
      this.move(from, [...this.list.children].indexOf(card));
    };
  }

  move(from, to) {
    this.edit((layers) => layers.splice(to, 0, layers.splice(from, 1)[0]));
  }

  edit(change) {
    change(this.ground.layers);
    this.show(this.ground);
    this.changed();
  }

  add() {
    const { layers, base } = this.ground;
    const like = layers.at(-1) ?? (base === "rigid" ? {} : base);
    this.edit(() => layers.push({ thickness: 2, shear_speed: 100, poisson: 0.35, density: 1800, damping: 3, ...like, name: undefined }));
    this.list.lastElementChild.querySelector("input").focus();
  }

  showBase() {
    const { base } = this.ground;
    const choice = (value, label) => {
      const input = node("input", { type: "radio", name: "base" });
      input.checked = (base === "rigid") === (value === "rigid");
      input.onchange = () => {
        if (base !== "rigid") this.last = base;
        this.ground.base = value === "rigid" ? value : this.last ?? { shear_speed: 200, poisson: 0.35, density: 1900, damping: 3 };
        this.showBase();
        this.base.querySelector("input:checked").focus();
        this.changed();
      };
      return node("label", { class: "choice" }, input, label);
    };
    const head = node("div", { class: "head" }, node("b", {}, "Below"), choice("half-space", "half-space"), choice("rigid", "rock"));
    const fields = base === "rigid" ? [] : materialFields("Half-space", "soil.half_space", base, ["poisson", "density", "damping"], this.changed);
    this.base.replaceChildren(head, ...fields);
  }
}
