// SPDX-License-Identifier: MIT
"use strict";

// How numbers are written on the page, by the names that templates call them.

const fewDigits = (value) => (value === 0 ? "0" : value.toExponential(1).replace("e+", "e"));

// The largest unit in which the number is at least 1, otherwise the last one; three significant digits.
function scaled(value, units) {
  const [size, unit] = units.find(([least]) => value >= least) ?? units.at(-1);
  const number = value / size;
  return `${number < 1 ? number.toFixed(2) : number < 100 ? number.toPrecision(3) : number.toFixed(0)} ${unit}`;
}
const timeText = (seconds) => scaled(seconds, [[1, "s"], [1e-3, "ms"], [1e-6, "µs"], [1e-9, "ns"]]);
const bytesText = (bytes) => (bytes < 1e3 ? `${bytes.toFixed(0)} B` : scaled(bytes, [[1e9, "GB"], [1e6, "MB"], [1e3, "kB"]]));

// From 10 000 on in groups of three digits, with narrow spaces.
function countText(count) {
  if (count >= 1e9) return fewDigits(count);
  return count < 1e4 ? count.toFixed(0) : count.toFixed(0).replace(/\B(?=(\d{3})+$)/g, "\u202f");
}
const roughText = (count) => countText(count < 100 ? count : Number(count.toPrecision(2)));
const significant = (digits) => (value) => String(Number(value.toPrecision(digits)));
const decimals = (digits) => (value) => value.toFixed(digits);

const numberFormats = {
  error: fewDigits,
  digit: (value) => value.toExponential(0).replace("e+", "e"),
  power: (value) => `1e${Math.round(Math.log10(value))}`,
  time: timeText,
  bytes: bytesText,
  count: countText,
  rough: roughText,
  ratio: (value) => (value < 10 ? value.toFixed(1) : roughText(value)),
  two: significant(2),
  three: significant(3),
  tenths: decimals(1),
  hundredths: decimals(2),
  correlation: decimals(4),
  percent: (value) => `${Math.round(100 * value)}\u202f%`,
};
