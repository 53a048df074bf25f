// How long a fit of 23 readings takes in the module, and what an edit of a page with many readings asks: `node wasm/times.mjs`.
// Processor time, since the machine may be busy.

import { readFileSync } from "node:fs";

import { lesson, run, start } from "../crates/lesson/engine/boundfit.mjs";

const at = (name) => new URL(name, import.meta.url);
const began = process.cpuUsage();
await start(readFileSync(at("../crates/lesson/engine/boundfit_wasm.wasm.gz")));
const table = readFileSync(at("../fixtures/transducer/transducer.csv"));
const question = { x: "Vz", y: "z", eps: "0.5e-3", rows: [[14, 36]] };
run(table, question);

/** Milliseconds of this process since then. */
const since = (then) => {
  const { user, system } = process.cpuUsage(then);
  return (user + system) / 1000;
};
console.log(`start and first fit: ${since(began).toFixed(0)} ms`);
for (const format of ["json", "text", "proof"]) {
  const times = [];
  for (let round = 0; round < 20; round += 1) {
    const then = process.cpuUsage();
    for (let call = 0; call < 100; call += 1) run(table, { ...question, format });
    times.push(since(then) / 100);
  }
  times.sort((one, other) => one - other);
  console.log(`${format}: ${times[10].toFixed(2)} ms a call, median of 20 times 100`);
}

// A smooth curve with 15 decimals: every reading decides.
for (const count of [100, 300]) {
  const rows = Array.from({ length: count }, (_, row) => (row / count).toFixed(3));
  const curve = ["x,y", ...rows.map((x) => `${x},${Math.sqrt(1 + Number(x)).toFixed(15)}`)].join("\n");
  const times = [];
  let size = 0;
  for (let round = 0; round < 5; round += 1) {
    const then = process.cpuUsage();
    size = JSON.stringify(lesson(curve, { x: "x", y: "y", eps: "0.05" })).length;
    times.push(since(then));
  }
  times.sort((one, other) => one - other);
  console.log(`lesson of ${count} readings of a curve: ${times[2].toFixed(0)} ms, ${(size / 1e6).toFixed(1)} MB, median of 5`);
}
