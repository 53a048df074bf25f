// The lesson page of the transducer, used as a teacher and as a student would.

import assert from "node:assert/strict";
import { after, afterEach, before, beforeEach, test } from "node:test";

import { DATA, boundfit, fitReport, fraction, launch, openLesson, pressIfEnabled, withoutRow } from "./harness.js";

let browser;
let lesson;
let page;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());
beforeEach(async () => {
  lesson = await openLesson(browser, DATA.transducer);
  page = lesson.page;
});
afterEach(async () => {
  assert.deepEqual(lesson.complaints, []);
  await lesson.close();
});

/** The vertices on the page, exact. */
const vertices = () =>
  page.locator("#parameter-plane [data-vertex]").evaluateAll((marks) =>
    marks
      .sort((p, q) => Number(p.dataset.vertex) - Number(q.dataset.vertex))
      .map((mark) => [mark.dataset.theta1, mark.dataset.theta2]));

const exactVertices = (vertices) => vertices.map(({ theta }) => theta.map((value) => value.exact));

/** The ends of the PUI on the page, exact; "" where infinite. */
const pui = async () => {
  const ends = {};
  for (const parameter of ["theta1", "theta2"]) {
    for (const end of ["lower", "upper"]) {
      ends[`${parameter}-${end}`] = await page.locator(`#pui-${parameter}-${end}`).getAttribute("data-exact");
    }
  }
  return ends;
};

const exactPui = (report) => {
  const ends = {};
  report.pui.forEach((interval, axis) => {
    for (const end of ["lower", "upper"]) ends[`theta${axis + 1}-${end}`] = interval[end].exact ?? "";
  });
  return ends;
};

const data = () => page.locator("#lesson-data").evaluate((script) => JSON.parse(script.textContent));
const mode = () => page.locator("body").getAttribute("data-mode");
const status = () => page.locator("#status").textContent();

test("every vertex, the PUI and the area are those of the report", async () => {
  const report = fitReport(DATA.transducer);
  assert.equal(await mode(), "explore");
  assert.equal(report.fps.vertices.length, 6);
  assert.deepEqual(await vertices(), exactVertices(report.fps.vertices));
  assert.deepEqual(await pui(), exactPui(report));
  assert.equal(await page.locator("#area").getAttribute("data-exact"), report.fps.area.exact);
  assert.equal(await page.locator("#kind").getAttribute("data-kind"), "polygon");
  assert.equal(await page.locator("#data-plane [data-reading]").count(), 23);
});

test("clipping forward to the end and back, in every order", async () => {
  const report = fitReport(DATA.transducer);
  const { orders, points } = await data();
  const exact = (indices) => indices.map((index) => points[index].map((value) => value.exact));
  await page.locator("#tab-clip").click();
  assert.deepEqual(orders.map(({ id }) => id), ["given", "slope", "worst"]);
  for (const [index, order] of orders.entries()) {
    await page.locator("#clip-order").selectOption({ index });
    await pressIfEnabled(page, "#step-first");
    assert.equal(await page.locator("#parameter-plane").getAttribute("data-kind"), "plane");
    for (const [number, step] of order.steps.entries()) {
      await page.locator("#step-forward").click();
      assert.equal(await page.locator("#parameter-plane").getAttribute("data-kind"), step.kind, `${order.id}, step ${number + 1}`);
      assert.deepEqual(await vertices(), exact(step.vertices), `${order.id}, step ${number + 1}`);
      const listed = (id) => page.locator(`${id} li`).evaluateAll((items) => items.map(({ dataset }) => [dataset.theta1, dataset.theta2]));
      assert.deepEqual(await listed("#step-born"), exact(step.born));
      assert.deepEqual(await listed("#step-lost"), exact(step.lost));
      assert.equal(await page.locator("#step-effect").getAttribute("data-redundant"), step.redundant?.why ?? "");
    }
    assert.ok(await page.locator("#step-forward").isDisabled());
    assert.deepEqual(await vertices(), exactVertices(report.fps.vertices));
  }
  await page.locator("#step-back").click();
  assert.equal(await page.locator("#step-slider").inputValue(), "45");
  await page.locator("#step-slider").fill("3");
  assert.deepEqual(await vertices(), exact(orders[2].steps[2].vertices));
  await page.locator("#step-last").click();
  assert.deepEqual(await vertices(), exactVertices(report.fps.vertices));
});

test("playing runs through the steps by itself and can be stopped", async () => {
  await page.locator("#tab-clip").click();
  await page.locator("#step-play").click();
  await page.waitForFunction(() => Number(document.querySelector("#step-slider").value) >= 2);
  await page.locator("#step-play").click();
  const stopped = await page.locator("#step-slider").inputValue();
  assert.equal(await page.locator("#step-play").getAttribute("aria-pressed"), "false");
  await page.waitForTimeout(2500);
  assert.equal(await page.locator("#step-slider").inputValue(), stopped);
});

test("the error bound stops at every breakpoint, and each shows what a fit with that bound reports", async () => {
  await page.locator("#tab-epsilon").click();
  await page.locator("#epsilon-slider").fill("0");
  const { sweep } = await data();
  const epsilon = fraction("1/2000");
  for (const [index, breakpoint] of sweep.breakpoints.entries()) {
    if (index > 0) await page.locator("#epsilon-next").click();
    const value = page.locator("#epsilon-value");
    assert.equal(await value.getAttribute("data-breakpoint"), `${index}`);
    assert.equal(await value.getAttribute("data-s"), breakpoint.s.exact);
    const bound = epsilon.times(fraction(breakpoint.s.exact));
    const report = fitReport([...DATA.transducer.slice(0, -1), bound.toString()]);
    assert.equal(await page.locator("#kind").getAttribute("data-kind"), report.fps.kind);
    assert.deepEqual(await vertices(), exactVertices(report.fps.vertices));
    if (report.fps.kind !== "empty") {
      assert.deepEqual(await pui(), exactPui(report));
      assert.equal(await page.locator("#area").getAttribute("data-exact"), report.fps.area.exact);
      const active = new Set(report.fps.vertices.flatMap(({ active }) => active.map(({ row }) => row)));
      const shown = await page.locator("#active").textContent();
      for (const row of active) assert.match(shown, new RegExp(`\\b${row}\\b`));
    }
  }
  await page.locator("#epsilon-least").click();
  assert.equal(await page.locator("#epsilon-value").getAttribute("data-s"), "7910/10027");
  assert.equal(await page.locator("#kind").getAttribute("data-kind"), "point");
});

test("dragging the error bound to a breakpoint and to a value between", async () => {
  await page.locator("#tab-epsilon").click();
  const slider = page.locator("#epsilon-slider");
  const drag = async (target) => {
    await slider.scrollIntoViewIfNeeded();
    const box = await slider.boundingBox();
    const [now, last] = [Number(await slider.inputValue()), Number(await slider.getAttribute("max"))];
    // The thumb is 16 px wide and keeps within the track.
    const at = (stop) => box.x + 8 + ((box.width - 16) * stop) / last;
    await page.mouse.move(at(now), box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(at(target), box.y + box.height / 2, { steps: 8 });
    await page.mouse.up();
    // A pixel may be more than a stop: the keys do the rest.
    for (let tries = 0; tries < 3; tries += 1) {
      const distance = target - Number(await slider.inputValue());
      assert.ok(Math.abs(distance) <= 2, `dragged to a stop ${distance} away`);
      if (distance !== 0) await slider.press(distance > 0 ? "ArrowRight" : "ArrowLeft");
    }
  };
  // Where the third breakpoint is on the slider.
  await slider.fill("0");
  await page.locator("#epsilon-next").click();
  await page.locator("#epsilon-next").click();
  const third = Number(await slider.inputValue());
  await page.locator("#epsilon-given").click();
  const { sweep } = await data();
  for (const stop of [third, third + 1]) {
    await drag(stop);
    const s = fraction(await page.locator("#epsilon-value").getAttribute("data-s"));
    const breakpoint = await page.locator("#epsilon-value").getAttribute("data-breakpoint");
    if (stop === third) assert.equal(s.toString(), sweep.breakpoints[Number(breakpoint)].s.exact);
    else assert.equal(breakpoint, "");
    const report = fitReport([...DATA.transducer.slice(0, -1), s.times(fraction("1/2000")).toString()]);
    assert.deepEqual(await vertices(), exactVertices(report.fps.vertices));
    assert.deepEqual(await pui(), exactPui(report));
    assert.equal(await page.locator("#area").getAttribute("data-exact"), report.fps.area.exact);
  }
});

test("each layer appears and disappears", async () => {
  const names = ["pui-box", "eui-box", "least-squares", "central", "minimax", "centroid", "inner-hull", "outer-polygon", "lp"];
  for (const name of names) {
    const shown = page.locator(`[data-layer-shown="${name}"]`);
    assert.equal(await shown.count(), 0, name);
    await page.locator(`#layer-${name}`).check();
    assert.ok(await shown.count() >= 1, name);
  }
  for (const name of names) {
    await page.locator(`#layer-${name}`).uncheck();
    assert.equal(await page.locator(`[data-layer-shown="${name}"]`).count(), 0, name);
  }
});

test("the referee's verdicts on the LP answers are those of the check", async () => {
  await page.locator("#layer-lp").check();
  const check = JSON.parse(boundfit("check", ...DATA.transducer, "--format", "json"));
  const expected = check.claims
    .filter(({ reading }) => reading === "decimal")
    .flatMap(({ bounds }) => bounds.map(({ verdict }) => verdict));
  const shown = await page.locator("#verdicts [data-verdict]").evaluateAll((rows) => rows.map(({ dataset }) => dataset.verdict));
  assert.deepEqual(shown, expected);
});

test("a reading that matters and one that does not, switched off", async () => {
  const report = fitReport(DATA.transducer);
  for (const row of [34, 20]) {
    const without = withoutRow(row);
    await page.locator(`#leave-out-${row}`).uncheck();
    assert.equal(await mode(), "leave-one-out");
    assert.deepEqual(await vertices(), exactVertices(without.fps.vertices));
    assert.deepEqual(await pui(), exactPui(without));
    const matters = JSON.stringify(without.fps.vertices.map(({ theta }) => theta)) !== JSON.stringify(report.fps.vertices.map(({ theta }) => theta));
    assert.equal(await page.locator("#leave-one-out-verdict").getAttribute("data-matters"), `${matters}`);
    assert.equal(matters, row === 34);
    if (matters) {
      for (const [end, outer] of Object.entries(exactPui(without))) {
        const sign = end.endsWith("upper") ? 1n : -1n;
        const by = fraction(outer).minus(fraction(exactPui(report)[end])).times(fraction(`${sign}`));
        assert.equal(await page.locator(`[data-moved="${end}"]`).getAttribute("data-by"), by.toString());
      }
    }
    await page.locator(`#leave-out-${row}`).check();
    assert.equal(await mode(), "explore");
    assert.deepEqual(await vertices(), exactVertices(report.fps.vertices));
  }
});

test("every vertex has its number in the picture, as in the report", async () => {
  for (const width of [360, 1280]) {
    await page.setViewportSize({ width, height: 900 });
    // A browser may lay a page out more than once before it has the new size.
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    const labels = await page.locator("#vertex-numbers text").allTextContents();
    const numbers = labels.flatMap((label) => label.split(", ")).map(Number);
    assert.deepEqual(numbers.sort(), [1, 2, 3, 4, 5, 6], `${width} px`);
  }
  await page.locator('[data-vertex="4"]').focus();
  assert.match(await page.locator("#inspector h3").textContent(), /^Vertex 5$/);
});

test("the readings drawn strong are those active in the set shown", async () => {
  const strong = () => page.locator(".reading:not(.idle)").evaluateAll((marks) => marks.map(({ dataset }) => Number(dataset.reading)));
  const activeRows = async () => {
    const names = await page.locator("#active .name").allTextContents();
    return [...new Set(names.map((name) => parseInt(name, 10)))].sort((p, q) => p - q);
  };
  await page.locator("#leave-out-14").uncheck();
  assert.ok((await strong()).includes(16) && (await strong()).includes(25));
  assert.deepEqual(await strong(), await activeRows());
  await page.locator("#tab-epsilon").click();
  const last = Number(await page.locator("#epsilon-slider").getAttribute("max"));
  const { sweep } = await data();
  const breakpoint = sweep.breakpoints.findIndex(({ s }) => s.exact === "834/1007");
  assert.ok(breakpoint >= 0);
  for (let stop = 0; stop <= last; stop += 1) {
    await page.locator("#epsilon-slider").fill(`${stop}`);
    if (await page.locator("#epsilon-value").getAttribute("data-breakpoint") !== `${breakpoint}`) continue;
    assert.ok(!(await strong()).some((row) => row === 21 || row === 23));
    return;
  }
  assert.fail("the slider does not stop at 834/1007");
});

test("a vertex names its two bounds and draws their line; a reading shows its strip", async () => {
  const report = fitReport(DATA.transducer);
  for (const [index, vertex] of report.fps.vertices.entries()) {
    // Two vertices may be a pixel apart: only the keyboard tells them from each other.
    await page.locator(`[data-vertex="${index}"]`).focus();
    const words = await page.locator("#inspector").textContent();
    for (const { row, bound } of vertex.active) assert.match(words, new RegExp(`\\b${row}\\b[^.]*${bound}|${bound}[^.]*\\b${row}\\b`));
    for (const value of vertex.theta) assert.ok(words.includes(value.exact), `${value.exact} in ${words}`);
  }
  await page.locator('[data-vertex="5"]').hover();
  assert.match(await page.locator("#inspector").textContent(), /200\/110297/);
  await page.locator('[data-reading="21"]').hover();
  assert.match(await page.locator("#inspector").textContent(), /21/);
});

test("a point of the parameter plane is a line, and tells which readings it misses", async () => {
  await page.locator("#place-point").click();
  const point = page.locator("#theta-point");
  await point.focus();
  const at = async () => [await point.getAttribute("data-theta1"), await point.getAttribute("data-theta2")].map(fraction);
  for (const key of ["ArrowUp", "ArrowUp", "ArrowRight", "ArrowUp", "ArrowUp"]) {
    await page.keyboard.press(key);
    const [theta1, theta2] = await at();
    const { readings } = await data();
    const missed = readings.filter(({ phi, y, epsilon }) => {
      const error = fraction(y.exact).minus(theta1.times(fraction(phi[0].exact))).minus(theta2.times(fraction(phi[1].exact)));
      return fraction(epsilon.exact).minus(error).isNegative() || fraction(epsilon.exact).plus(error).isNegative();
    });
    assert.equal(await page.locator("#violations").getAttribute("data-count"), `${missed.length}`);
  }
});

test("every question has an answer to reveal", async () => {
  const { questions } = await data();
  assert.ok(questions.length >= 6);
  for (const { id } of questions) {
    const box = page.locator(`#question-${id}`);
    assert.match(await box.locator("summary").textContent(), /^[\p{Lu}\d][^{}]+\?$/u);
    await box.locator("summary").click();
    assert.match(await box.locator("p").textContent(), /^[^{}]+\.$/);
    const show = box.locator("button");
    if (await show.count() > 0) await show.first().click();
  }
});

test("the keyboard alone reaches and does everything", async () => {
  const reached = new Set();
  let hidden = 0;
  for (let presses = 0; presses < 250; presses += 1) {
    await page.keyboard.press("Tab");
    const focus = await page.evaluate(() => {
      const element = document.activeElement;
      const style = getComputedStyle(element);
      // Marks in the pictures have a circle around them for it.
      const circle = element.querySelector?.(".hit");
      const ring = style.outlineStyle !== "none" || (circle && getComputedStyle(circle).stroke !== "none");
      const name = element.id || element.dataset.zoom && `${element.dataset.plane}-${element.dataset.zoom}` || element.dataset.vertex && "vertex" || element.dataset.reading && "reading" || element.tagName;
      return { name, ring };
    });
    if (focus.name === "BODY") break;
    if (!focus.ring) hidden += 1;
    reached.add(focus.name);
  }
  assert.equal(hidden, 0, "everything that has the focus shows it");
  for (const name of ["theme-toggle", "tab-explore", "data-plane", "parameter-plane", "place-point", "parameter-in", "data-out", "vertex", "reading", "residual", "layer-lp", "leave-out-14", "leave-out-36"]) {
    assert.ok(reached.has(name), `${name} among ${[...reached].join(", ")}`);
  }
  await page.locator("#tab-explore").focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await mode(), "clip");
  await page.locator("#step-slider").focus();
  await page.keyboard.press("End");
  assert.equal(await page.locator("#step-slider").inputValue(), "46");
  await page.locator("#tab-clip").focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await mode(), "epsilon");
  await page.locator("#epsilon-next").focus();
  await page.keyboard.press("Enter");
  assert.notEqual(await page.locator("#epsilon-value").getAttribute("data-breakpoint"), "");
  assert.notEqual((await status()).trim(), "");
  await page.locator("#tab-epsilon").focus();
  await page.keyboard.press("Home");
  assert.equal(await mode(), "explore");
  await page.locator('[data-vertex="0"]').focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.evaluate(() => document.activeElement.dataset.vertex), "1");
});

test("the theme can be changed, and its button shows that it is pressed", async () => {
  const ground = (selector) => page.locator(selector).evaluate((part) => getComputedStyle(part).backgroundColor);
  const light = await ground("body");
  await page.locator("#theme-toggle").click();
  assert.notEqual(await ground("body"), light);
  assert.notEqual(await ground("#theme-toggle"), await ground("#edit-toggle"));
  await page.locator("#theme-toggle").click();
  assert.equal(await ground("body"), light);
});
