// Numbers as the page's script writes them; `tests/tests/lesson/decimals.rs` reads the same file for the engine.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { decimal, plain } from "../../crates/lesson/page/js/model/format.js";
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

test("a measured value has as many digits as tell it from those beside it", () => {
  const [near, width, none] = ["1000000000000000001/1000000000000", "1/100000000000", "0"].map((text) => Rational.parse(text));
  assert.equal(plain(near), "1.0000e6");
  assert.equal(plain(near, none), "1.0000e6");
  assert.equal(plain(near, width), "1000000.000000000001");
  const third = Rational.parse("1/3");
  assert.equal(plain(third, Rational.parse("2")), "0.33333");
  assert.equal(plain(third, Rational.parse("1/1000000")), "0.3333333333");
  assert.equal(plain(Rational.parse("13/1000"), width), "0.013");
});
