import { shortText } from '@farol/editing';
import { describe, expect, test } from 'vitest';
import { MicroShaderRegistry, parseMicroShader, parseMicroShaderXML } from '@farol/renderer/authoring';
import { ComponentRegistry } from '../core/ComponentRegistry';
import { AssetLibrary } from '../assets/AssetLibrary';
import { parseFile } from './parseFile';
import type { FileError } from '../guard/FileError';

const LONG = 'x\u0007\u202e\ud800'.repeat(100_000);

/** Message of the error that `run` throws. */
function messageOf(run: () => unknown): string {
  try {
    run();
  } catch (error) {
    return (error as Error).message;
  }
  throw new Error('Nothing was thrown.');
}

/** Flaw of a message; '' when it is short and printable. */
function flawOf(message: string): string {
  if (message.length >= 2000) return `${message.length} letters`;
  // oxlint-disable-next-line no-control-regex -- these must not be in it
  return /[\u0000-\u0009\u000b-\u001f\u007f-\u009f\u202a-\u202e\ud800-\udfff]/.test(message) ? 'raw bytes' : '';
}

test('shortText cuts, and writes what cannot be seen', () => {
  expect(shortText('plain ü 字 🏮')).toBe('plain ü 字 🏮');
  expect(shortText('a\nb\u0000\u200b\ud83c')).toBe('a\\u{a}b\\u{0}\\u{200b}\\u{d83c}');
  expect(shortText('abcdef', 4)).toBe('abc…');
});

describe('what is thrown about data of a user is short and printable', () => {
  const file = (change: object): string =>
    JSON.stringify({ format: 'farol-scene', version: 2, objects: [], ...change });
  const object = { id: 'a', name: 'A', parent: null, components: [] };
  const component = { type: 'Light', version: 1, id: 'l', values: {} };

  test.each<[string, string]>([
    ['no JSON', LONG],
    ['a format', file({ format: LONG })],
    ['a key', file({ [LONG]: 1 })],
    ['a name', file({ name: [LONG] })],
    [
      'an asset',
      file({
        assets: [
          { name: LONG, type: LONG, url: '' },
          { name: LONG, type: 'mesh' },
        ],
      }),
    ],
    [
      'ids',
      file({
        objects: [
          { ...object, id: LONG },
          { ...object, id: LONG },
        ],
      }),
    ],
    ['a parent', file({ objects: [{ ...object, parent: LONG }] })],
    ['a ring', file({ objects: [{ ...object, id: LONG, parent: LONG }] })],
    ['a type', file({ objects: [{ ...object, components: [{ ...component, type: LONG }] }] })],
    ['a field', file({ objects: [{ ...object, components: [{ ...component, values: { [LONG]: 1 } }] }] })],
    ['a value', file({ objects: [{ ...object, components: [{ ...component, values: { type: LONG } }] }] })],
    ['a camera', file({ activeCamera: LONG })],
    ['a microshader', file({ microShaders: { [LONG]: 'x', a: `//# stage ${'y'.repeat(1e5)}` } })],
    ['a prefab', file({ prefabs: [{ id: LONG, name: LONG, objects: [object] }] })],
    ['a link', file({ objects: [{ ...object, prefab: { prefab: LONG, source: LONG, [LONG]: 1 } }] })],
  ])('a file with %s', (_, text) => {
    expect(flawOf(messageOf(() => parseFile(text, { assets: new AssetLibrary() })))).toBe('');
    try {
      parseFile(text, { assets: new AssetLibrary() });
    } catch (error) {
      for (const { path, problem } of (error as FileError).problems) expect(flawOf(`${path} ${problem}`)).toBe('');
    }
  });

  const xml = (text: string) => (): unknown => parseMicroShaderXML(text, LONG);

  test.each<[string, () => unknown]>([
    ['a name of a microshader', () => parseMicroShader(LONG, '')],
    ['a stage', () => parseMicroShader('a', `//# stage ${'y'.repeat(1e5)}\n`)],
    ['XML', xml(`<microshaders>${LONG}</microshaders>`)],
    ['an element', xml(`<${'a'.repeat(1e5)}>`)],
    ['an end', xml(`<microshaders></${'a'.repeat(1e5)}>`)],
    ['an attribute', xml(`<microshaders><microshader name="a" ${'b'.repeat(1e5)}=""/></microshaders>`)],
    ['an entity', xml(`<microshaders>&${'b'.repeat(1e5)};</microshaders>`)],
    ['elements deep in one another', xml('<a>'.repeat(100_000))],
    ['an unknown component', () => new ComponentRegistry().create(LONG)],
    ['an asset that is not there', () => new AssetLibrary().get(LONG)],
    ['an address that cannot be read', () => new AssetLibrary().registerUrl(LONG, LONG)],
  ])('%s', (_, run) => {
    expect(flawOf(messageOf(run))).toBe('');
  });

  test('microshaders that need one another in a long row', () => {
    const registry = new MicroShaderRegistry();
    for (let i = 0; i < 20_000; i++) registry.add(parseMicroShader(`n${i}`, i === 0 ? '' : `#include "n${i - 1}"\n`));
    expect(flawOf(messageOf(() => registry.compose([], ['n19999'])))).toBe('');
  });
});
