// Values under the pointer, zoom, curves to hide and numbers to copy, over the pictures as they stand. Each figure tells its axes
// and numbers in a JSON element; without this script, and in print, the report shows the pictures whole.
"use strict";
(() => {
  // Numbers of `size` bytes: deflated, all first bytes before all second ones.
  const unpack = async (text, size) => {
    const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    const count = bytes.length / size;
    return Uint8Array.from(bytes, (_, i) => bytes[(i % size) * count + Math.floor(i / size)]).buffer;
  };
  // 16-bit differences along each row → values (y, x).
  const unpackField = async (field) => {
    const codes = new Uint16Array(await unpack(field.numbers, 2));
    return codes.map((code, i) => (codes[i] = code + (i % field.x.length ? codes[i - 1] : 0)));
  };
  const plain = (value) => String(value).replace("-", "−").replace(/e\+?(.+)$/, (_, power) =>
    `·10${[...power].map((digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit] ?? "⁻").join("")}`).replace(/^1·/, "");
  const digits = (value, count) => Number(value.toPrecision(count));
  // Name and unit of a label such as `x′ [m], travel to the right`.
  const parts = (label) => label.match(/^([^[]*)(?:\[([^\]]*)\])?/).slice(1).map((part) => (part ?? "").trim());
  const measure = (label, value) => {
    const [name, unit] = parts(label);
    return `${name} ${plain(value)} ${/^[-–1]?$/.test(unit) ? "" : unit}`.trim();
  };
  // Ticks at 1, 2 or 5 times a power of ten, about eight; within a range of many decades the powers.
  const ticks = (low, high, log) => {
    const found = [];
    if (log && high / low >= 10) {
      for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); power++)
        for (const digit of high / low < 1e3 ? [1, 2, 5] : [1]) found.push(digits(digit * 10 ** power, 2));
    } else {
      const raw = (high - low) / 8, power = 10 ** Math.floor(Math.log10(raw));
      const step = power * [1, 2, 5, 10].find((factor) => factor * power >= raw);
      for (let i = Math.ceil(low / step); i <= high / step; i++) found.push(digits(i * step, 12));
    }
    return found.filter((value) => value >= low && value <= high);
  };

  const figure = async (element, told) => {
    const svg = element.querySelector("svg"), [left, top, right, bottom] = told.frame;
    const all = (selector) => [...svg.querySelectorAll(selector)];
    const set = (part, attributes) => Object.entries(attributes).forEach(([key, text]) => part.setAttribute(key, text));
    const make = (name, attributes, parent) => {
      const made = document.createElementNS(svg.namespaceURI, name);
      set(made, attributes);
      return parent ? parent.appendChild(made) : made;
    };
    const numbers = new Float32Array(await unpack(told.numbers, 4));
    const curves = told.curves.map(({ name, x, y, count }, i) => ({ name, start: x, x: numbers.subarray(x, x + count),
      y: numbers.subarray(y, y + count), group: all(".curve")[i], key: all(".key")[i], shown: true }));
    const field = told.field && { ...told.field, codes: await unpackField(told.field) };
    const plot = svg.querySelector(".plot"), kept = new Map();

    // The part of the frame that is shown [px of the page], and where values and pixels land.
    const whole = { x: [left, right], y: [top, bottom] };
    let view = structuredClone(whole);
    const between = ([first, last], [start, end], pixel) => start + ((pixel - first) / (last - first)) * (end - start);
    const bend = (axis, value) => (axis.log ? Math.log10(value) : value);
    const ends = (axis) => axis.range.map((end) => bend(axis, end));
    const drawn = (axis, value) => between(ends(axis), axis.pixels, bend(axis, value));
    const value = (axis, pixel) => {
      const bent = between(axis.pixels, ends(axis), pixel);
      return axis.log ? 10 ** bent : bent;
    };
    const zoomed = (way, pixel) => between(view[way], whole[way], pixel);
    const back = (way, pixel) => between(whole[way], view[way], pixel);
    const at = (way, number) => zoomed(way, drawn(told[way], number));
    for (const curve of curves) for (const way of ["x", "y"])
      curve[way + "Drawn"] = Float64Array.from(curve[way], (number) => drawn(told[way], number));
    const placeOf = (curve, i) => [zoomed("x", curve.xDrawn[i]), zoomed("y", curve.yDrawn[i])];

    // Redraws what depends on the view; the elements as they stood come back with the whole view.
    const path = (curve) => {
      let text = "", pen = "M";
      curve.x.forEach((_, i) => {
        const place = placeOf(curve, i);
        if (!place.every(Number.isFinite)) { pen = "M"; return; }
        text += pen + place.map((pixel) => Math.max(-1e4, Math.min(1e4, pixel)).toFixed(2)); pen = "L";
      });
      return text;
    };
    const retick = (group, way, factor, exponent) => {
      const label = group.querySelector("text"), line = label ? label.previousElementSibling : group.querySelector("path");
      if (!line) return;
      const range = view[way].map((pixel) => value(told[way], pixel) * factor).sort((a, b) => a - b);
      const [x, y] = line.getAttribute("d").match(/-?[\d.]+/g).map(Number), from = way === "x" ? x : y;
      group.replaceChildren(...ticks(...range, told[way].log).flatMap((tick) => {
        const away = at(way, tick / factor) - from;
        return [line, label].filter(Boolean).map((template) => {
          const copy = template.cloneNode(true);
          copy.setAttribute("transform", way === "x" ? `translate(${away},0)` : `translate(0,${away})`);
          if (template === label) copy.textContent = plain(digits(tick / 10 ** exponent, 9));
          return copy;
        });
      }));
    };
    const clip = make("clipPath", { id: `clip${++figure.count}` }, svg);
    make("rect", { x: left, y: top, width: right - left, height: bottom - top }, clip);
    const redraw = () => {
      const isWhole = ["x", "y"].every((way) => view[way].every((pixel, i) => pixel === whole[way][i]));
      kept.forEach((children, group) => group.replaceChildren(...children));
      all(".marker, .mark, .level, .plot > image").forEach((part) => part.removeAttribute("transform"));
      plot.removeAttribute("clip-path");
      if (isWhole) { kept.clear(); return; }
      const keep = (group) => { if (!kept.has(group)) kept.set(group, [...group.childNodes]); };
      const moved = (part, x, y) => part.setAttribute("transform", `translate(${x},${y})`);
      plot.setAttribute("clip-path", `url(#${clip.id})`);
      for (const curve of curves) {
        keep(curve.group);
        const lines = [...curve.group.querySelectorAll(":scope > path")];
        // a line with its rim is drawn by two pens
        const pens = new Map(lines.reverse().map((line) => [line.getAttribute("stroke"), line.cloneNode()]));
        lines.forEach((line) => line.remove());
        pens.forEach((pen) => { pen.setAttribute("d", path(curve)); curve.group.prepend(pen); });
        curve.group.querySelectorAll(".marker > *, :scope > circle").forEach((shape) => {
          const box = shape.getBBox(), x = box.x + box.width / 2, y = box.y + box.height / 2;
          moved(shape.closest(".marker") ?? shape, zoomed("x", x) - x, zoomed("y", y) - y);
        });
      }
      // first the lines of all, then their labels
      const away = (way, list, i) => { const value = list[i % list.length]; return at(way, value) - drawn(told[way], value); };
      all(".mark").forEach((part, i) => moved(part, away("x", told.marks, i), 0));
      all(".level").forEach((part, i) => moved(part, 0, away("y", told.levels, i)));
      const [across, down] = ["x", "y"].map((way) => zoomed(way, 1) - zoomed(way, 0));
      const matrix = `matrix(${across} 0 0 ${down} ${zoomed("x", 0)} ${zoomed("y", 0)})`;
      all(".plot > image").forEach((image) => image.setAttribute("transform", matrix));
      const renew = (group, ...rest) => { keep(group); retick(group, ...rest); };
      for (const way of ["x", "y"]) all(`.grid.${way}, .ticks.${way}`).forEach((group) => renew(group, way, 1, told[way].exponent));
      all(".ticks.second").forEach((group) => renew(group, "x", told.second.factor, told.second.exponent));
    };

    // The value nearest to a place of the page, told beside it.
    const tip = element.appendChild(document.createElement("div")), pointer = make("g", { class: "pointer" }, svg);
    set(tip, { class: "tip", role: "status", hidden: "" });
    const nearest = (values, way, pixel) => {
      const far = values.map((v) => Math.abs(at(way, v) - pixel));
      return far.indexOf(Math.min(...far));
    };
    const inView = (x, y) => x >= left - 1 && x <= right + 1 && y >= top - 1 && y <= bottom + 1;
    // Points of curves: those of the nearest band, all at the nearest abscissa, or, where curves turn back, the nearest one.
    const pointsAt = (x, y) => {
      const shown = curves.filter((curve) => curve.shown), bands = told.ticks;
      if (bands.length && shown.every((curve) => curve.x.length <= 2 * bands.length + 2)) {
        const centre = bands[nearest(bands.map(([value]) => value), "x", x)], place = at("x", centre[0]);
        // a point at the centre, or a step over it
        const inBand = (curve) => curve.x.findIndex((v, i) => Math.abs(at("x", v) - place) < 1 ||
          (v < centre[0] && curve.x[i + 1] > centre[0] && curve.y[i] === curve.y[i + 1]));
        return { here: centre[0], called: centre[1], points: shown.map((curve) => ({ curve, i: inBand(curve) })) };
      }
      const steady = !field && shown.every((curve) => curve.x.every((v, i) => !i || v >= curve.x[i - 1]));
      let best = { far: Infinity };
      for (const curve of shown) curve.x.forEach((_, i) => {
        const place = placeOf(curve, i);
        const far = steady ? Math.abs(place[0] - x) : Math.hypot(place[0] - x, place[1] - y);
        if (far < best.far && place.every(Number.isFinite) && inView(...place)) best = { far, curve, i };
      });
      if (!best.curve || (field && best.far > 8)) return { points: [] };
      const here = best.curve.x[best.i], index = (curve) => (curve.start === best.curve.start ? best.i : curve.x.indexOf(here));
      return { here, called: digits(here, 6), points: steady ? shown.map((curve) => ({ curve, i: index(curve) })) : [best] };
    };
    const tell = (x, y) => {
      const found = pointsAt(x, y), lines = [], places = [];
      const points = found.points.filter(({ curve, i }) => i >= 0 && Number.isFinite(curve.yDrawn[i]));
      if (points.length) {
        const second = told.second ? ` = ${plain(digits(found.here * told.second.factor, 5))} ${parts(told.second.label)[1]}` : "";
        lines.push(measure(told.x.label, found.called) + second);
        for (const { curve, i } of points) {
          lines.push((curves.length > 1 ? `${curve.name}: ` : "") + measure(told.y.label, digits(curve.y[i], 5)));
          places.push([at("x", found.here), placeOf(curve, i)[1]]);
        }
      } else if (field) {
        const i = nearest(field.x, "x", x), j = nearest(field.y, "y", y), code = field.codes[j * field.x.length + i];
        // digits that 16 bits hold
        const unit = 10 ** Math.ceil(Math.log10(2 * field.step || 1));
        const rounded = digits(Math.round((field.low + code * field.step) / unit) * unit, 6);
        lines.push(measure(told.x.label, digits(field.x[i], 6)), measure(told.y.label, digits(field.y[j], 6)));
        lines.push(code === 65535 ? "no value" : measure(field.label, rounded));
        places.push([at("x", field.x[i]), at("y", field.y[j])]);
      }
      tip.hidden = !lines.length;
      tip.replaceChildren(...lines.map((line) => Object.assign(document.createElement("div"), { textContent: line })));
      pointer.replaceChildren();
      if (!lines.length) return;
      make("path", { d: `M${places[0][0]},${top}V${bottom}` }, pointer);
      places.filter((place) => inView(...place)).forEach(([cx, cy]) => make("circle", { cx, cy, r: 4.5 }, pointer));
      const page = svg.getBoundingClientRect(), scale = page.width / svg.viewBox.baseVal.width;
      tip.style.top = `${scale * (top + 8)}px`;
      tip.style.left = x > (left + right) / 2 ? "" : `${scale * x + 14}px`;
      tip.style.right = x > (left + right) / 2 ? `${page.width - scale * x + 14}px` : "";
    };
    const hush = () => { tip.hidden = true; pointer.replaceChildren(); };
    const reset = () => { view = structuredClone(whole); redraw(); hush(); };

    // Pointer and keys.
    const pageOf = (event) => {
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
      return [x, y];
    };
    const within = ([x, y]) => [Math.max(left, Math.min(right, x)), Math.max(top, Math.min(bottom, y))];
    let from = null, cursor = [(left + right) / 2, (top + bottom) / 2];
    const box = (a, b) => [0, 1].map((k) => [Math.min(a[k], b[k]), Math.max(a[k], b[k])]);
    svg.addEventListener("pointerdown", (event) => {
      const place = pageOf(event);
      const drags = event.pointerType !== "touch" && event.button === 0 && !event.target.closest(".key");
      if (drags && inView(...place)) from = within(place);
    });
    svg.addEventListener("pointermove", (event) => {
      const place = pageOf(event);
      if (!from) { if (inView(...place)) tell(...(cursor = place)); else hush(); return; }
      const [[x0, x1], [y0, y1]] = box(from, within(place));
      hush(); make("rect", { x: x0, y: y0, width: x1 - x0, height: y1 - y0 }, pointer);
    });
    svg.addEventListener("pointerleave", () => { if (!from) hush(); });
    window.addEventListener("pointerup", (event) => {
      if (!from) return;
      const wide = box(from, within(pageOf(event)));
      from = null;
      hush();
      const large = wide.map(([low, high]) => high - low > 8);
      if (!large.some(Boolean)) return;
      view = Object.fromEntries(["x", "y"].map((way, k) => [way, large[k] ? wide[k].map((pixel) => back(way, pixel)) : view[way]]));
      redraw();
    });
    svg.addEventListener("dblclick", reset);
    const tells = `${element.querySelector("figcaption").textContent} Arrow keys read values, Escape shows all.`;
    set(svg, { tabindex: 0, role: "application", "aria-label": tells });
    svg.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (event.key === "Escape") reset();
      if (!way || event.target !== svg) return;
      event.preventDefault();
      cursor = within(cursor.map((pixel, k) => pixel + way[k] * (event.shiftKey ? 40 : 4)));
      tell(...cursor);
    });

    // Legend entries hide and show their curves.
    const show = (curve, shown) => {
      curve.shown = shown;
      curve.group.style.visibility = shown ? "" : "hidden";
      curve.key.classList.toggle("off", !shown);
      curve.key.setAttribute("aria-pressed", shown);
      hush();
    };
    for (const curve of curves.filter((one) => one.key)) {
      const { x, y, width, height } = curve.key.getBBox();
      curve.key.prepend(make("rect", { x, y, width, height, fill: "transparent" }));
      set(curve.key, { tabindex: 0, role: "button", "aria-label": curve.name, "aria-pressed": true });
      curve.key.addEventListener("click", () => show(curve, !curve.shown));
      curve.key.addEventListener("keydown", (event) => {
        if (![" ", "Enter"].includes(event.key)) return;
        event.preventDefault();
        show(curve, !curve.shown);
      });
    }
    window.addEventListener("beforeprint", () => {
      curves.filter((curve) => curve.key).forEach((curve) => show(curve, true));
      reset();
    });

    // The numbers of the curves shown: one table for all that share their abscissae.
    const table = () => {
      const quoted = (text) => `"${text.replaceAll('"', '""')}"`, shown = curves.filter((curve) => curve.shown);
      return [...new Set(shown.map((curve) => curve.start))].map((start) => {
        const group = shown.filter((curve) => curve.start === start);
        const head = [told.x.label, ...group.map((curve) => (curves.length > 1 ? `${curve.name}: ` : "") + told.y.label)];
        const cell = (v) => (Number.isFinite(v) ? digits(v, 7) : "");
        const rows = Array.from(group[0].x, (x, i) => [x, ...group.map((curve) => curve.y[i])].map(cell).join());
        return [head.map(quoted).join(), ...rows].join("\n");
      }).join("\n\n") + "\n";
    };
    const button = document.createElement("button");
    button.textContent = "Copy numbers as CSV";
    button.addEventListener("click", async () => {
      await navigator.clipboard.writeText(table());
      button.textContent = "Copied";
      setTimeout(() => (button.textContent = "Copy numbers as CSV"), 1500);
    });
    if (curves.length) element.append(button);
  };
  figure.count = 0;
  for (const told of document.querySelectorAll("figure > script")) figure(told.parentElement, JSON.parse(told.textContent));
})();
