import type { Texture, WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { WordTable } from './WordTable';

/** The parts of a WebGLRenderer that tables use; `lose` forgets its textures, as three does when a lost context is restored. */
function makeWebGL() {
  const handles = new Map<Texture, object>();
  let sent = 0;
  const gl = { pixelStorei: () => undefined, texSubImage2D: () => sent++ };
  const webgl = {
    properties: { get: (texture: Texture) => ({ __webglTexture: handles.get(texture) }) },
    initTexture: (texture: Texture) => handles.set(texture, {}),
    getContext: () => gl,
    state: { bindTexture: () => undefined, unbindTexture: () => undefined },
  } as unknown as WebGLRenderer;
  return { webgl, sent: () => sent, lose: () => handles.clear() };
}

it('sends the words of a version once, and again where a texture has lost them', () => {
  const { webgl, sent, lose } = makeWebGL();
  const table = new WordTable(4);
  const upload = (version: number, rows = 4): [uploads: number, bytes: number] => {
    table.upload(webgl, new Uint32Array(16 * rows), 4, rows, version);
    return [sent(), table.uploadedBytes];
  };
  expect(upload(0)).toEqual([1, 256]);
  expect(upload(0)).toEqual([1, 0]);
  expect(upload(1)).toEqual([2, 256]);
  expect(upload(1)).toEqual([2, 0]);
  lose();
  expect(upload(1)).toEqual([3, 256]);
  expect(upload(1)).toEqual([3, 0]);
  // a larger texture
  expect(upload(2, 40)).toEqual([4, 2560]);
  expect(upload(2, 40)).toEqual([4, 0]);
});
