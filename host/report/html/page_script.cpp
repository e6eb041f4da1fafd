// SPDX-License-Identifier: Apache-2.0
#include "report/html/parts.h"

namespace lobe {

// Linear pictures lie in the page as four bytes a pixel (rgbe.h), so that an exposure is a factor
// on light, and highlights that white cuts off come back.
const char* const page_script = R"js(
"use strict";
// sRGB of a linear value, from a table over its square root: even steps to the eye.
const steps = 4096;
const srgb = Uint8ClampedArray.from({ length: steps + 1 }, (_, i) => {
  const v = (i / steps) ** 2;
  return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
});
const shade = v => srgb[v < 1 ? Math.round(Math.sqrt(v) * steps) : steps];

function bytes_of(text) {
  return Uint8Array.from(atob(text), c => c.charCodeAt(0));
}

// One viewer: its pictures become the choices of one canvas.
function set_up(viewer) {
  const pictures = [...viewer.querySelectorAll(".picture")].map(figure => ({
    image: figure.querySelector("img"), note: figure.querySelector(".note")?.textContent ?? ""
  }));
  const make = (tag, parent, name) => {
    const made = parent.appendChild(document.createElement(tag));
    if (name) made.className = name;
    return made;
  };
  const choices = make("div", viewer, "choices");
  const canvas = make("canvas", viewer);
  const note = make("p", viewer, "note");
  const label = make("label", viewer, "exposure");
  label.append("Exposure");
  const slider = make("input", label);
  Object.assign(slider, { type: "range", min: -10, max: 10, step: 0.1 });
  const said = make("output", label);
  const hint = make("p", viewer, "note");
  hint.textContent = (pictures.length > 1
    ? "Click the picture or press f: flip between the last two. 1 to 9: choose. " : "") +
    (pictures.some(picture => picture.image.dataset.linear)
      ? "+ and −: exposure in half stops. 0: as at first." : "");

  const first_image = pictures[0].image;
  canvas.width = first_image.getAttribute("width");
  canvas.height = first_image.getAttribute("height");
  canvas.style.width = first_image.style.width;
  canvas.setAttribute("role", "img");
  viewer.tabIndex = 0;
  const context = canvas.getContext("2d");
  const start = viewer.dataset.stops;
  let shown = 0, other = Math.min(1, pictures.length - 1);

  const buttons = pictures.map((picture, i) => {
    const button = make("button", choices);
    button.type = "button";
    button.textContent = picture.image.alt;
    button.onclick = () => choose(i);
    return button;
  });

  function paint() {
    const picture = pictures[shown];
    const linear = picture.image.dataset.linear;
    if (!linear) {
      context.drawImage(picture.image, 0, 0);
    } else {
      picture.bytes ??= bytes_of(linear);
      const out = context.createImageData(canvas.width, canvas.height);
      const from = picture.bytes, to = out.data, stops = Number(slider.value);
      for (let i = 0; i < to.length; i += 4) {
        const unit = 2 ** (from[i + 3] - 136 + stops);
        for (let c = 0; c < 3; ++c) to[i + c] = shade(from[i + c] * unit);
        to[i + 3] = 255;
      }
      context.putImageData(out, 0, 0);
    }
    canvas.setAttribute("aria-label", picture.image.alt);
    note.textContent = picture.note;
    slider.disabled = !linear;
    const stops = Number(slider.value), factor = 2 ** stops;
    said.textContent = linear ? "× " + Number(factor.toPrecision(3)) + " (" +
      (stops > 0 ? "+" : "") + stops.toFixed(1) + " stops)" : "colours as they are";
    buttons.forEach((button, i) => button.setAttribute("aria-pressed", i === shown));
  }
  function choose(i) {
    if (i < 0 || i >= pictures.length || i === shown) return;
    [shown, other] = [i, shown];
    paint();
  }
  function expose(stops) {
    slider.value = stops;
    paint();
  }
  slider.oninput = paint;
  label.ondblclick = () => expose(start);
  canvas.onclick = () => { choose(other); viewer.focus(); };
  viewer.onkeydown = event => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const key = event.key, stops = Number(slider.value);
    if (key === "f") choose(other);
    else if (key >= "1" && key <= "9") choose(Number(key) - 1);
    else if (key === "+" || key === "=") expose(stops + 0.5);
    else if (key === "-") expose(stops - 0.5);
    else if (key === "0") expose(start);
    else return;
    event.preventDefault();
  };
  if (pictures.length < 2) choices.hidden = true;
  label.hidden = !pictures.some(picture => picture.image.dataset.linear);
  viewer.querySelector(".pictures").hidden = true;
  expose(start);
}

// Pictures are data of the page, yet decoded in their own time.
for (const viewer of document.querySelectorAll(".viewer"))
  Promise.all([...viewer.querySelectorAll("img")].map(image => image.decode()))
    .then(() => set_up(viewer));
)js";

}  // namespace lobe
