import { MeshStandardMaterial } from 'three';
import { expect, test } from 'vitest';
import { TwinCache } from './TwinCache';
import type { TwinKind } from './TwinKind';

const kindOf = (key: string): TwinKind => ({ key, chunks: () => [], patch() {} });

test('twins go with their source and with the cache, which leaves nothing behind on the sources', () => {
  const cache = new TwinCache({
    uniforms: {},
    microshaders: { header: () => '', revision: () => 0, textKey: () => '' },
    refuse() {},
  });
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
