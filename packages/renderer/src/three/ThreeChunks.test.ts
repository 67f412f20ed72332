import { ShaderChunk } from 'three';
import { afterEach, expect, test } from 'vitest';
import { sumsLights, textHash, ThreeChunks } from './ThreeChunks';

const original = { ...ShaderChunk };
afterEach(() => void Object.assign(ShaderChunk, original));

const groups = ({ lights, shadows, shading }: ThreeChunks) => ({ lights, shadows, shading });
const NONE = { lights: false, shadows: false, shading: !sumsLights };

test("knows three's own texts", () => {
  const chunks = new ThreeChunks();
  expect(chunks.follow()).toBe(true);
  expect(groups(chunks), JSON.stringify(chunks.hashes())).toEqual(NONE);
  expect(chunks.follow()).toBe(false);
  expect(chunks.revision).toBe(1);
});

test.each([
  ['lights_fragment_begin', 'lights'],
  ['lights_pars_begin', 'lights'],
  ['shadowmap_pars_fragment', 'shadows'],
  ['begin_vertex', 'shadows'],
  ['fog_fragment', 'shading'],
  ['fog_vertex', 'shading'],
  ['common', 'shading'],
  ['tonemapping_pars_fragment', 'shading'],
  ['opaque_fragment', 'shading'],
  ['lights_physical_pars_fragment', 'shading'],
  ['lights_fragment_end', 'shading'],
] as const)('a changed %s is a change of %s, found before the first look and after, and undone', (name, group) => {
  const after = new ThreeChunks();
  after.follow();
  ShaderChunk[name] += '\nfloat changed;';
  const before = new ThreeChunks();
  before.follow();
  expect(after.follow()).toBe(true);
  for (const chunks of [before, after]) expect(groups(chunks)).toEqual({ ...NONE, [group]: true });
  ShaderChunk[name] = original[name];
  after.follow();
  before.follow();
  for (const chunks of [before, after]) expect(groups(chunks)).toEqual(NONE);
  expect(after.revision).toBe(3);
});

test('compared in parts, a change is found within eight calls', () => {
  const chunks = new ThreeChunks();
  chunks.follow(true); // the first call compares all
  expect(groups(chunks)).toEqual(NONE);
  ShaderChunk.fog_fragment += '\nfloat changed;';
  expect(Array.from({ length: 8 }, () => chunks.follow(true)).filter(Boolean)).toHaveLength(1);
  expect(groups(chunks)).toEqual({ ...NONE, shading: true });
  expect(Array.from({ length: 16 }, () => chunks.follow(true)).filter(Boolean)).toHaveLength(0);
});

test('a changed project_vertex is one of both', () => {
  ShaderChunk.project_vertex += '\ngl_Position.x *= 2.0;';
  const chunks = new ThreeChunks();
  chunks.follow();
  expect(groups(chunks)).toEqual({ ...NONE, shadows: true, shading: true });
});

test('chunks of other names and the texts that three has already copied count for nothing', () => {
  Object.assign(ShaderChunk, { my_chunk: 'float mine;', meshphysical_frag: '' });
  const chunks = new ThreeChunks();
  chunks.follow();
  expect(groups(chunks)).toEqual(NONE);
});

test('comments and spaces make no other text', () => {
  expect(textHash('float a; // one\n\t/* two\n */ float b;')).toBe(textHash('float a;float b;'));
  expect(textHash('float a;')).not.toBe(textHash('float b;'));
});
