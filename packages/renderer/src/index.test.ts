import { expect, it } from 'vitest';
import manifest from '../package.json';
import * as authoring from './authoring';
import * as entry from '.';

it('exports what a page draws with, and no part of what techniques are made of: those are in /authoring', () => {
  expect(Object.keys(entry).toSorted()).toEqual([
    ...['FarolRenderer', 'clearLearnt', 'learntChoices', 'setShading', 'techniques', 'views'],
  ]);
  expect(Object.keys(entry).filter((name) => name in authoring)).toEqual([]);
});

it('means one thing by each name, over all entries', async () => {
  const files = import.meta.glob<Record<string, unknown>>('./**/*.ts');
  const sources = Object.values(manifest.exports as Record<string, { 'farol-source'?: string; default: string } | null>)
    .map((files) => files?.['farol-source']?.replace('/src', ''))
    .filter((source) => source !== undefined);
  expect(sources.length).toBeGreaterThan(15);
  const meanings = new Map<string, Set<unknown>>();
  for (const source of sources) {
    for (const [name, value] of Object.entries(await files[source]()))
      meanings.set(name, (meanings.get(name) ?? new Set()).add(value));
  }
  expect([...meanings].filter(([, values]) => values.size > 1).map(([name]) => name)).toEqual([]);
});
