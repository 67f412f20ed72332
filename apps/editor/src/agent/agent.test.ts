import { builtinComponents, createRandom, GameObject, Light, Scene } from '@farol/engine';
import { checkFieldValue, type FieldValue } from '@farol/engine/fields';
import { beforeEach, describe, expect, it } from 'vitest';
import type { EditorApi } from '../api/EditorApi';
import { EditorDocument } from '../model/EditorDocument';
import { makeEmptyScene } from '../model/makeEmptyScene';
import { randomValue } from '../model/testing/randomValue';
import { schemaOfField, shownValue, storedValue } from './fieldValues';
import { runTool } from './runTool';

let document: EditorDocument;
let editor: EditorApi;

beforeEach(() => {
  document = new EditorDocument();
  document.open(makeEmptyScene(document.assets));
  editor = { document, commands: document.commands, file: { name: null } } as unknown as EditorApi;
});

/** Answer of a tool, from JSON. */
const call = async (tool: string, input: object = {}): Promise<Record<string, unknown>> => {
  const [part] = await runTool(editor, tool, input, 'Tester');
  return JSON.parse((part as { text: string }).text) as Record<string, unknown>;
};

describe('values of fields', () => {
  const owners = [...builtinComponents.types.values()].map((type) => new type());

  it('go to an agent and back, as the schema of each field allows', () => {
    const random = createRandom(31);
    let count = 0;
    for (const owner of owners) {
      for (const [name, field] of Object.entries(owner.fields)) {
        if (field.readOnly || field.kind === 'custom') continue;
        for (let i = 0; i < 8; i++) {
          const value = randomValue(random, field, document);
          const shown = shownValue(field, value);
          const context = `${owner.typeName}.${name} ${JSON.stringify(value)}`;
          expect(schemaOfField(field).safeParse(shown).success, context).toBe(true);
          const stored = storedValue(owner, name, shown, document.scene);
          expect(checkFieldValue(field, stored), context).toBeNull();
          expect(shownValue(field, stored), context).toEqual(shown);
          count++;
        }
      }
    }
    expect(count).toBeGreaterThan(1000);
  });

  it('beyond the range of their field are refused with range, unit and help', () => {
    for (const owner of owners) {
      for (const [name, field] of Object.entries(owner.fields)) {
        if (field.readOnly || !('max' in field) || field.max === undefined || field.kind === 'curve') continue;
        const over = shownValue(
          field,
          field.kind === 'vector3' ? [field.max * 2, 0, 0] : ((field.max * 2) as FieldValue),
        );
        const store = (): FieldValue => storedValue(owner, name, over, document.scene);
        expect(store, `${owner.typeName}.${name}`).toThrow(`${owner.typeName}.${name} must be`);
      }
    }
    const light = new Light();
    const store = (name: string, value: unknown) => (): FieldValue => storedValue(light, name, value, document.scene);
    expect(store('cutoff', 120)).toThrow(
      /^Light\.cutoff must be an angle in °, at least 0\.57\d*°, at most 90°, not 120\./,
    );
    expect(store('diffuse', 'red')).toThrow('must be \'#rrggbb\', or linear [r, g, b] of at least 0, not "red".');
    expect(store('castShadow', 1)).toThrow('must be true or false, not 1.');
    expect(store('color', 1)).toThrow(/^Light has no field “color”\. Its fields are type, colourBy, diffuse/);
    for (const name of ['__proto__', 'constructor']) expect(store(name, 1)).toThrow('has no field');
    for (const value of [Number.NaN, Infinity, '1e999', { toString: 1 }, []])
      expect(store('intensity', value)).toThrow('Light.intensity must be');
  });
});

describe('edits of an agent', () => {
  const lamp = { what: 'Point light', name: 'Lamp', components: { Light: { intensity: 40, diffuse: '#fff' } } };
  const texts = (): string => document.serialize();

  it('of one batch are one step, and later ones know what earlier ones add', async () => {
    const before = texts();
    const { objects } = await call('batch', {
      label: 'A lamp',
      edits: [
        { edit: 'add_object', what: 'empty', name: 'Street' },
        { edit: 'add_object', ...lamp, parent: 'Street' },
        { edit: 'move_object', object: 'Street/Lamp', position: [1, 2, 3], by: [0, 1, 0] },
        { edit: 'duplicate_along', objects: ['Lamp'], kind: 'line', count: 3, offset: [2, 0, 0] },
        { edit: 'set_fields', object: 'Lamp 2', component: 'Light', values: { range: 5 } },
        { edit: 'delete', objects: ['Sky'] },
      ],
    });
    expect((objects as { path: string }[]).map(({ path }) => path).toSorted()).toEqual([
      ...['Street', 'Street/Lamp', 'Street/Lamp 2', 'Street/Lamp 3'],
    ]);
    expect(document.commands.history).toEqual(['Tester: A lamp']);
    const second = document.scene.find('Lamp 2')!;
    expect(second.transform.getAuthored('position')).toEqual([3, 3, 3]);
    expect(second.getComponent(Light)!.range).toBe(5);
    const after = texts();
    expect(await call('undo')).toMatchObject({ undone: ['Tester: A lamp'] });
    expect(texts()).toBe(before);
    await call('redo');
    expect(texts()).toBe(after);
  });

  it('add lamps, props and skies of the library, which share what they are made of', async () => {
    const before = texts();
    const { objects } = await call('batch', {
      edits: [
        { edit: 'add_object', what: 'Street lamp', position: [2, 0, 0] },
        { edit: 'add_object', what: 'street lamp', name: 'Second', position: [-2, 0, 0] },
        { edit: 'add_object', what: 'Bench' },
        { edit: 'add_object', what: 'Foggy night' },
      ],
    });
    expect((objects as { path: string }[]).map(({ path }) => path)).toEqual(['Street lamp', 'Second', 'Bench']);
    const { scene } = document;
    expect(scene.prefabs.list.map(({ id }) => id)).toEqual(['library-street-lamp', 'library-bench']);
    expect(scene.find('Second')!.transform.getAuthored('position')).toEqual([-2, 0, 0]);
    expect(scene.settings.volumetricFog).toBe(true);
    await call('undo');
    expect(texts()).toBe(before);
  });

  it.each([
    [{ edit: 'move_object', object: 'Lanp', by: [0, 1, 0] }, /^Edit 2 \(move_object\): There is no object “Lanp”/],
    [{ edit: 'set_fields', object: 'Lamp', component: 'Light', values: { range: -1 } }, /Light\.range must be/],
    [{ edit: 'set_fields', object: 'Lamp', component: 'Camera', values: {} }, /has no Camera; it has Transform, Light/],
    [{ edit: 'set_fields', object: 'Lamp', component: 'Object', values: { active: 1 } }, /must be true or false/],
    [{ edit: 'set_fields', object: 'Lamp', component: 'Light', values: { profile: 'none.ies' } }, /none\.ies/],
    [{ edit: 'add_component', object: 'Lamp', component: 'Light' }, /has a Light already/],
    [{ edit: 'move_object', object: 'Lamp', parent: 'Lamp' }, /cannot be put below itself/],
    [{ edit: 'add_object', what: 'lamp post' }, /Nothing is called “lamp post”/],
    [{ edit: 'duplicate_along', objects: ['Lamp'], kind: 'scatter' }, /Say which surface/],
    [{ edit: 'delete', objects: ['Lamp'], component: 'Transform' }, /cannot be removed: delete the object/],
  ])('that cannot be made undo the whole batch: %j', async (edit, message) => {
    const before = texts();
    await expect(call('batch', { edits: [{ edit: 'add_object', ...lamp }, edit] })).rejects.toThrow(message);
    expect(texts()).toBe(before);
    expect(document.commands.history).toEqual([]);
  });

  it('name an object by its path or id where several have its name', async () => {
    const { scene } = document;
    const parents = ['A', 'B'].map((name) => new GameObject(name));
    for (const parent of parents) scene.add(parent.add(new GameObject('Box')));
    await expect(call('delete', { objects: ['Box'] })).rejects.toThrow(/^2 objects are named “Box”: .*A\/Box \(/);
    await call('delete', { objects: ['A/Box', parents[1].children[0].id] });
    expect(scene.find('Box')).toBeNull();
  });

  it('turn a light to a point, below a parent that is turned too', async () => {
    await call('add_object', { what: 'empty', name: 'Arm', position: [0, 3, 0], rotation: [0, 90, 0] });
    await call('add_object', {
      what: 'Spot light',
      name: 'Spot',
      parent: 'Arm',
      position: [1, 0, 0],
      lookAt: [0, 0, -1],
    });
    document.scene.three.updateMatrixWorld(true);
    const { front } = document.scene.find('Spot')!.transform;
    expect(front.toArray().map((each) => Number(each.toFixed(4)) + 0)).toEqual([0, -1, 0]);
  });

  it('are of the scene that is open alone', async () => {
    const edits = call('add_object', lamp);
    document.open(new Scene({ assets: document.assets }));
    await expect(edits).rejects.toThrow('Another scene was opened');
  });
});

describe('what an agent reads', () => {
  it('is the tree, the values with unit and range, and the schema of a type', async () => {
    const { objects, size } = await call('get_scene');
    expect(size).toBe(3);
    expect((objects as string[])[1]).toMatch(/^Sun \(.+\) \[Light\] directional light at 6, 8, 4$/);
    const [sun] = (await call('get_objects', { objects: ['Sun'], bounds: true })) as unknown as {
      components: { type: string; values: Record<string, object> }[];
    }[];
    expect(sun.components[1].values.cutoff).toMatchObject({ value: 30, unit: '°', max: 90 });
    const { properties } = await call('describe_type', { type: 'Light' });
    expect((properties as Record<string, object>).penumbra).toMatchObject({ type: 'number', minimum: 0, maximum: 1 });
    expect((properties as Record<string, { description: string }>).range.description).toMatch(/Unit: m\..*Only while/);
    await expect(call('describe_type', { type: 'Lite' })).rejects.toThrow('There is no component type “Lite”');
  });
});
