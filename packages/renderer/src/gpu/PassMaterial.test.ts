import { afterEach, describe, expect, it } from 'vitest';
import { MicroShaderRegistry } from '../microshaders';
import { threeChunks } from '../three/ThreeChunks';
import { OutputMaterial, PassMaterial } from './PassMaterial';

const options = { name: 'test', vertex: [], fragment: [], uniforms: {} };
const { revision } = threeChunks;

afterEach(() => {
  threeChunks.revision = revision;
});

describe.each([
  ['PassMaterial', PassMaterial],
  ['OutputMaterial', OutputMaterial],
])('%s', (_, Class) => {
  const make = () => new Class(new MicroShaderRegistry(), options);

  it('has another version after a change of its own, and after one of three’s chunks', () => {
    const material = make();
    const first = material.version;
    material.needsUpdate = true;
    expect(material.version).toBe(first + 1);
    threeChunks.revision++;
    expect(material.version).toBe(first + 2);
  });

  it('has no accessor of its own, which would slow the reads of all materials that three draws', () => {
    const descriptors = Object.values(Object.getOwnPropertyDescriptors(make()));
    expect(descriptors.filter(({ get }) => get !== undefined)).toEqual([]);
  });
});
