/** Fetches what a glTF document consists of: the file itself and, for a .gltf, the buffers and pictures that it names. */

/** Whether a model's name is the address of a glTF file rather than the name of a built-in model; what a visitor picked has one that begins with blob: or data:. */
export function isGltfUrl(name) {
  return /^(blob|data):/i.test(name) || /\.(gltf|glb)$/i.test(name.split(/[?#]/, 1)[0]);
}

/** A URL that is written relative to another; throws an Error with this sentence where it is none. */
export function absoluteUrl(text, base, sentence) {
  if (!URL.canParse(text, base)) throw new Error(sentence);
  return new URL(text, base);
}

/** The addresses of other files in a list of a document, each once. */
function urisOf(entries) {
  const uris = Array.isArray(entries) ? entries.map((entry) => entry?.uri) : [];
  return [...new Set(uris.filter((uri) => typeof uri === "string" && !uri.startsWith("data:")))];
}

async function fetchBytes(url, signal) {
  let response;
  try {
    response = await fetch(url, { signal });
  } catch (cause) {
    if (signal?.aborted) throw cause;
    throw new Error(
      `${url} could not be fetched: is the address right, does that server allow this page to read it, and does this page's own policy (connect-src) allow it to?`,
      { cause },
    );
  }
  if (!response.ok)
    throw new Error(
      `${url} could not be fetched: the server answered ${response.status} ${response.statusText}`.trim() + ".",
    );
  try {
    return new Uint8Array(await response.arrayBuffer());
  } catch (cause) {
    if (signal?.aborted) throw cause;
    throw new Error(`${url} broke off before its end. Try again.`, { cause });
  }
}

/**
 * @param {string} url of a .gltf or .glb, absolute
 * @param {AbortSignal} [signal]
 * @returns {Promise<{bytes: Uint8Array, files: Record<string, Uint8Array>}>} files: by the URI that the document uses
 */
export async function fetchGltf(url, signal) {
  const bytes = await fetchBytes(url, signal);
  const files = {};
  const isBinary = bytes[0] === 0x67 && bytes[1] === 0x6c && bytes[2] === 0x54 && bytes[3] === 0x46; // "glTF"
  if (isBinary) return { bytes, files };
  let document;
  try {
    document = JSON.parse(new TextDecoder().decode(bytes));
  } catch (cause) {
    throw new Error(`${url} is neither a .glb nor the JSON of a .gltf: ${cause.message}.`, { cause });
  }
  const fetchAs = async (uri) => {
    const { href } = absoluteUrl(uri, url, `${url} names a file "${uri}", which is no address beside it.`);
    files[uri] = await fetchBytes(href, signal);
  };
  // A picture that is missing costs the picture; without a buffer there is no model.
  const fetchIfThere = (uri) =>
    fetchAs(uri).catch((error) => {
      if (signal?.aborted) throw error;
      console.warn(`${url} is shown without a picture. ${error.message}`);
    });
  await Promise.all([...urisOf(document?.buffers).map(fetchAs), ...urisOf(document?.images).map(fetchIfThere)]);
  return { bytes, files };
}
