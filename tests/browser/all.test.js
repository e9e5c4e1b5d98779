// SPDX-License-Identifier: MIT
// One browser for all tests, two at a time.
import { after, before, describe } from "node:test";
import { start, stop } from "./browser.js";

before(start);
after(stop);
describe("the page", { concurrency: 2 }, async () => {
  for (const part of ["layout", "phone", "charts", "answers", "scene", "compared", "view", "filters", "palette", "texts", "figures", "broken", "hostile", "family"]) await import(`./${part}.test.js`);
});
