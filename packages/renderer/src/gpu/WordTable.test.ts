import type { Texture, WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { WordTable } from './WordTable';

/** What a table asks of a WebGLRenderer; `lose` forgets its textures, as three does once a lost context is restored. */
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

/** Words that count how many of them are read. */
function countedWords(count: number) {
  const counter = { words: new Uint32Array(count), reads: 0 };
  const read = (target: Uint32Array, key: string | symbol): unknown => {
    if (typeof key === 'string' && /^\d+$/.test(key)) counter.reads++;
    const value: unknown = Reflect.get(target, key, target);
    return typeof value === 'function' ? (value.bind(target) as unknown) : value;
  };
  return { ...counter, counted: new Proxy(counter.words, { get: read }), reads: () => counter.reads };
}

it('looks at no word of a version that it has sent, and sends words that differ once', () => {
  const { webgl, sent, lose } = makeWebGL();
  const { words, counted, reads } = countedWords(64);
  const table = new WordTable(4);
  const upload = (version: number): [uploads: number, bytes: number] => {
    table.upload(webgl, counted, 4, 4, version);
    return [sent(), table.uploadedBytes];
  };
  expect(upload(1)).toEqual([1, 256]);
  const before = reads();
  expect(upload(1)).toEqual([1, 0]);
  expect(reads() - before).toBe(0);
  // a version of the same words
  expect(upload(2)).toEqual([1, 0]);
  expect(reads() - before).toBe(64);
  expect(upload(2)).toEqual([1, 0]);
  expect(reads() - before).toBe(64);
  words[63] = 7;
  expect(upload(3)).toEqual([2, 256]);
  lose();
  expect(upload(3)).toEqual([3, 256]);
  expect(upload(3)).toEqual([3, 0]);
});
