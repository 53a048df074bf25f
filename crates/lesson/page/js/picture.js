// @ts-check
// Pictures of the page as files of their own.

import { byId } from "./dom.js";

const DRAWN_PROPERTIES = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray", "stroke-linecap", "stroke-linejoin", "opacity", "font-family", "font-size", "font-weight", "text-anchor", "paint-order"];
const DROPPED_ATTRIBUTES = /^(class|role|tabindex|style|aria-.*|data-.*)$/;
const PIXELS = 3;
// What only hands take hold of.
const HANDLES = ["hit", "grip", "turning"];

/**
 * Hands a file to the reader.
 * @param {string} name
 * @param {Blob} content
 */
export function download(name, content) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/**
 * A picture of the page as a file of its own: what style sheets say is written to each element.
 * @param {SVGElement} svg
 */
function standalone(svg) {
  const width = Math.max(200, svg.clientWidth);
  const height = Math.max(200, svg.clientHeight);
  const copy = /** @type {SVGElement} */ (svg.cloneNode(true));
  bake(svg, copy);
  for (const name of [...copy.getAttributeNames()]) if (DROPPED_ATTRIBUTES.test(name) || name === "fill" || name.startsWith("stroke")) copy.removeAttribute(name);
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("viewBox", `0 0 ${width} ${height}`);
  copy.setAttribute("width", `${width}`);
  copy.setAttribute("height", `${height}`);
  const ground = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  ground.setAttribute("width", "100%");
  ground.setAttribute("height", "100%");
  ground.setAttribute("fill", getComputedStyle(document.body).backgroundColor);
  copy.prepend(ground);
  // A title comes first to be one.
  const title = copy.querySelector("title");
  if (title !== null) copy.prepend(title);
  return { text: `${new XMLSerializer().serializeToString(copy)}\n`, width, height };
}

/**
 * @param {Element} from
 * @param {Element} to
 */
function bake(from, to) {
  const children = [...from.children].map((child, k) => ({ child, copy: to.children[k] }));
  for (const { child, copy } of children) {
    const style = getComputedStyle(child);
    const isDefinition = ["defs", "clipPath", "marker", "pattern", "title"].includes(child.localName);
    const isEmpty = child.localName === "path" && !child.getAttribute("d");
    if (!isDefinition && (style.display === "none" || style.visibility === "hidden" || HANDLES.some((name) => child.classList.contains(name)) || isEmpty)) {
      copy.remove();
      continue;
    }
    bake(child, copy);
    for (const name of copy.getAttributeNames()) if (DROPPED_ATTRIBUTES.test(name)) copy.removeAttribute(name);
    if (isDefinition || child.localName === "g" && child.children.length === 0) continue;
    // Of a group only what is not inherited counts.
    const names = child.localName === "g" ? ["opacity"] : DRAWN_PROPERTIES.filter((name) => child.localName === "text" || !/font|text|paint/.test(name));
    for (const name of names) {
      const value = style.getPropertyValue(name);
      if (value !== "" && !(name.endsWith("opacity") && value === "1") && !(name === "stroke-dasharray" && value === "none")) copy.setAttribute(name, value);
    }
  }
}

/**
 * The same picture in pixels.
 * @param {SVGElement} svg
 * @returns {Promise<Blob>}
 */
async function inPixels(svg) {
  const { text, width, height } = standalone(svg);
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  await image.decode();
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width * PIXELS, height * PIXELS];
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob === null ? reject(new Error("picture")) : resolve(blob)), "image/png");
  });
}

/**
 * Hands over a picture of the page.
 * @param {string} id of its element
 * @param {string} name of the file, without its ending
 * @param {string} type "svg" or "png"
 */
export async function takePicture(id, name, type) {
  const svg = /** @type {SVGElement} */ (/** @type {unknown} */ (byId(id)));
  const picture = type === "svg" ? new Blob([standalone(svg).text], { type: "image/svg+xml" }) : await inPixels(svg);
  download(`${name}.${type}`, picture);
}
