/**
 * Private parts of three, by how they are written: fields that begin with underscores, WebGLState, WebGLProperties, the render
 * lists, the way of drawing one object, and what programs of `info.programs` can do.
 */
const names = [
  /\b__webgl\w*/g,
  /\b__version\b/g,
  /\._(?:reversedDepth|frustum|matricesTexture|indirectTexture|colorsTexture|visibilityChanged)\b/g,
  /\bisXRRenderTarget\b/g,
  /\brenderBufferDirect\b/g,
  /\brenderLists\b/g,
  /\bcurrentProgram\b/g,
  /\b(?:webgl|renderer)\.(?:state|properties)\b/g,
  /\{[^{}=]*\b(?:state|properties|renderLists)\b[^{}=]*\} = (?:\w+\.)*(?:webgl|renderer)\b/g,
  /\binfo\.programs as\b/g,
  /\.pixelStorei\?/g,
];

/** The folder whose files may use such names. */
const home = 'packages/renderer/src/three/';

/**
 * Names of three's privates in the code of a file, comments left out.
 *
 * @param {string} path - from the repository's root
 * @param {string} source
 * @returns {string[]} one line each; none for a file of packages/renderer/src/three
 */
export function privatesOfThree(path, source) {
  if (path.startsWith(home)) return [];
  const code = source.replace(/\/\*[^]*?\*\//g, '').replace(/(^|[^:'"`])\/\/.*$/gm, '$1');
  return names.flatMap((name) => (code.match(name) ?? []).map((found) => `${path} uses ${found}`));
}
