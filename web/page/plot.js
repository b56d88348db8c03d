// Curves and fields as SVG, drawn for the width at hand.

const NS = "http://www.w3.org/2000/svg";
function node(name, attributes, ...inside) {
  const made = name[0] === "<" ? document.createElementNS(NS, name.slice(1)) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes ?? {})) if (value !== undefined && value !== false) made.setAttribute(key, value);
  made.append(...inside);
  return made;
}

// Round numbers within a range, about `count` of them.
function ticks(low, high, count) {
  const power = 10 ** Math.floor(Math.log10((high - low) / count));
  const step = power * [1, 2, 5, 10].find((n) => n * power >= (high - low) / count);
  const found = [];
  for (let i = Math.ceil(low / step - 1e-9); i <= high / step + 1e-9; i++) found.push(Number((i * step).toPrecision(12)));
  return found;
}

// Three or more digits, without powers of ten where they can be avoided; a minus as it is printed.
const digits = (value, count = 3) => {
  const size = Math.abs(value);
  const text = size !== 0 && (size < 1e-3 || size >= 1e6) ? value.toExponential(count - 1) : String(Number(value.toPrecision(count)));
  return (size >= 10 ** count && size < 1e6 ? value.toFixed(0) : text).replace("-", "−");
};

// Blue where the ground rises, brown where it sinks, white between: apart for every eye, and in grey by their depth of tone.
function colour(share) {
  const [end, t] = share > 0 ? [[122, 52, 4], Math.min(share, 1)] : [[8, 64, 129], Math.min(-share, 1)];
  return end.map((e) => Math.round(252 + (e - 252) * Math.sqrt(t)));
}

function picture({ values, columns, rows, largest }) {
  const canvas = node("canvas", { width: columns, height: rows });
  const context = canvas.getContext("2d"), data = context.createImageData(columns, rows);
  for (let j = 0; j < rows; j++) for (let i = 0; i < columns; i++) {
    data.data.set([...colour(values[(rows - 1 - j) * columns + i] / largest), 255], 4 * (j * columns + i));
  }
  context.putImageData(data, 0, 0);
  return canvas.toDataURL();
}

class Plot {
  constructor(figure) {
    this.figure = figure;
    new ResizeObserver(() => figure.clientWidth !== this.width && this.spec && this.draw(this.spec)).observe(figure);
  }

  draw(spec) {
    this.spec = spec;
    const { figure } = this;
    const width = (this.width = figure.clientWidth), narrow = width < 480;
    // while a print is laid out there is none
    if (width < 100) return;
    const frame = { left: 54, right: width - 14, top: spec.x.second ? 44 : 26 };
    frame.bottom = frame.top + (spec.equal ? ((frame.right - frame.left) * (spec.y.to - spec.y.from)) / (spec.x.to - spec.x.from) : narrow ? 190 : 230);
    const height = frame.bottom + 46;
    const place = (low, high, first, last) => (value) => first + ((value - low) / (high - low)) * (last - first);
    const px = place(spec.x.from, spec.x.to, frame.left, frame.right);
    const py = spec.y.down ? place(spec.y.from, spec.y.to, frame.top, frame.bottom) : place(spec.y.from, spec.y.to, frame.bottom, frame.top);
    const svg = node("<svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": `${spec.title}. ${spec.told ?? ""}`, width, height });
    const text = (x, y, said, attributes) => svg.append(node("<text", { x, y, ...attributes }, said));
    if (spec.field) svg.append(this.image(spec, frame));
    for (const value of ticks(spec.x.from, spec.x.to, narrow ? 5 : 8)) {
      svg.append(node("<path", { class: "grid", d: `M${px(value)} ${frame.top}V${frame.bottom}` }));
      text(px(value), frame.bottom + 17, digits(value), { "text-anchor": "middle" });
    }
    for (const value of ticks(spec.y.from, spec.y.to, 5)) {
      svg.append(node("<path", { class: "grid", d: `M${frame.left} ${py(value)}H${frame.right}` }));
      text(frame.left - 7, py(value) + 4, digits(value), { "text-anchor": "end" });
    }
    if (spec.x.second) {
      const { factor, label } = spec.x.second;
      for (const value of ticks(spec.x.from * factor, spec.x.to * factor, narrow ? 4 : 8)) {
        const x = px(value / factor);
        svg.append(node("<path", { class: "tick", d: `M${x} ${frame.top}v-5` }));
        text(x, frame.top - 9, digits(value), { "text-anchor": "middle" });
      }
      text(frame.right, 14, label, { "text-anchor": "end", class: "axis" });
    }
    svg.append(node("<path", { class: "frame", d: `M${frame.left} ${frame.top}H${frame.right}V${frame.bottom}H${frame.left}Z` }));
    text(frame.right, height - 10, spec.x.label, { "text-anchor": "end", class: "axis" });
    text(0, 14, spec.y.label, { class: "axis" });
    this.marks(spec, svg, px, frame);
    for (const [i, { x, y, dash, dots }] of (spec.series ?? []).entries()) {
      if (dots) {
        x.forEach((value, n) => svg.append(node("<circle", { cx: px(value), cy: py(y[n]), r: 5, class: `series s${i}` })));
        continue;
      }
      let d = "", pen = "M";
      x.forEach((value, n) => {
        // what is not there, or not in the frame, leaves a gap
        const there = y[n] !== null && y[n] >= spec.y.from && y[n] <= spec.y.to && value >= spec.x.from && value <= spec.x.to;
        if (!there) return (pen = "M");
        d += `${pen}${px(value).toFixed(1)} ${py(y[n]).toFixed(1)}`;
        pen = "L";
      });
      svg.append(node("<path", { d, class: `series s${i}`, "stroke-dasharray": dash }));
    }
    const told = node("p", { class: "told" }, spec.told ?? "");
    figure.replaceChildren(node("figcaption", {}, spec.title), this.legend(spec), svg, told);
    this.readout(spec, svg, told, { px, frame });
  }

  image({ field, x, y, equal }, frame) {
    return node("<image", {
      href: picture(field), x: frame.left, y: frame.top, width: frame.right - frame.left, height: frame.bottom - frame.top, preserveAspectRatio: "none",
    });
  }

  marks({ marks = [], x }, svg, px, frame) {
    const there = marks.filter((mark) => mark.at >= x.from && mark.at <= x.to);
    there.forEach(({ at, name }, i) => {
      const right = px(at) > 0.6 * frame.right;
      svg.append(node("<path", { class: "mark", d: `M${px(at)} ${frame.top}V${frame.bottom}` }));
      svg.append(node("<text", { class: "halo", x: px(at) + (right ? -6 : 6), y: frame.top + 16 + 17 * i, "text-anchor": right ? "end" : "start" }, name));
    });
  }

  legend({ series = [], field }) {
    const entry = ({ name, dash, dots }, i) => node("span", { class: "key" },
      node("<svg", { width: 26, height: 10, "aria-hidden": "true" },
        dots ? node("<circle", { cx: 13, cy: 5, r: 4, class: `series s${i}` })
          : node("<path", { d: "M0 5H26", class: `series s${i}`, "stroke-dasharray": dash })), name);
    const legend = node("p", { class: "legend" }, ...series.map((one, i) => (one.name ? entry(one, i) : "")));
    if (field) {
      const stops = [-1, -0.5, -0.2, 0, 0.2, 0.5, 1].map((share) => `rgb(${colour(share)})`);
      legend.append(`${digits(field.largest * field.scale, 2)} ${field.unit} up`, node("i", { class: "bar", style: `background: linear-gradient(90deg, ${stops})` }),
        `${digits(field.largest * field.scale, 2)} ${field.unit} down`);
    }
    return legend;
  }

  // The values under the pointer, of the nearest abscissa.
  readout(spec, svg, told, { px, frame }) {
    if (!spec.read) return;
    const line = node("<path", { class: "pointer" });
    svg.append(line);
    svg.addEventListener("pointermove", (event) => {
      const box = svg.getBoundingClientRect();
      const share = (event.clientX - box.left - frame.left) / (frame.right - frame.left);
      if (share < 0 || share > 1) return;
      const rise = (frame.bottom - (event.clientY - box.top)) / (frame.bottom - frame.top);
      const [at, said] = spec.read(spec.x.from + share * (spec.x.to - spec.x.from), spec.y.from + rise * (spec.y.to - spec.y.from));
      line.setAttribute("d", `M${px(at)} ${frame.top}V${frame.bottom}`);
      told.textContent = said;
    });
    svg.addEventListener("pointerleave", () => {
      line.removeAttribute("d");
      told.textContent = spec.told ?? "";
    });
  }
}

// Index of the value nearest to `wanted`.
const nearest = (values, wanted) => values.reduce((best, value, i) => (Math.abs(value - wanted) < Math.abs(values[best] - wanted) ? i : best), 0);
