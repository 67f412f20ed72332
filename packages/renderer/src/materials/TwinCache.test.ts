import { MeshStandardMaterial, ShaderChunk } from 'three';
import { expect, test } from 'vitest';
import { threeChunks } from '../three/ThreeChunks';
import { TwinCache } from './TwinCache';
import type { TwinKind } from './TwinKind';

const kindOf = (key: string): TwinKind => ({ key, chunks: () => [], patch() {} });

const makeCache = () =>
  new TwinCache({
    uniforms: {},
    microshaders: { header: () => '', revision: () => 0, textKey: () => '' },
    refuse() {},
  });

test('twins go with their source and with the cache, which leaves nothing behind on the sources', () => {
  const cache = makeCache();
  const kinds = [kindOf('a'), kindOf('b')];
  const listeners = (source: MeshStandardMaterial) =>
    ((source as { _listeners?: { dispose?: unknown[] } })._listeners?.dispose ?? []).length;
  const sources = [new MeshStandardMaterial(), new MeshStandardMaterial()];
  let disposed = 0;
  for (const source of sources) {
    for (const kind of kinds) cache.get(source, kind).addEventListener('dispose', () => disposed++);
  }
  const twin = cache.get(sources[0], kinds[0]);
  sources[0].dispose();
  expect(disposed).toBe(2);
  expect(listeners(sources[0])).toBe(0);
  expect(cache.get(sources[0], kinds[0])).not.toBe(twin);
  cache.dispose();
  expect(disposed).toBe(4);
  expect(sources.map(listeners)).toEqual([0, 0]);
});

test('a frame in which a twin compiles shaders that the page has changed is outdated, but not for ever', () => {
  const { fog_fragment } = ShaderChunk;
  const cache = makeCache();
  const source = new MeshStandardMaterial();
  const shader = () => ({ uniforms: {}, vertexShader: '', fragmentShader: '' }) as never;
  /** Draws a frame that makes and compiles a twin. @returns whether it must be drawn again */
  const frame = (changes: boolean): boolean => {
    cache.begin();
    const twin = cache.get(source, kindOf('a'));
    if (changes) ShaderChunk.fog_fragment += '\nfloat changed;';
    twin.onBeforeCompile(shader(), {} as never);
    return cache.isOutdated;
  };
  try {
    expect(frame(false)).toBe(false);
    expect(frame(false)).toBe(false);
    expect(frame(true)).toBe(true);
    expect(frame(false)).toBe(false);
    // a page that changes chunks at every compile is not redrawn endlessly
    expect([frame(true), frame(true), frame(true)]).toEqual([true, true, false]);
  } finally {
    ShaderChunk.fog_fragment = fog_fragment;
    threeChunks.follow();
  }
});
