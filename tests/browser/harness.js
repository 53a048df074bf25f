// A lesson page of the program in a real browser. Nothing here skips: without a browser, or without the program, the
// tests fail.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

import { chromium } from "playwright-core";

const root = join(dirname(fileURLToPath(import.meta.url)), "..", "..");
const folder = mkdtempSync(join(tmpdir(), "boundfit-browser-"));
process.on("exit", () => rmSync(folder, { recursive: true, force: true }));

/** A file of readings for the tests. */
function csv(name, ...lines) {
  const file = join(folder, `${name}.csv`);
  writeFileSync(file, lines.join("\n"));
  return file;
}

/** A column name with 150 characters. */
export const LONG_NAME = "pressure_".repeat(17).slice(0, 150);

const longNames = csv("long-names", `${LONG_NAME},y_${LONG_NAME}`, "1,1", "2,2.1", "3,2.9");
const straight = csv("straight", "x,y", "1,1", "2,2", "3,3");

/** Data sets with tests of their own. */
export const SPECIAL = {
  longNames: [longNames, "--x", LONG_NAME, "--y", `y_${LONG_NAME}`, "--eps", "1e299", "--x-unit", LONG_NAME, "--y-unit", LONG_NAME],
  duplicates: [
    csv("duplicates", "x,y", ...Array(50).fill("1,1"), ...Array(50).fill("2,2")), "--x", "x", "--y", "y", "--eps", "0.1",
  ],
  badCondition: [straight, "--x", "x", "--y", "y", "--eps", "0.1", "--where", "theta1>=2"],
  tooTight: [csv("crooked", "x,y", "1,1", "2,3", "3,2"), "--x", "x", "--y", "y", "--eps", "0.1"],
  fromLeast: [csv("crooked", "x,y", "1,1", "2,3", "3,2"), "--x", "x", "--y", "y", "--eps", "1.2*min"],
  least: [csv("crooked", "x,y", "1,1", "2,3", "3,2"), "--x", "x", "--y", "y", "--eps", "min"],
  oneReading: [csv("one-reading", "x,y", "1,1"), "--x", "x", "--y", "y", "--eps", "0.1", "--where", "theta1>=0"],
  near: [
    csv("near", "x,y", ...["0,0", "1,15", "2,20", "3,35"].map((own) => own.replace(/\d+/g, (digits) => `1000000.${digits.padStart(12, "0")}`))),
    "--x", "x", "--y", "y", "--eps", "1e-11",
  ],
  wholeLine: [csv("one", "x,y", "1,1"), "--x", "x", "--y", "y", "--eps", "0"],
  touchingStrips: [csv("touching", "x,y", "1,1", "1,1.2"), "--x", "x", "--y", "y", "--eps", "0.1"],
  equalReadings: [csv("equal", "x,y", "1,1", "1,1"), "--x", "x", "--y", "y", "--eps", "0.1"],
  noError: [straight, "--x", "x", "--y", "y", "--eps", "0"],
};
/** The options of `boundfit` for the data sets of the tests. */
export const DATA = {
  transducer: ["fixtures/transducer/transducer.csv", "--x", "Vz", "--y", "z", "--rows", "14..36", "--eps", "0.5e-3"],
  steamGenerator: [
    "fixtures/steam-generator/steam_generator.csv", "--x", "x", "--y", "y", "--eps-column", "eps", "--where", "theta1 >= 0",
  ],
  norris: ["fixtures/norris/norris.csv", "--x", "x", "--y", "y", "--eps", "1"],
  strip: ["fixtures/claims/strip.csv", "--x", "x", "--y", "y", "--eps", "0.2"],
  point: ["fixtures/hard-lp/point.csv", "--x", "x", "--y", "y", "--eps", "0.3"],
  thin: ["fixtures/hard-lp/thin-1e-12.csv", "--x", "x", "--y", "y", "--eps", "0.428629725263"],
  tiny: [csv("tiny", "x,y", "1,1", "1/2,2", "2,3", "3,3"), "--x", "x", "--y", "y", "--eps", "1e-300"],
  wide: [csv("wide", "x,y", "1e-300,1", "1e300,1e300", "2e300,2.5e300", "3e300,4e300"), "--x", "x", "--y", "y", "--eps", "1e299"],
  huge: [csv("huge", "x,y", "1e5000,1", "2e5000,2", "3e5000,4", "4e5000,4"), "--x", "x", "--y", "y", "--eps", "1"],
  contradiction: [straight, "--x", "x", "--y", "y", "--eps", "0.1", "--where", "theta1>=1", "--where", "theta1<=0"],
  twoRegressors: ["fixtures/steam-generator/steam_generator.csv", "--x", "x,eps", "--y", "y", "--eps", "10"],
};

/** What the program prints for arguments; an empty set (status 3) and a refuted claim (status 4) are answers. BOUNDFIT names one that is built. */
export function boundfit(...words) {
  return boundfitOf(undefined, ...words);
}

/** The same with something on standard input. */
export function boundfitOf(input, ...words) {
  const built = process.env.BOUNDFIT;
  const command = built ? words : ["run", "--quiet", "--release", "--package", "boundfit-cli", "--", ...words];
  try {
    return execFileSync(built ?? "cargo", command, { cwd: root, encoding: "utf8", maxBuffer: 1 << 26, input });
  } catch (failure) {
    if ([3, 4].includes(failure.status)) return failure.stdout;
    throw failure;
  }
}

/** The report of a fit as `boundfit fit --format json` has it. */
export function fitReport(options, ...more) {
  return JSON.parse(boundfit("fit", ...options, "--format", "json", ...more));
}

/** In the place of the options: the page without readings. */
export const PLAYGROUND = ["playground"];

const pages = new Map();

function pageFile(options) {
  const key = options.join(" ");
  if (!pages.has(key)) {
    const file = join(folder, `lesson-${pages.size}.html`);
    boundfit(...(options === PLAYGROUND ? ["playground"] : ["lesson", ...options]), "-o", file);
    pages.set(key, file);
  }
  return pages.get(key);
}

function editedFile(file, edit) {
  const edited = file.replace(".html", "-edited.html");
  writeFileSync(edited, edit(readFileSync(file, "utf8")));
  return edited;
}

function browserFile() {
  // Chromium without windows first: a page of it takes a third of the time.
  const names = ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"];
  const candidates = [process.env.CHROMIUM, ...names.map((name) => `/usr/bin/${name}`)];
  const found = candidates.find((candidate) => candidate && existsSync(candidate));
  if (!found) throw new Error("no Chromium: install one (Debian: apt-get install chromium-headless-shell) or name it in CHROMIUM");
  return found;
}

/** A browser; close it when done. */
export function launch() {
  const quiet = ["--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-quic"];
  return chromium.launch({ executablePath: browserFile(), args: ["--no-sandbox", "--disable-gpu", "--no-first-run", ...quiet] });
}

/**
 * Opens the lesson of a data set from disk. `complaints` collects what must not happen: errors and warnings on the
 * console, uncaught errors, and requests for anything but the page itself. `init` runs in the page before its own script; `edit`
 * makes another file of that of the program.
 */
export async function openLesson(browser, options, { width = 1280, height = 900, init = () => undefined, edit, ...context } = {}) {
  const opened = await browser.newContext({ viewport: { width, height }, reducedMotion: "reduce", ...context });
  const page = await opened.newPage();
  page.setDefaultTimeout(10_000);
  const complaints = [];
  const address = pathToFileURL(edit === undefined ? pageFile(options) : editedFile(pageFile(options), edit)).href;
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => complaints.push(`uncaught: ${error.message}`));
  page.on("request", (request) => {
    // The Worker of the engine is a script of the page, from the page.
    if (![address, "blob:null/"].some((own) => request.url().startsWith(own))) complaints.push(`request: ${request.url()}`);
  });
  await page.addInitScript(init);
  await page.goto(address);
  return { page, complaints, close: () => opened.close() };
}

/** Presses a button unless it has nothing to do. */
export async function pressIfEnabled(page, id) {
  const button = page.locator(id);
  if (await button.isEnabled()) await button.click();
}

/**
 * That a picture which was taken away as SVG and as PNG is that of an element of the page, and needs nothing of the page.
 * `taken` says which bytes were taken as either.
 */
export async function checkPicture(page, selector, taken) {
  const svg = (await taken("svg")).toString();
  assert.match(svg, /^<svg [^>]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
  assert.ok(!/\s(class|aria-\w+|data-[\w-]+)=|var\(/.test(svg), "nothing of the page is needed");
  // Every reference is to what the file has.
  for (const [, id] of svg.matchAll(/url\(["']?#([\w-]+)/g)) assert.ok(svg.includes(`id="${id}"`), id);
  const drawn = await page.evaluate(async (text) => {
    const image = new Image();
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
    await image.decode();
    return [image.naturalWidth, image.naturalHeight];
  }, svg);
  const box = await page.locator(selector).boundingBox();
  assert.ok(Math.abs(drawn[0] - box.width) < 1.5 && Math.abs(drawn[1] - box.height) < 1.5, `${drawn}`);
  const png = await taken("png");
  assert.deepEqual([...png.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
  assert.ok(Math.abs(png.readUInt32BE(16) - 3 * box.width) < 5);
  return svg;
}

/** The report of the transducer without one of its rows. */
export function withoutRow(row) {
  const lines = readFileSync(join(root, DATA.transducer[0]), "utf8").trimEnd().split("\n");
  const file = join(folder, `without-${row}.csv`);
  writeFileSync(file, [lines[0], ...lines.slice(14, 37)].filter((line) => line !== lines[row]).join("\n"));
  return fitReport([file, "--x", "Vz", "--y", "z", "--eps", "0.5e-3"]);
}

class Fraction {
  constructor(numerator, denominator) {
    let [a, b] = [numerator < 0n ? -numerator : numerator, denominator];
    while (b > 0n) [a, b] = [b, a % b];
    this.numerator = numerator / (a || 1n);
    this.denominator = denominator / (a || 1n);
  }

  plus(other) {
    return new Fraction(this.numerator * other.denominator + other.numerator * this.denominator, this.denominator * other.denominator);
  }

  minus(other) {
    return this.plus(new Fraction(-other.numerator, other.denominator));
  }

  times(other) {
    return new Fraction(this.numerator * other.numerator, this.denominator * other.denominator);
  }

  isNegative() {
    return this.numerator < 0n;
  }

  toString() {
    return this.denominator === 1n ? `${this.numerator}` : `${this.numerator}/${this.denominator}`;
  }
}

/** An exact number from its text; not the page's own arithmetic, which is under test. */
export function fraction(text) {
  const [numerator, denominator = "1"] = text.split("/");
  return new Fraction(BigInt(numerator), BigInt(denominator));
}
