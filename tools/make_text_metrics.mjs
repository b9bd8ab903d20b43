// Writes src/placement/barlow_advances.h: the advance widths of the label font, read from the very file that the page loads.
//
//     node tools/make_text_metrics.mjs            writes the header
//     node tools/make_text_metrics.mjs --check    exit status 1 when the header on disk is not what the font says
//
// A layout must be the same in page, SVG and command line, so text is measured by this table and never by a machine's fonts.
// Needs nothing but node: a WOFF2 file is a directory and one Brotli stream, and of the tables inside only cmap, head, hhea and
// hmtx are wanted.
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { brotliDecompressSync } from "node:zlib";

const kFont = "assets/fonts/barlow-500.woff2";
const kHeader = "src/placement/barlow_advances.h";

// Basic Latin and Latin-1 without their control characters, then the punctuation that labels may carry:
// dashes, quotation marks, ellipsis, minus.
const kRanges = [
  { name: "BasicLatin", first: 0x20, last: 0x7e },
  { name: "Latin1", first: 0xa0, last: 0xff },
];
const kSingles = [0x2013, 0x2014, 0x2018, 0x2019, 0x201c, 0x201d, 0x2026, 0x2212];

const root = fileURLToPath(new URL("../", import.meta.url));

class Reader {
  constructor(bytes, at = 0) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.at = at;
  }
  u8() {
    return this.view.getUint8(this.at++);
  }
  u16() {
    this.at += 2;
    return this.view.getUint16(this.at - 2);
  }
  i16() {
    this.at += 2;
    return this.view.getInt16(this.at - 2);
  }
  u32() {
    this.at += 4;
    return this.view.getUint32(this.at - 4);
  }
  base128() {
    let value = 0;
    for (let i = 0; i < 5; ++i) {
      const byte = this.u8();
      value = value * 128 + (byte & 0x7f);
      if (!(byte & 0x80)) return value;
    }
    throw new Error("the WOFF2 directory holds a number of more than five bytes");
  }
}

// The tags of the WOFF2 format's list of known tables, as far as their order matters here: an index into it stands for the tag.
const kKnownTags = ["cmap", "head", "hhea", "hmtx", "maxp", "name", "OS/2", "post", "cvt ", "fpgm", "glyf", "loca"];

/** The tables of a WOFF2 file: tag to {bytes, transformed}. */
function readTables(file) {
  const reader = new Reader(file);
  if (reader.u32() !== 0x774f4632) throw new Error(`${kFont} is not a WOFF2 file`);
  reader.at = 12;
  const count = reader.u16();
  reader.at = 20;
  const compressedSize = reader.u32();
  reader.at = 48;
  const entries = [];
  for (let i = 0; i < count; ++i) {
    const flags = reader.u8();
    const index = flags & 0x3f;
    const version = flags >> 6;
    let tag = kKnownTags[index] ?? `known table ${index}`;
    if (index === 63) tag = String.fromCharCode(reader.u8(), reader.u8(), reader.u8(), reader.u8());
    let length = reader.base128();
    // For glyf and loca version 3 is the plain one, for all others version 0.
    const transformed = tag === "glyf" || tag === "loca" ? version !== 3 : version !== 0;
    if (transformed) length = reader.base128();
    entries.push({ tag, length, transformed });
  }
  const data = brotliDecompressSync(file.subarray(reader.at, reader.at + compressedSize));
  const tables = new Map();
  let offset = 0;
  for (const { tag, length, transformed } of entries) {
    tables.set(tag, { bytes: data.subarray(offset, offset + length), transformed });
    offset += length;
  }
  return tables;
}

/** Code point to glyph by the Unicode BMP subtable (format 4). */
function readCharacterMap(table) {
  const reader = new Reader(table.bytes);
  reader.u16();
  let start = -1;
  for (let left = reader.u16(); left > 0; --left) {
    const platform = reader.u16();
    const encoding = reader.u16();
    const offset = reader.u32();
    if ((platform === 3 && encoding === 1) || (platform === 0 && encoding <= 4)) start = offset;
  }
  reader.at = start;
  if (start < 0 || reader.u16() !== 4) throw new Error("the font has no Unicode character map of format 4");
  reader.at = start + 6;
  const segments = reader.u16() / 2;
  const at = (array, i) => new Reader(table.bytes, start + 14 + array * segments * 2 + (array > 0 ? 2 : 0) + i * 2);
  return (code) => {
    for (let i = 0; i < segments; ++i) {
      if (code > at(0, i).u16()) continue;
      const first = at(1, i).u16();
      if (code < first) return 0;
      const delta = at(2, i).u16();
      const rangeReader = at(3, i);
      const position = rangeReader.at;
      const rangeOffset = rangeReader.u16();
      if (rangeOffset === 0) return (code + delta) & 0xffff;
      const glyph = new Reader(table.bytes, position + rangeOffset + (code - first) * 2).u16();
      return glyph === 0 ? 0 : (glyph + delta) & 0xffff;
    }
    return 0;
  };
}

function readFont(file) {
  const tables = readTables(file);
  const unitsPerEm = new Reader(tables.get("head").bytes, 18).u16();
  const hhea = new Reader(tables.get("hhea").bytes, 4);
  const ascender = hhea.i16();
  const descender = hhea.i16();
  const metricCount = new Reader(tables.get("hhea").bytes, 34).u16();
  const hmtx = tables.get("hmtx");
  const advance = (glyph) => {
    const i = Math.min(glyph, metricCount - 1);
    // The transformed table begins with a byte of flags and keeps the advances together, without the side bearings.
    return new Reader(hmtx.bytes, hmtx.transformed ? 1 + i * 2 : i * 4).u16();
  };
  return { unitsPerEm, ascender, descender, advance, glyphOf: readCharacterMap(tables.get("cmap")) };
}

function rows(values, perRow) {
  const lines = [];
  for (let i = 0; i < values.length; i += perRow) lines.push(`    ${values.slice(i, i + perRow).join(", ")},`);
  return lines.join("\n");
}

function makeHeader(font) {
  const advanceOf = (code) => {
    const glyph = font.glyphOf(code);
    if (glyph === 0) throw new Error(`${kFont} has no glyph for U+${code.toString(16).padStart(4, "0")}`);
    return font.advance(glyph);
  };
  const hex = (code) => code.toString(16).toUpperCase().padStart(4, "0");
  const ranges = kRanges.map(({ name, first, last }) => {
    const advances = Array.from({ length: last - first + 1 }, (_, i) => advanceOf(first + i));
    return `/// Advances of U+${hex(first)} to U+${hex(last)}.
inline constexpr char32_t k${name}First = 0x${hex(first)};
inline constexpr std::array<std::int16_t, ${advances.length}> k${name}{
${rows(advances, 16)}
};
`;
  });
  return `// Made by tools/make_text_metrics.mjs from ${kFont} (Barlow Medium, SIL Open Font License 1.1). Do not edit.
#pragma once

#include <array>
#include <cstdint>

/// The label font's metrics, in font units.
namespace dimline::barlow {

// clang-format off

inline constexpr int kUnitsPerEm = ${font.unitsPerEm};
inline constexpr int kAscender = ${font.ascender};
inline constexpr int kDescender = ${font.descender};

${ranges.join("\n")}
/// Characters outside those two ranges, by code point.
struct Advance {
  char32_t code;
  std::int16_t units;
};
inline constexpr std::array<Advance, ${kSingles.length}> kOthers{{
${rows(
  kSingles.map((code) => `{0x${hex(code)}, ${advanceOf(code)}}`),
  6,
)}
}};
// clang-format on

}  // namespace dimline::barlow
`;
}

const header = makeHeader(readFont(readFileSync(root + kFont)));
if (process.argv.includes("--check")) {
  if (readFileSync(root + kHeader, "utf8") !== header) {
    console.error(`${kHeader} is not what ${kFont} says: run node tools/make_text_metrics.mjs and commit the header.`);
    process.exit(1);
  }
} else {
  writeFileSync(root + kHeader, header);
  console.log(`${kHeader} written.`);
}
