/** A tetrahedron of 2 x 3 x 4 m as a glTF file, for tests in node and in a browser. */
import { Buffer } from "node:buffer";

/** A .glb. */
export function tetrahedronGlb() {
  const { json, binary } = tetrahedron();
  let text = JSON.stringify(json);
  text += " ".repeat((4 - (text.length % 4)) % 4);
  const glb = Buffer.alloc(12 + 8 + text.length + 8 + 72);
  glb.write("glTF", 0);
  glb.writeUInt32LE(2, 4);
  glb.writeUInt32LE(glb.length, 8);
  glb.writeUInt32LE(text.length, 12);
  glb.write("JSON", 16);
  glb.write(text, 20);
  glb.writeUInt32LE(72, 20 + text.length);
  glb.write("BIN\0", 24 + text.length);
  binary.copy(glb, 28 + text.length);
  return new Uint8Array(glb);
}

/** A .gltf whose buffer is the file tetra.bin. */
export function tetrahedronGltf() {
  const { json, binary } = tetrahedron();
  json.buffers[0].uri = "tetra.bin";
  return { bytes: new TextEncoder().encode(JSON.stringify(json)), files: { "tetra.bin": new Uint8Array(binary) } };
}

function tetrahedron() {
  const positions = new Float32Array([0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4]);
  const indices = new Uint16Array([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);
  const json = {
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name: "tetra" }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 4, type: "VEC3", min: [0, 0, 0], max: [2, 3, 4] },
      { bufferView: 1, componentType: 5123, count: 12, type: "SCALAR" },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: 48 },
      { buffer: 0, byteOffset: 48, byteLength: 24 },
    ],
    buffers: [{ byteLength: 72 }],
  };
  return { json, binary: Buffer.concat([Buffer.from(positions.buffer), Buffer.from(indices.buffer)]) };
}
