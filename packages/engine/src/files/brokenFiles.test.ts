import { number } from '@farol/editing/fields';
import { describe, expect, test } from 'vitest';
import { AssetLibrary } from '../assets/AssetLibrary';
import { ComponentRegistry } from '../core/ComponentRegistry';
import { builtinComponents } from '../components/index';
import { Component, component } from '../core/Component';
import { deserialize } from './deserialize';
import type { FarolFile, FileObject } from './FarolFile';
import { FileError } from '../guard/FileError';
import { parseFile } from './parseFile';

const light = { type: 'Light', version: 1, id: 'lamp:Light', values: {} as Record<string, unknown> };

function file(change: (objects: FileObject[], file: FarolFile) => void): FarolFile {
  const result: FarolFile = {
    format: 'farol-scene',
    version: 1,
    name: 'Test',
    settings: {},
    activeCamera: null,
    assets: [],
    objects: [
      { id: 'lamp', name: 'Lamp', parent: null, components: [structuredClone(light) as never] },
      { id: 'child', name: 'Child', parent: 'lamp', components: [] },
    ],
  };
  change(result.objects, result);
  return result;
}

const setValue = (name: string, value: unknown): FarolFile =>
  file((objects) => (objects[0].components[0].values[name] = value as never));

const view = { name: 'Door', position: [1, 2, 3], target: [0, 0, 0], fov: 1, orthographic: false } as const;

const broken: [string, unknown, RegExp][] = [
  ['no JSON', '{"format": ', /is not JSON/],
  ['no object', '[]', /must hold an object/],
  ['another format', { format: 'glTF', version: 1 }, /format must be "farol-scene", not "glTF"/],
  ['a newer file', file((_, f) => (f.version = 4)), /version is 4.*up to version 3: update Farol/],
  ['a version that is no number', file((_, f) => (f.version = '1' as never)), /version must be a whole number/],
  [
    'microshaders that are no texts',
    file((_, f) => (f.microShaders = { a: 3 as never })),
    /microShaders\.a must be text, not 3/,
  ],
  [
    'a microshader of a bad name',
    file((_, f) => (f.microShaders = { 'a b': '' })),
    /microShaders\.a b .*use letters, digits/,
  ],
  [
    'a view in no place',
    file((_, f) => (f.views = [{ ...view, place: 0 }])),
    /views\[0\]\.place must be a whole number from 1/,
  ],
  [
    'a picture from elsewhere',
    file((_, f) => (f.picture = { url: 'https://example.org/a.webp' })),
    /picture\.url must be a WebP, JPEG or PNG/,
  ],
  [
    'two views in one place',
    file(
      (_, f) =>
        (f.views = [
          { ...view, place: 3 },
          { ...view, place: 3 },
        ]),
    ),
    /views\[1\]\.place is 3 as that of another/,
  ],
  [
    'a view of itself',
    file((_, f) => (f.views = [{ ...view, place: 1, target: view.position }])),
    /views\[0\]\.target must be elsewhere/,
  ],
  [
    'a view without a field of view',
    file((_, f) => (f.views = [{ ...view, place: 1, fov: undefined as never }])),
    /views\[0\]\.fov must be an angle from 0\.01 to 3\.1 rad, not nothing/,
  ],
  ['an unknown key', { ...file(() => {}), extra: 1 }, /extra is unknown here/],
  [
    'an unknown component',
    file((objects) => (objects[0].components[0].type = 'Laser')),
    /objects\[0\]\.components\[0\]\.type names the unknown component 'Laser' \(known: Transform/,
  ],
  [
    'a newer component',
    file((objects) => (objects[0].components[0].version = 2)),
    /components\[0\]\.version is 2, but this Farol knows Light up to version 1/,
  ],
  ['a component version of 0', file((objects) => (objects[0].components[0].version = 0)), /whole number of at least 1/],
  ['an unknown field', setValue('glow', 1), /values\.glow is unknown; the fields are type, colourBy, diffuse/],
  ['a wrong type', setValue('intensity', '3'), /values\.intensity must be a finite number of at least 0.*not "3"/],
  ['a value out of range', setValue('penumbra', 2), /values\.penumbra must be a finite number from 0 to 1, not 2/],
  ['NaN', setValue('intensity', NaN), /values\.intensity must be .* not NaN/],
  [
    'infinity by way of JSON',
    JSON.stringify(setValue('intensity', 7)).replace('"intensity":7', '"intensity":1e999'),
    /not Infinity/,
  ],
  ['an option that is none', setValue('type', 'laser'), /values\.type must be one of "ambient"/],
  ['a colour with a string', setValue('diffuse', [1, 1, '1']), /values\.diffuse must be \[r, g, b\]/],
  [
    'a duplicate id',
    file((objects) => (objects[1].id = 'lamp')),
    /objects\[1\]\.id 'lamp' is the id of objects\[0\] too/,
  ],
  [
    'a duplicate component id',
    file((objects) => objects[1].components.push({ type: 'Camera', version: 1, id: 'lamp:Light', values: {} })),
    /has the id 'lamp:Light', which is that of objects\[0\] Light too/,
  ],
  [
    'two components of a unique type',
    file((objects) => objects[0].components.push({ type: 'Light', version: 1, id: 'x', values: {} })),
    /is a second Light/,
  ],
  ['a cycle', file((objects) => (objects[0].parent = 'child')), /makes a cycle: lamp below child below lamp/],
  ['an object below itself', file((objects) => (objects[0].parent = 'lamp')), /makes a cycle: lamp below lamp/],
  ['a missing parent', file((objects) => (objects[1].parent = 'gone')), /names the object "gone", which is not in/],
  ['a camera that is none', file((_, f) => (f.activeCamera = 'lamp')), /activeCamera must be the id of an object with/],
  ['a wrong setting', file((_, f) => (f.settings.fogNear = -1)), /settings\.fogNear must be/],
  ['an object that is none', file((objects) => (objects[1] = 5 as never)), /objects\[1\] must be an object, not 5/],
  ['a name that is none', file((objects) => (objects[1].name = 5 as never)), /objects\[1\]\.name must be text, not 5/],
  [
    'a missing mesh',
    file((objects) => {
      objects[0].components.push({ type: 'ObjectRenderer', version: 1, id: 'r', values: { mesh: 'teapot' } });
    }),
    /components\[1\]\.values\.mesh names the mesh 'teapot', which is unknown \(known: box/,
  ],
  [
    'a texture where a mesh belongs',
    file((objects) => {
      objects[0].components.push({ type: 'ObjectRenderer', version: 1, id: 'r', values: { mesh: 'checker' } });
    }),
    /names 'checker', which is a texture: a mesh is needed/,
  ],
  [
    'a prototype for a field',
    JSON.stringify(setValue('near', 1)).replace('"near"', '"__proto__"'),
    /values\.__proto__ is unknown/,
  ],
];

describe('a broken file is refused by name, with nothing half loaded', () => {
  test.each(broken)('%s', async (_, input, message) => {
    const assets = new AssetLibrary();
    const before = assets.list().length;
    await expect(deserialize(input, { assets })).rejects.toThrow(message);
    await expect(deserialize(input, { assets })).rejects.toBeInstanceOf(FileError);
    expect(assets.list()).toHaveLength(before);
    expect(assets.materials.size).toBe(0);
    expect(assets.uses.size).toBe(0);
  });

  test('everything that is wrong is listed, not the first thing only', () => {
    const input = file((objects) => {
      objects[0].components[0].values.intensity = -1;
      objects[0].components[0].values.penumbra = 3;
      objects[1].parent = 'gone';
    });
    const problems = (): readonly unknown[] => {
      try {
        parseFile(input);
        return [];
      } catch (error) {
        return (error as FileError).problems;
      }
    };
    expect(problems()).toHaveLength(3);
  });

  test('an asset that cannot be loaded is named, and the assets of the file are forgotten again', async () => {
    const assets = new AssetLibrary({ fetchBytes: () => Promise.reject(new Error('it answered 404')) });
    const input = file((objects, f) => {
      f.assets.push({ name: 'statue', type: 'mesh', url: 'statue.ply' });
      objects[0].components.push({ type: 'ObjectRenderer', version: 1, id: 'r', values: { mesh: 'statue' } });
    });
    await expect(deserialize(input, { assets })).rejects.toThrow(
      /objects\[0\]\.components\[1\]\.values\.mesh needs an asset: The asset 'statue' could not be loaded: it answered 404/,
    );
    expect(assets.has('statue')).toBe(false);
    expect(assets.materials.size).toBe(0);
  });
});

class Lamp extends component({ power: number(10, { unit: 'W', min: 0, help: 'Power.' }) }) {
  static override readonly typeName: string = 'Lamp';
  static override readonly version: number = 3;

  static migrate(values: Record<string, unknown>, from: number): Record<string, unknown> {
    if (from === 1) throw new Error('version 1 had no unit');
    return { power: Number(values.kilowatts) * 1000 };
  }
}

class Frozen extends component({ power: number(10, { help: 'Power.' }) }) {
  static override readonly typeName: string = 'Frozen';
  static override readonly version: number = 2;
}

describe('older components', () => {
  const registry = new ComponentRegistry([...builtinComponents.types.values(), Lamp, Frozen]);
  const lamp = (type: string, version: number, values: Record<string, number>): FarolFile =>
    file((objects) => (objects[0].components = [{ type, version, id: 'lamp:Lamp', values }]));

  test('are brought up to date by their migration', async () => {
    const scene = await deserialize(lamp('Lamp', 2, { kilowatts: 0.25 }), { registry });
    expect(scene.find('lamp')!.getComponent('Lamp')!.get('power')).toBe(250);
    expect(parseFile(lamp('Lamp', 2, { kilowatts: 0.25 }), { registry }).objects[0].components[0].version).toBe(3);
  });

  test('a migration that makes a wrong value, fails, or is missing is named', () => {
    expect(() => parseFile(lamp('Lamp', 2, { kilowatts: -1 }), { registry })).toThrow(/values\.power must be/);
    expect(() => parseFile(lamp('Lamp', 1, {}), { registry })).toThrow(/migration to version 3 failed.*had no unit/);
    expect(() => parseFile(lamp('Frozen', 1, {}), { registry })).toThrow(/Frozen has no migration to version 2/);
  });

  test('every built-in component is a Component of its own name', () => {
    for (const [name, type] of builtinComponents.types) {
      expect(new type()).toBeInstanceOf(Component);
      expect(new type().typeName).toBe(name);
    }
  });
});
