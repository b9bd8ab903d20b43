// Reads the PNG files that the browser makes: 8 bits a channel, RGB or RGBA, not interlaced.
import { inflateSync } from "node:zlib";

/**
 * @param {Buffer} file
 * @returns {{width: number, height: number, channels: number, pixels: Uint8Array}} rows from the top, without padding
 */
export function decodePng(file) {
  if (file.readUInt32BE(0) !== 0x89504e47) throw new Error("not a PNG file");
  let header = null;
  const parts = [];
  for (let at = 8; at < file.length;) {
    const length = file.readUInt32BE(at);
    const type = file.toString("latin1", at + 4, at + 8);
    const data = file.subarray(at + 8, at + 8 + length);
    if (type === "IHDR")
      header = {
        width: data.readUInt32BE(0),
        height: data.readUInt32BE(4),
        depth: data[8],
        colour: data[9],
        interlace: data[12],
      };
    if (type === "IDAT") parts.push(data);
    at += 12 + length;
  }
  const { width, height, depth, colour, interlace } = header;
  const channels = { 2: 3, 6: 4 }[colour];
  if (depth !== 8 || !channels || interlace)
    throw new Error(`a PNG of depth ${depth}, colour type ${colour} is not read here`);
  const raw = inflateSync(Buffer.concat(parts));
  const stride = width * channels;
  const pixels = new Uint8Array(stride * height);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (stride + 1)];
    const from = y * (stride + 1) + 1;
    const to = y * stride;
    for (let i = 0; i < stride; ++i) {
      const left = i >= channels ? pixels[to + i - channels] : 0;
      const up = y > 0 ? pixels[to + i - stride] : 0;
      const upLeft = i >= channels && y > 0 ? pixels[to + i - stride - channels] : 0;
      pixels[to + i] = raw[from + i] + predict(filter, left, up, upLeft);
    }
  }
  return { width, height, channels, pixels };
}

function predict(filter, left, up, upLeft) {
  if (filter === 1) return left;
  if (filter === 2) return up;
  if (filter === 3) return (left + up) >> 1;
  if (filter !== 4) return 0;
  const p = left + up - upLeft;
  const [a, b, c] = [Math.abs(p - left), Math.abs(p - up), Math.abs(p - upLeft)];
  return a <= b && a <= c ? left : b <= c ? up : upLeft;
}

/** How many colours there are when each channel is cut to 4 bits, and the share of the commonest: a blank picture has 1 and 1. */
export function colourStatistics({ width, height, channels, pixels }) {
  const counts = new Map();
  for (let i = 0; i < pixels.length; i += channels) {
    const key = ((pixels[i] >> 4) << 8) | ((pixels[i + 1] >> 4) << 4) | (pixels[i + 2] >> 4);
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  return { colours: counts.size, commonest: Math.max(...counts.values()) / (width * height) };
}

/** The red, green and blue of a pixel. */
export function pixelAt({ width, channels, pixels }, x, y) {
  const at = (Math.round(y) * width + Math.round(x)) * channels;
  return [pixels[at], pixels[at + 1], pixels[at + 2]];
}
