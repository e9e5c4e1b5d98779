// SPDX-License-Identifier: MIT
// node parts.js PART...: the tests of each PART.test.js, in one browser. What fails is named with its file.
for (const part of process.argv.slice(2)) await import(`./${part}.test.js`);
