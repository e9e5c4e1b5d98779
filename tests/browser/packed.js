// SPDX-License-Identifier: MIT
// What a page carries as gzip in base64, and a page that carries something else.
import { gunzipSync, gzipSync } from "node:zlib";

const partOf = (id) => new RegExp(`(<script type="application/gzip" id="${id}">)([^<]*)`);
export const unpackedFrom = (page, id) => gunzipSync(Buffer.from(partOf(id).exec(page)[2], "base64")).toString();
export const repacked = (page, id, text) => page.replace(partOf(id), (_, open) => open + gzipSync(text).toString("base64"));
