// SPDX-License-Identifier: MIT
// Parts of the page that it carries as gzip in base64: its data, and the library of its charts.

function bytesOf(base64) {
  const letters = atob(base64), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

const unpacked = (id) =>
  new Response(new Blob([bytesOf(document.getElementById(id).textContent)]).stream().pipeThrough(new DecompressionStream("gzip"))).text();

// The library is run when the first chart is drawn.
let library;
const chartLibrary = () => (library ??= unpacked("vega").then((text) => document.head.append(element("script", {}, text))));
