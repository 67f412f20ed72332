import { Texture } from 'three';
import { describe, expect, it } from 'vitest';
import { ResourceTable, type ResourceUser } from './Resources';
import { validatePasses } from './validatePasses';

const depth = new Texture();
const writer: ResourceUser = { name: 'pre-pass', reads: [], writes: ['scene-depth'] };
const reader: ResourceUser = { name: 'lists', reads: ['scene-depth'], writes: ['target'] };
const stranger: ResourceUser = { name: 'stranger', reads: [], writes: [] };

function table(): ResourceTable {
  const resources = new ResourceTable();
  resources.begin();
  return resources;
}

describe('resources', () => {
  it('go from the pass that writes to those that read, and to effects, within one frame', () => {
    const resources = table();
    resources.use('mine', writer);
    resources.put('scene-depth', depth);
    resources.use('mine', reader);
    expect(resources.get('scene-depth')).toBe(depth);
    resources.use('mine', null);
    expect(resources.find('scene-depth')).toBe(depth);
    resources.begin();
    expect(resources.find('scene-depth')).toBeUndefined();
  });

  it('that nobody has written are an error with the sentence of the check at setup', () => {
    const message = 'Technique "mine": pass "lists" reads "scene-depth", which no earlier pass writes; add one.';
    const resources = table();
    resources.use('mine', reader);
    expect(() => resources.get('scene-depth')).toThrow(message);
    expect(() => validatePasses('mine', [reader])).toThrow(message);
  });

  it('that a pass does not declare are not its to read or write', () => {
    const resources = table();
    resources.use('mine', stranger);
    expect(() => resources.put('scene-depth', depth)).toThrow(/"stranger" writes "scene-depth".*to its writes/);
    expect(() => resources.find('scene-depth')).toThrow(/"stranger" reads "scene-depth".*to its reads/);
  });
});
