// @ts-check
// What pointer and keyboard do in the two pictures.

import { all, byId, closest, rove, targetOf } from "../dom.js";
import { automaticView, pointRounding } from "./parameter-view.js";
import { scaledView, shiftedView } from "./view.js";

const ZOOM = 1.5;
const NEAR = 6;
const SMALL_STEP = 0.01;
const LARGE_STEP = 0.1;

/** @type {Record<string, Place>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/**
 * @param {PageElement} svg
 * @param {MouseEvent} event
 */
function pixel(svg, event) {
  const box = svg.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

/**
 * @param {Area} area
 * @param {Place} point
 */
function inside({ left, top, width, height }, [x, y]) {
  return x >= left && x <= left + width && y >= top && y <= top + height;
}

/**
 * The half-plane whose boundary is under the pointer.
 * @param {Scene} scene
 * @param {ScreenMap} map
 * @param {Place} place
 */
function nearest(scene, map, place) {
  const [x, y] = map.to(place);
  /** @type {{ index: number | undefined, distance: number }} */
  let best = { index: undefined, distance: NEAR };
  for (const { halfPlane, line } of scene.lines) {
    if (!scene.shaping.has(halfPlane.index)) continue;
    const miss = line.b - line.a[0] * place[0] - line.a[1] * place[1];
    const [fx, fy] = map.to([place[0] + miss * line.a[0], place[1] + miss * line.a[1]]);
    const [dx, dy] = map.to([
      place[0] + miss * line.a[0] - line.a[1],
      place[1] + miss * line.a[1] + line.a[0],
    ]);
    const length = Math.hypot(dx - fx, dy - fy) || 1;
    const distance = Math.abs((x - fx) * (dy - fy) - (y - fy) * (dx - fx)) / length;
    if (distance < best.distance) best = { index: halfPlane.index, distance };
  }
  return best.index;
}

/**
 * @param {Scene} scene
 * @param {ScreenMap} map
 * @param {Place} place
 * @returns {PointChoice}
 */
function pointChoice(scene, map, place) {
  return {
    kind: "point",
    theta: scene.frame.theta(place, pointRounding(scene.frame, map.view)),
    near: nearest(scene, map, place),
  };
}

/**
 * Keys and wheel that move and zoom a view; the same in both pictures. `set` takes a view or null for the fitting one.
 * @param {PageElement} svg
 * @param {() => ScreenMap} current
 * @param {(view: View | null) => void} set
 */
function connectView(svg, current, set) {
  svg.addEventListener("keydown", (event) => {
    if (event.target !== svg || event.ctrlKey || event.metaKey || event.altKey) return;
    const { view } = current();
    const arrow = ARROWS[event.key];
    if (arrow) set(shiftedView(view, LARGE_STEP * arrow[0], LARGE_STEP * arrow[1]));
    else if (event.key === "+" || event.key === "=") set(scaledView(view, 1 / ZOOM));
    else if (event.key === "-") set(scaledView(view, ZOOM));
    else if (event.key === "0") set(null);
    else return;
    event.preventDefault();
  });
  svg.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      const map = current();
      set(scaledView(map.view, event.deltaY > 0 ? 1.15 : 1 / 1.15, map.from(pixel(svg, event))));
    },
    { passive: false },
  );
  /** @type {{ at: Place, view: View } | null} */
  let from = null;
  svg.addEventListener("pointerdown", (event) => {
    if (!event.shiftKey || event.button !== 0) return;
    from = { at: pixel(svg, event), view: current().view };
    svg.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  svg.addEventListener("pointermove", (event) => {
    if (from === null) return;
    const [x, y] = pixel(svg, event);
    const { area } = current();
    set(shiftedView(from.view, (from.at[0] - x) / area.width, (y - from.at[1]) / area.height));
  });
  svg.addEventListener("pointerup", () => {
    from = null;
  });
  svg.addEventListener("pointercancel", () => {
    from = null;
  });
}

/**
 * The zoom buttons of both pictures.
 * @param {Store} store
 * @param {() => Drawn} current
 */
export function connectZoom(store, current) {
  for (const button of all("button[data-zoom]")) {
    const key = button.dataset.plane === "data" ? "dataView" : "parameterView";
    button.addEventListener("click", () => {
      const { view } = button.dataset.plane === "data" ? current().dataMap : current().parameterMap;
      const state = store.get();
      /** @type {Record<string, () => View | null>} */
      const views = {
        in: () => scaledView(view, 1 / ZOOM),
        out: () => scaledView(view, ZOOM),
        fit: () => null,
        set: () => automaticView(store.lesson(), { ...state, layers: new Set() }, current().scene, current().layers),
      };
      store.change({ [key]: views[button.dataset.zoom ?? "fit"]() });
    });
  }
}

/**
 * Choosing with arrow keys among the elements that carry `attribute`.
 * @param {PageElement} svg
 * @param {string} attribute
 * @param {(index: number) => void} remember
 * @param {(item: PageElement) => void} choose
 */
function connectRoving(svg, attribute, remember, choose) {
  svg.addEventListener("keydown", (event) => {
    const item = closest(event, `[${attribute}]`);
    if (item === null) return;
    if (event.key === "Enter" || event.key === " ") {
      choose(item);
      event.preventDefault();
      return;
    }
    const items = [...all(`[${attribute}]`, svg)];
    const next = rove(event.key, items.indexOf(item), items.length);
    if (next === null) return;
    remember(next);
    items[next].focus();
    event.preventDefault();
  });
}

/**
 * Readings: pointing at them, choosing them, walking through them.
 * @param {PageElement} svg
 * @param {Store} store
 * @param {() => Drawn} current
 * @param {Roving} roving
 */
export function connectDataPlane(svg, store, current, roving) {
  connectView(
    svg,
    () => current().dataMap,
    (view) => store.change({ dataView: view }),
  );
  /** @param {PageElement} item */
  const rowOf = (item) => Number(item.dataset.reading);
  /** @param {PageElement} item */
  const choose = (item) => {
    const { selection } = store.get();
    const again = selection?.kind === "reading" && selection.row === rowOf(item);
    store.change({ selection: again ? null : { kind: "reading", row: rowOf(item) } });
  };
  connectRoving(
    svg,
    "data-reading",
    (index) => {
      roving.reading = index;
    },
    choose,
  );
  /** @param {Event} event */
  const hover = (event) => {
    const item = closest(event, "[data-reading]");
    const before = store.get().hover;
    if (item !== null) {
      if (before?.kind !== "reading" || before.row !== rowOf(item))
        store.change({ hover: { kind: "reading", row: rowOf(item) } });
    } else if (before !== null) store.change({ hover: null });
  };
  svg.addEventListener("pointerover", hover);
  svg.addEventListener("focusin", hover);
  svg.addEventListener("focusout", () => store.change({ hover: null }));
  svg.addEventListener("pointerleave", () => store.change({ hover: null }));
  svg.addEventListener("click", (event) => {
    const item = closest(event, "[data-reading]");
    if (item !== null) choose(item);
  });
}

/**
 * Vertices and the free point: pointing, choosing, dragging, walking.
 * @param {PageElement} svg
 * @param {Store} store
 * @param {() => Drawn} current
 * @param {Roving} roving
 */
export function connectParameterPlane(svg, store, current, roving) {
  connectView(
    svg,
    () => current().parameterMap,
    (view) => store.change({ parameterView: view }),
  );
  /** @type {(item: PageElement) => VertexChoice} */
  const vertexOf = (item) => ({ kind: "vertex", index: Number(item.dataset.vertex) });
  /** @param {PageElement} item */
  const choose = (item) => {
    const { selection } = store.get();
    const again = selection?.kind === "vertex" && selection.index === Number(item.dataset.vertex);
    store.change({ selection: again ? null : vertexOf(item) });
  };
  connectRoving(
    svg,
    "data-vertex",
    (index) => {
      roving.vertex = index;
    },
    choose,
  );
  /** @param {MouseEvent} event */
  const pointAt = (event) => {
    const { scene, parameterMap } = current();
    const at = pixel(svg, event);
    return inside(parameterMap.area, at) ? pointChoice(scene, parameterMap, parameterMap.from(at)) : null;
  };
  let dragging = false;
  svg.addEventListener("pointerdown", (event) => {
    const handle = closest(event, "#theta-point");
    if (event.shiftKey || event.button !== 0 || closest(event, "[data-vertex]")) return;
    if (event.pointerType === "touch" && handle === null) return;
    const point = pointAt(event);
    if (point === null) return;
    dragging = true;
    svg.setPointerCapture(event.pointerId);
    store.change({ selection: point, hover: null });
  });
  svg.addEventListener("pointermove", (event) => {
    if (dragging) {
      const point = pointAt(event);
      if (point !== null) store.change({ selection: point, hover: null });
    } else if (event.pointerType !== "touch" && !event.shiftKey) {
      const vertex = closest(event, "[data-vertex]");
      store.change({ hover: vertex === null ? pointAt(event) : vertexOf(vertex) });
    }
  });
  svg.addEventListener("pointerup", () => {
    dragging = false;
  });
  svg.addEventListener("pointercancel", () => {
    dragging = false;
  });
  svg.addEventListener("pointerleave", () => store.change({ hover: null }));
  svg.addEventListener("click", (event) => {
    const vertex = closest(event, "[data-vertex]");
    if (vertex !== null) choose(vertex);
    else if (event.pointerType === "touch") {
      const point = pointAt(event);
      if (point !== null) store.change({ selection: point, hover: null });
    }
  });
  svg.addEventListener("focusin", (event) => {
    const vertex = closest(event, "[data-vertex]");
    if (vertex !== null) store.change({ hover: vertexOf(vertex) });
  });
  svg.addEventListener("focusout", () => store.change({ hover: null }));
  connectFreePoint(svg, store, current);
}

/**
 * @param {PageElement} svg
 * @param {Store} store
 * @param {() => Drawn} current
 */
function connectFreePoint(svg, store, current) {
  svg.addEventListener("keydown", (event) => {
    const { selection } = store.get();
    const arrow = ARROWS[event.key];
    if (targetOf(event).id !== "theta-point" || !arrow || selection?.kind !== "point") return;
    const { scene, parameterMap } = current();
    const { view } = parameterMap;
    const share = event.shiftKey ? LARGE_STEP : SMALL_STEP;
    const [x, y] = scene.frame.place(selection.theta);
    const place = [
      x + share * arrow[0] * (view.x[1] - view.x[0]),
      y + share * arrow[1] * (view.y[1] - view.y[0]),
    ];
    store.change({ selection: pointChoice(scene, parameterMap, place), hover: null });
    event.preventDefault();
  });
  byId("place-point").addEventListener("click", () => {
    const { scene, parameterMap } = current();
    const { view } = parameterMap;
    const place = [(view.x[0] + view.x[1]) / 2, (view.y[0] + view.y[1]) / 2];
    store.change({ selection: pointChoice(scene, parameterMap, place), hover: null });
    byId("theta-point").focus();
  });
}
