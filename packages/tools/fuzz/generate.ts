import type { FieldTable, FieldValue } from '@farol/editing/fields';
import { deflateSync, zipSync } from 'three/addons/libs/fflate.module.js';
import { builtinComponents } from '../../engine/src/components/index';
import { sceneFields } from '../../engine/src/settings/SceneSettings';
import { randomFieldValue } from '../../engine/src/fields/randomFieldValue';
import { type FarolFile, FILE_VERSION, type FileObject } from '../../engine/src/files/FarolFile';
import type { Prefab } from '../../engine/src/core/Prefab';
import type { FuzzRandom } from './FuzzRandom';
import { hostileValue, mutate, mutateBytes, textOf } from './hostileValues';

export const fuzzKinds = ['scene', 'zip', 'link', 'glb', 'xml', 'glsl', 'ply'] as const;
export type FuzzKind = (typeof fuzzKinds)[number];

/** An untrusted file to open. */
export interface FuzzCase {
  readonly kind: FuzzKind;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

const encode = (text: string): Uint8Array<ArrayBuffer> => new TextEncoder().encode(text);
const assetNames = {
  mesh: ['box', 'sphere', 'own'],
  texture: ['checker'],
  material: [],
  shader: [],
  model: ['model.glb'],
  script: [],
  clip: ['Clip', 'model.glb/clip-1-Move'],
  sound: [],
  profile: ['profile/downlight'],
  surface: [],
  bake: [],
};

function valuesOf(fields: FieldTable, random: FuzzRandom, ids: readonly string[]): Record<string, FieldValue> {
  const values: Record<string, FieldValue> = {};
  for (const [name, field] of Object.entries(fields)) {
    if (!random.once(3)) continue;
    const names = field.kind === 'asset' ? assetNames[field.assetType] : [];
    const value = field.kind === 'object' ? random.of([null, ...ids]) : randomFieldValue(field, random.next, names);
    // half of the time no mesh of 'model.glb', since the file may lack that asset
    values[name] = value === 'model.glb' && random.once(2) ? null : value;
  }
  return values;
}

function objectsOf(random: FuzzRandom, prefix: string, count: number, prefabs: readonly string[]): FileObject[] {
  const ids = Array.from({ length: count }, (_, i) => `${prefix}${i}`);
  return ids.map((id, i): FileObject => {
    const types = [...builtinComponents.types.values()].filter(() => random.once(5));
    const prefab = prefabs.length > 0 && random.once(4) ? random.of(prefabs) : null;
    return {
      id,
      name: random.of(['Lamp', '', 'ü🏮', 'a\nb']),
      parent: i === 0 || (prefix === 'o' && random.once(3)) ? null : ids[random.once(2) ? i - 1 : random.below(i)],
      ...(random.once(5) ? { active: false } : {}),
      ...(random.once(9) ? { locked: true } : {}),
      ...(random.once(9) ? { static: true } : {}),
      ...(random.once(5) ? { tags: ['far', 'x'] } : {}),
      ...(prefab ? { prefab: { prefab, source: random.of([prefab, 'gone']) } } : {}),
      components: types.map((type) => ({
        type: type.typeName,
        version: type.version,
        id: `${id}:${type.typeName}`,
        ...(random.once(6) ? { enabled: false } : {}),
        values: valuesOf(type.fields, random, ids),
      })),
    };
  });
}

/** A valid scene, by the declarations of components and the types of the format; prefabs may hold one another. */
export function sceneCase(random: FuzzRandom): FarolFile {
  const prefabs: Prefab[] = [];
  for (let i = random.once(2) ? random.below(8) : 0; i > 0; i--) {
    const id = `p${i}-0`;
    const inner = prefabs.map((each) => each.id);
    prefabs.push({ id, name: `Prefab ${i}`, objects: objectsOf(random, `p${i}-`, 1 + random.below(4), inner) });
  }
  const count = random.once(80) ? random.of([100, 501, 3000]) : random.below(9);
  const objects = objectsOf(
    random,
    'o',
    count,
    prefabs.map(({ id }) => id),
  );
  const cameras = objects.filter(({ components }) => components.some(({ type }) => type === 'Camera'));
  return {
    format: 'farol-scene',
    version: FILE_VERSION,
    name: 'Fuzz',
    settings: valuesOf(sceneFields, random, []),
    activeCamera: cameras.length > 0 ? random.of(cameras).id : null,
    assets: [
      { name: 'own', type: 'mesh', url: `data:application/octet-stream;base64,${btoa(triangle)}` },
      { name: 'model.glb', type: 'model', url: `data:model/gltf-binary;base64,${base64(glbBytes(gltf()))}` },
      { name: 'Clip', type: 'clip', values: { data: clipOf(random), duration: random.of([0, 0.01, 2]) } },
    ].filter(() => random.below(9) > 0) as FarolFile['assets'],
    ...(random.once(4) ? { microShaders: { 'own/tint': '// Tints.\n#include "other"\nvec3 tint;\n' } } : {}),
    ...(random.once(4) ? { views: [{ place: 4, name: 'Door', fov: 0.8, orthographic: true, ...looks }] } : {}),
    ...(prefabs.length > 0 ? { prefabs } : {}),
    objects,
  };
}

/** JSON text of an animation clip, most often a valid one. */
function clipOf(random: FuzzRandom): string {
  const value = (): unknown => (random.once(9) ? hostileValue(random) : [random.next(), 1, -2]);
  const track = (): unknown => ({
    path: random.of(['', 'Lamp', 'Lamp/Lamp', '/']),
    component: random.of(['Transform', 'Light', 'toString', '']),
    field: random.of(['position', 'rotation', 'scale', 'constructor', 'diffuse']),
    keys: [0, 0.5, 1].slice(random.below(3)).map((time) => ({ time, value: value(), easing: 'bezier' })),
  });
  const method = random.of(['onOpen', 'dispose', '__proto__', 'set']);
  const clip = { tracks: [track(), track()], events: [{ time: 0, method, value: value() }] };
  if (random.once(3)) mutate(clip, random);
  return textOf(clip);
}

const looks = { position: [1, 2, 3], target: [0, -1, 0.5] } as const;

const triangle = [
  'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z',
  'element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n',
].join('\n');

const base64 = (bytes: Uint8Array): string => btoa(String.fromCharCode(...bytes));

/** A small glTF with a bit of everything: a triangle below a node, an animation, instances and a skin. */
const gltf = (): Record<string, unknown> => ({
  asset: { version: '2.0' },
  scene: 0,
  scenes: [{ nodes: [0] }],
  nodes: [{ mesh: 0, name: 'Top', children: [1, 2] }, { translation: [0, 1, 0], mesh: 0 }, { scale: [1, 2, 1] }],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, material: 0 }] }],
  materials: [{ pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1], roughnessFactor: 0.5 } }],
  skins: [{ joints: [2] }],
  animations: [
    {
      name: 'Move',
      samplers: [{ input: 2, output: 0 }],
      channels: [{ sampler: 0, target: { node: 1, path: 'translation' } }],
    },
  ],
  accessors: [
    { componentType: 5126, type: 'VEC3', count: 3, bufferView: 0, min: [0, 0, 0], max: [1, 1, 0] },
    { componentType: 5123, type: 'SCALAR', count: 3, bufferView: 1 },
    { componentType: 5126, type: 'SCALAR', count: 3, bufferView: 2 },
  ],
  bufferViews: [
    { buffer: 0, byteLength: 36 },
    { buffer: 0, byteOffset: 36, byteLength: 6 },
    { buffer: 0, byteOffset: 44, byteLength: 12 },
  ],
  buffers: [{ byteLength: 56 }],
});

function glbBytes(json: unknown): Uint8Array<ArrayBuffer> {
  const text = encode(textOf(json));
  const length = Math.ceil(text.length / 4) * 4;
  const bytes = new Uint8Array(28 + length + 56).fill(0x20, 20, 20 + length);
  const view = new DataView(bytes.buffer);
  [0x46546c67, 2, bytes.length, length, 0x4e4f534a].forEach((word, i) => view.setUint32(i * 4, word, true));
  bytes.set(text, 20);
  view.setUint32(20 + length, 56, true);
  view.setUint32(24 + length, 0x004e4942, true);
  const at = 28 + length;
  [0, 0, 0, 1, 0, 0, 0, 1, 0].forEach((value, i) => view.setFloat32(at + i * 4, value, true));
  [0, 1, 2].forEach((value, i) => view.setUint16(at + 36 + i * 2, value, true));
  [0, 1, 2].forEach((value, i) => view.setFloat32(at + 44 + i * 4, value, true));
  return bytes;
}

const xml = `<?xml version="1.0"?><microshaders><microshader name="light" dependencies="a b" stage='fragment'>
<header><![CDATA[uniform float far;]]></header><maincode>if (1.0 &lt; 2.0) color = vec3(1.0);</maincode></microshader>
<!-- a comment --><microshader name="empty"/></microshaders>`;
const glsl =
  '// What it is for.\n// https://example.com\n//# stage fragment\n#include "other"\nfloat a;\n//# main\na = 1.0;\n';

function sceneText(random: FuzzRandom): string {
  const scene = sceneCase(random);
  if (!random.once(4)) mutate(scene, random);
  return textOf(scene);
}

/** The text of a language, most often with some of its pieces repeated, exchanged and damaged. */
function mutateText(text: string, random: FuzzRandom): Uint8Array<ArrayBuffer> {
  if (random.once(4)) return encode(text);
  const pieces = text.split(/(?=[<>"\n])/);
  for (let n = random.below(4); n >= 0; n--) {
    const piece = random.of(pieces);
    const times = random.once(6) ? random.of([100, 5000]) : 1;
    pieces.splice(
      random.below(pieces.length),
      random.below(2),
      random.once(5) ? String(hostileValue(random)) : piece.slice(0, 200).repeat(times),
    );
  }
  return random.once(2) ? encode(pieces.join('')) : mutateBytes(encode(pieces.join('')), random);
}

/** Generates a test case; equal random choices give equal bytes. */
export function fuzzCase(
  random: FuzzRandom,
  // scenes are half of all cases
  kind: FuzzKind = random.once(2) ? 'scene' : random.of(fuzzKinds),
): FuzzCase {
  switch (kind) {
    case 'scene': {
      const bytes = encode(sceneText(random));
      return { kind, bytes: random.once(8) ? mutateBytes(bytes, random) : bytes };
    }
    case 'zip': {
      const files = {
        'scene.json': encode(sceneText(random)),
        'assets/model.glb': glbBytes(gltf()),
        __proto__: encode('x'),
      };
      const bytes = zipSync(files, { level: 6 }) as Uint8Array<ArrayBuffer>;
      return { kind, bytes: random.once(3) ? bytes : mutateBytes(bytes, random) };
    }
    case 'link': {
      const bytes = new Uint8Array(deflateSync(encode(sceneText(random))));
      return { kind, bytes: random.once(2) ? bytes : mutateBytes(bytes, random) };
    }
    case 'glb': {
      const json = gltf();
      if (!random.once(4)) mutate(json, random);
      const bytes = glbBytes(json);
      return { kind, bytes: random.once(4) ? mutateBytes(bytes, random) : bytes };
    }
    case 'ply':
      return { kind, bytes: mutateText(triangle, random) };
    default:
      return { kind, bytes: mutateText(kind === 'xml' ? xml : glsl, random) };
  }
}
