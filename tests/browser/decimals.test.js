// Numbers as the page's script writes them; `tests/tests/lesson/decimals.rs` reads the same file for the engine.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { decimal } from "../../crates/lesson/page/js/model/format.js";
import { Rational } from "../../crates/lesson/page/js/model/rational.js";

const cases = JSON.parse(readFileSync(new URL("../../fixtures/decimals/decimals.json", import.meta.url), "utf8"));

test("the page writes the decimals that the engine writes", () => {
  for (const { exact, digits, ...texts } of cases) {
    for (const rounding of ["nearest", "down", "up"]) {
      const written = decimal(Rational.parse(exact), digits, rounding);
      assert.equal(written.replaceAll("\u2212", "-"), texts[rounding], `${exact}, ${digits} digits, ${rounding}`);
    }
  }
});
