import { readFileSync } from 'node:fs';
import { builtinComponents, Component, ComponentRegistry, GameObject, Scene } from '@farol/engine';
import { component, type FieldType, custom, number, string } from '@farol/engine/fields';
import { deserialize, serialize, UnknownComponent } from '@farol/engine/files';
import type { FarolEffect } from '@farol/renderer';
import type { Technique } from '@farol/renderer/authoring';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { actions } from '../actions';
import type { CustomFieldEditor, EditorApi } from '../api/EditorApi';
import type { EditorPlugin } from '../api/EditorPlugin';
import { KeyBindings } from '../api/KeyBindings';
import { createPreferences } from '../api/preferences';
import { PanelLayout } from '../layout/PanelLayout';
import { PanelRegistry } from '../layout/PanelRegistry';
import { ConsoleLog } from '../model/ConsoleLog';
import { addComponent, addObject, deleteObjects, setValues } from '../model/edits';
import { EditorDocument } from '../model/EditorDocument';
import { Notices } from '../model/Notices';
import { Registry } from '../model/Registry';
import { Signal } from '@farol/editing';
import { panels } from '../panels';
import { AddedEffects } from '../viewport/AddedEffects';
import { Plugins } from './Plugins';
import { spin } from './testing/spin';

const help = 'For a test.';
const share: FieldType = { name: 'share', allows: 'from 0 to 1', check: (value) => Number(value) >= 0 };

class Beacon extends component({
  rate: number(1, { help }),
  word: string('', { help }),
  depth: custom(share, 0.5, { help }),
}) {
  static override readonly typeName: string = 'Beacon';
  static override readonly version: number = 2;
  static migrate = ({ speed, ...values }: Record<string, unknown>): Record<string, unknown> => ({
    ...values,
    rate: speed,
  });
  beats = 0;
  override update(): void {
    this.beats++;
  }
}

const chunks = new Map<string, string>();

/** An editor without canvas and WebGL. */
function makeEditor(): EditorApi & { plugins: Plugins } {
  const components = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
  const registry = new Registry('an action', actions);
  const panelRegistry = new PanelRegistry(panels);
  const techniques: Record<string, unknown> = { deferred: {} };
  const farol = {
    techniques,
    effects: [] as FarolEffect[],
    info: { passes: [] },
    addTechnique: (name: string, technique: Technique) => void (techniques[name] = technique),
    removeTechnique: (name: string) => void delete techniques[name],
  };
  const added = new AddedEffects({ added: new Map(), addedChanged: vi.fn<() => void>() });
  const log = new ConsoleLog();
  const editor = {
    document: new EditorDocument(undefined, components),
    viewport: {
      farol,
      addedEffects: added.registry,
      picture: { retakeTechnique: vi.fn<() => void>() },
      painter: {},
      changed: new Signal(),
    },
    microShaders: {
      registry: { has: (name: string) => chunks.has(name) },
      addChunks(texts: Record<string, string>) {
        for (const [name, text] of Object.entries(texts)) chunks.set(name, text);
        return () => Object.keys(texts).filter((name) => !chunks.delete(name));
      },
    },
    actions: registry,
    keys: new KeyBindings(registry, 'keys'),
    panels: panelRegistry,
    layout: new PanelLayout(panelRegistry, 'layout'),
    components,
    fieldEditors: new Registry<CustomFieldEditor>('a type of fields', []),
    preferences: createPreferences('preferences'),
    log,
    notices: new Notices(log),
  } as unknown as EditorApi;
  return Object.assign(editor, { plugins: new Plugins(editor) });
}

const plugin: EditorPlugin = {
  name: 'Beacons',
  components: [Beacon],
  fieldTypes: [{ ...share, editor: () => null }],
  techniques: { glow: {} as Technique },
  effects: { haze: { label: 'Haze', help, make: () => ({ name: 'haze', dispose() {} }) as FarolEffect } },
  microshaders: { haze: '// haze' },
  actions: [{ id: 'beacons.add', label: 'Add a beacon', keys: ['Ctrl+B'], run() {} }],
  panels: [{ id: 'beacons', title: 'Beacons', icon: 'lamp', place: 'right', load: () => Promise.reject(new Error()) }],
};

/** State of everything that a plugin may add to. */
const partsOf = ({ actions: all, panels: shown, components, fieldEditors, viewport }: EditorApi): unknown => ({
  actions: all.list.map(({ id }) => id),
  panels: shown.list.map(({ id }) => id),
  components: [...components.types.keys()],
  fieldEditors: fieldEditors.list.map(({ id }) => id),
  techniques: Object.keys(viewport.farol.techniques),
  effects: viewport.addedEffects.list.map(({ id }) => id),
  chunks: [...chunks.keys()],
});

const stateOf = ({ document }: EditorApi): string => JSON.stringify(serialize(document.scene));
const beaconOf = ({ document }: EditorApi): Component => document.scene.find('Tower')!.getComponent('Beacon')!;

/** Adds a tower with a beacon, as two steps of history. */
function addTower({ document }: EditorApi): void {
  const { scene, commands } = document;
  const tower = new GameObject('Tower');
  commands.run(addObject(scene, tower, scene, []));
  commands.run(addComponent(scene, [tower], Beacon, { rate: 3, word: 'castle' }));
}

beforeEach(() => {
  const stored = new Map<string, string>();
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => stored.get(key) ?? null,
    setItem: (key: string, value: string) => void stored.set(key, value),
    removeItem: (key: string) => void stored.delete(key),
  });
  vi.stubGlobal('innerWidth', 1440);
  vi.stubGlobal('innerHeight', 900);
  chunks.clear();
});
afterEach(() => void vi.unstubAllGlobals());

describe('two editors on one page', () => {
  it('do not know of what plugins bring to the other, nor of its keys, preferences and layout', () => {
    const [one, other] = [makeEditor(), makeEditor()];
    const before = partsOf(other);
    one.plugins.add({ ...plugin, microshaders: {} });
    one.keys.bind(one.actions.get('edit.undo')!, ['Ctrl+U']);
    one.preferences.setState({ theme: 'light' });
    one.layout.close('inspector');
    one.layout.maximise('viewport');
    expect(partsOf(other)).toEqual(before);
    expect(other.keys.keysOf(other.actions.get('edit.undo')!)).toEqual(['Ctrl+Z']);
    expect(other.preferences.getState().theme).toBe('system');
    expect(other.layout.isOpen('inspector')).toBe(true);
    expect(other.layout.maximised()).toBeNull();
  });

  it('may have the same plugin, and part with it one by one', () => {
    const [one, other] = [makeEditor(), makeEditor()];
    for (const editor of [one, other]) {
      editor.plugins.add({ ...plugin, microshaders: {} });
      addTower(editor);
    }
    one.plugins.remove('Beacons');
    expect(beaconOf(one)).toBeInstanceOf(UnknownComponent);
    expect(beaconOf(other)).toBeInstanceOf(Beacon);
    expect(other.actions.get('beacons.add')).toBeDefined();
  });
});

describe('a plugin', () => {
  it('is taken out with all that it brought, its own clean-up first', () => {
    const editor = makeEditor();
    const before = partsOf(editor);
    const cleanUp = vi.fn<() => void>(() => expect(editor.actions.get('beacons.add')).toBeDefined());
    editor.plugins.add({ ...plugin, setUp: () => cleanUp });
    expect(partsOf(editor)).not.toEqual(before);
    expect(editor.plugins.list.map(({ name }) => name)).toEqual(['Beacons']);
    editor.plugins.remove('Beacons');
    expect(cleanUp).toHaveBeenCalledTimes(1);
    expect(partsOf(editor)).toEqual(before);
    expect(editor.plugins.list).toEqual([]);
    expect(editor.viewport.painter).toBeNull();
    expect(() => editor.plugins.remove('Beacons')).toThrow(/no plugin 'Beacons'/);
  });

  it('is refused as a whole, naming all that is there already', () => {
    const editor = makeEditor();
    editor.plugins.add(plugin);
    const before = partsOf(editor);
    const add = (): void => editor.plugins.add({ ...plugin, name: 'Other', actions: [] });
    expect(add).toThrow(
      "there is the panel 'beacons', the component 'Beacon', the type of fields 'share', the technique 'glow', " +
        "the effect 'haze', the microshader 'haze' already",
    );
    expect(() => editor.plugins.add({ name: 'Beacons' })).toThrow(/there is the plugin 'Beacons' already/);
    const twice = { id: 'x.y', label: 'X', run() {} };
    expect(() => editor.plugins.add({ name: 'Twice', actions: [twice, twice] })).toThrow(/the action 'x.y'/);
    expect(partsOf(editor)).toEqual(before);
  });

  it('that is gone leaves its components as data: saved to the letter, told, no longer run', () => {
    const editor = makeEditor();
    editor.plugins.add(plugin);
    addTower(editor);
    const beacon = beaconOf(editor) as Beacon;
    beacon.enabled = false;
    beacon.enabled = true;
    const saved = stateOf(editor);
    editor.document.simulation.play();
    editor.document.simulation.advance(0.01);
    expect(beacon.beats).toBeGreaterThan(0);
    editor.plugins.remove('Beacons');
    const { beats } = beacon;
    expect(editor.document.simulation.state).toBe('stopped');
    expect(stateOf(editor)).toBe(saved);
    expect(beaconOf(editor)).toBeInstanceOf(UnknownComponent);
    expect(editor.notices.current.at(-1)?.text).toContain('1 Beacon kept as data');
    editor.document.simulation.play();
    editor.document.simulation.advance(0.01);
    editor.document.simulation.stop();
    expect(beacon.beats).toBe(beats);
  });

  it('comes back when its removal is undone, with the very components that the history knows', () => {
    const editor = makeEditor();
    const { commands, scene } = editor.document;
    const states = [stateOf(editor)];
    editor.plugins.add(plugin);
    const note = (): unknown => states.push(stateOf(editor));
    const tower = new GameObject('Tower');
    const run = (command: Parameters<typeof commands.run>[0]): void => {
      commands.run(command);
      note();
    };
    run(addObject(scene, tower, scene, []));
    run(addComponent(scene, [tower], Beacon, { rate: 3 }));
    run(setValues('Set', [tower.getComponent('Beacon')!], { word: 'castle' }));
    run(deleteObjects(scene, [tower]));
    editor.plugins.remove('Beacons');
    note();
    expect(commands.history.at(-1)).toBe('Removed plugin Beacons');
    for (let i = states.length - 2; i >= 0; i--) {
      expect(commands.undo()).toBe(true);
      expect(stateOf(editor)).toBe(states[i]);
      expect(editor.plugins.list).toHaveLength(1);
    }
    for (const state of states.slice(1)) {
      expect(commands.redo()).toBe(true);
      expect(stateOf(editor)).toBe(state);
    }
    expect(editor.plugins.list).toEqual([]);
    expect(editor.components.types.has('Beacon')).toBe(false);
  });

  it('that comes again brings its components back, as a step, and its panel to where it was', () => {
    const editor = makeEditor();
    const { commands } = editor.document;
    editor.plugins.add(plugin);
    editor.layout.open('beacons');
    addTower(editor);
    const saved = stateOf(editor);
    editor.plugins.remove('Beacons');
    expect(editor.layout.isOpen('beacons')).toBe(false);
    editor.layout.close('history');
    editor.plugins.add(plugin);
    expect(editor.layout.isOpen('beacons')).toBe(true);
    expect(beaconOf(editor)).toBeInstanceOf(Beacon);
    expect(beaconOf(editor).authoredValues()).toEqual({ rate: 3, word: 'castle', depth: 0.5 });
    expect(stateOf(editor)).toBe(saved);
    expect(commands.history.at(-1)).toBe('Brought back 1 Beacon');
    while (commands.undo());
    expect(editor.document.scene.find('Tower')).toBeNull();
    while (commands.redo());
    expect(beaconOf(editor)).toBeInstanceOf(Beacon);
    expect(stateOf(editor)).toBe(saved);
  });

  it('takes up what a file held before it came, an older version too; what it cannot read stays, and is told', async () => {
    const editor = makeEditor();
    const scene = new Scene({ name: 'Old' });
    for (const name of ['Tower', 'Ruin']) scene.add(new GameObject(name));
    const file = serialize(scene);
    file.objects[0].components.push({ type: 'Beacon', version: 1, id: 'b', values: { speed: 7, word: 'old' } });
    file.objects[1].components.push({ type: 'Beacon', version: 9, id: 'c', values: { rate: 7 } });
    editor.document.open(await deserialize(file, { registry: editor.components }));
    const saved = serialize(editor.document.scene);
    editor.plugins.add(plugin);
    expect(beaconOf(editor)).toBeInstanceOf(Beacon);
    expect(beaconOf(editor).authoredValues()).toEqual({ rate: 7, word: 'old', depth: 0.5 });
    expect(editor.document.scene.find('Ruin')!.getComponent('Beacon')).toBeInstanceOf(UnknownComponent);
    expect(editor.notices.current.at(-1)?.text).toMatch(/The Beacon of Ruin is kept as data: .*up to version 2/s);
    editor.document.commands.undo();
    expect(serialize(editor.document.scene)).toEqual(saved);
  });
});

it("adds the plugin of the editor's README, which is shown word for word", () => {
  const [readme, text] = ['../../README.md', 'testing/spin.ts'].map((path) =>
    readFileSync(new URL(path, import.meta.url), 'utf8'),
  );
  expect(readme).toContain(`\`\`\`ts\n${text}\`\`\`\n`);
  const editor = makeEditor();
  editor.plugins.add(spin);
  const turned = new GameObject();
  editor.document.scene.add(turned);
  turned.addComponent(editor.components.types.get('Spin')!, { rate: 2 }).update(0.5, 0.5);
  expect(turned.object3D.rotation.y).toBeCloseTo(1);
});
