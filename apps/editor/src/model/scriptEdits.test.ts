import type { Command } from '@farol/editing';
import { builtinComponents, type ClipAsset, ComponentRegistry, GameObject } from '@farol/engine';
import { serialize, UnknownComponent } from '@farol/engine/files';
import { makePrefab } from '@farol/engine/prefabs';
import { expect, it } from 'vitest';
import { moveAssets, renameFolder } from './assetEdits';
import { deleteAsset, usagesOf } from './assetUsages';
import { EditorDocument } from './EditorDocument';
import { addScript, addScriptComponent, duplicateScript, renameAnyAsset, renameScript } from './scriptEdits';
import { classNameOf, componentTypeOf, scriptOfType, sourceForName } from './scriptNames';
import { scriptTemplate } from './scriptTemplate';

/** A document whose scripts do not run: their components are kept as data. */
function quietDocument(): { document: EditorDocument; objects: GameObject[] } {
  const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
  const document = new EditorDocument(undefined, registry);
  document.scripts.isOn = false;
  const objects = ['One', 'Two'].map((name) => new GameObject(name));
  for (const object of objects) document.scene.add(object);
  return { document, objects };
}

const state = ({ scene }: EditorDocument): string => JSON.stringify(serialize(scene));

/** Runs a command, then undoes and redoes it: the state must come back exactly. */
function run(document: EditorDocument, command: Command): void {
  const before = state(document);
  const steps = document.commands.history.length;
  document.commands.run(command);
  const after = state(document);
  expect(after).not.toBe(before);
  expect(document.commands.history.length).toBe(steps + 1);
  document.commands.undo();
  expect(state(document)).toBe(before);
  document.commands.redo();
  expect(state(document)).toBe(after);
}

const sourceOf = ({ assets }: EditorDocument, name: string): string => assets.fieldAsset(name)!.get('source') as string;
const typesOf = ({ components }: GameObject): string[] => components.map(({ typeName }) => typeName);

it('names classes after scripts', () => {
  expect(classNameOf('Script 2')).toBe('Script2');
  expect(classNameOf('Doors/door opener.js')).toBe('DoorOpener');
  expect(classNameOf('2nd')).toBe('Script2nd');
  expect(classNameOf('Puerta mágica')).toBe('PuertaMagica');
});

it('knows the type of components of a script: declared, else its name; none without a default export', () => {
  expect(componentTypeOf('Doors/Opener', scriptTemplate('Opener'))).toBe('Opener');
  expect(componentTypeOf('Old.js', scriptTemplate('Old.js'))).toBe('Old');
  const declared = "export default class A extends B { static override readonly typeName: string = 'Door'; }";
  expect(componentTypeOf('A', declared)).toBe('Door');
  expect(componentTypeOf('A', 'class A {}\nexport { A as default };')).toBe('A');
  expect(componentTypeOf('helpers', 'export const twice = (value: number) => 2 * value;')).toBeNull();
});

it('writes a template without types for JavaScript', () => {
  expect(scriptTemplate('Spin')).toContain('override update(deltaSeconds: number): void {');
  expect(scriptTemplate('Spin.js')).toContain('  update(deltaSeconds) {');
  expect(scriptTemplate('Spin.js')).not.toMatch(/override|: number\)|: void/);
});

it('changes the name of a class that is called after the script, and no other', () => {
  expect(sourceForName(scriptTemplate('Spin'), 'Spin', 'Turn')).toBe(scriptTemplate('Turn'));
  const own = 'export default class Wheel extends X {}';
  expect(sourceForName(own, 'Spin', 'Turn')).toBe(own);
});

it('makes a script and its component on objects in one step', () => {
  const { document, objects } = quietDocument();
  const { command, name } = addScript(document.scene, 'Script', objects);
  run(document, command);
  expect(name).toBe('Script');
  expect(document.commands.last!.label).toBe('Made script Script for 2 objects');
  expect(objects.map(typesOf)).toEqual([
    ['Transform', 'Script'],
    ['Transform', 'Script'],
  ]);
  expect(scriptOfType(document.scene, 'Script')).toBe('Script');
  expect(scriptOfType(document.scene, 'Transform')).toBeNull();
  expect(usagesOf(document.scene, 'Script').map(({ place, field }) => `${place} ${field}`)).toEqual([
    'One Script',
    'Two Script',
  ]);
});

it('takes a name that neither an asset nor a type of components has', () => {
  const { document } = quietDocument();
  const make = (wanted: string): string => {
    const { command, name } = addScript(document.scene, wanted);
    document.commands.run(command);
    return name;
  };
  expect(make('Script')).toBe('Script');
  expect(make('Script')).toBe('Script 2');
  expect(make('Doors/Script')).toBe('Doors/Script 3');
  expect(make('Light')).toBe('Light 2');
  expect(make('Old.js')).toBe('Old.js');
  expect(make('Old.js')).toBe('Old 2.js');
});

it('copies a script, its class under the new name', () => {
  const { document } = quietDocument();
  document.commands.run(addScript(document.scene, 'Spin').command);
  const { command, name } = duplicateScript(document.scene, 'Spin');
  run(document, command);
  expect(name).toBe('Spin 2');
  expect(sourceOf(document, name)).toBe(scriptTemplate('Spin 2'));
  expect(() => duplicateScript(document.scene, 'box')).toThrow('is not a script');
});

it('renames a script with its class, its components and those of prefabs', () => {
  const { document, objects } = quietDocument();
  const { scene } = document;
  document.commands.run(addScript(scene, 'Spin', objects).command);
  const { prefab } = makePrefab(objects[1]);
  scene.prefabs.set(prefab);
  run(document, renameScript(scene, 'Spin', 'Doors/Turn'));
  expect(sourceOf(document, 'Doors/Turn')).toBe(scriptTemplate('Turn'));
  expect(typesOf(objects[0])).toEqual(['Transform', 'Turn']);
  expect(objects[0].components[1]).toBeInstanceOf(UnknownComponent);
  expect(scene.prefabs.get(prefab.id)!.objects[0].components.map(({ type }) => type)).toContain('Turn');
  // only the folder changes
  run(document, renameAnyAsset(scene, 'Doors/Turn', 'Turn'));
  expect(typesOf(objects[0])).toEqual(['Transform', 'Turn']);
  expect(() => renameAnyAsset(scene, 'Turn', 'box')).toThrow('is there already');
});

it('keeps what triggers call and what clips animate when a script is renamed, in prefabs too', () => {
  const { document, objects } = quietDocument();
  const { scene } = document;
  document.commands.run(addScript(scene, 'Spin', objects).command);
  const own = objects[0].addComponent('EventTrigger', { method: 'Spin.turn' });
  const other = objects[0].addComponent('EventTrigger', { method: 'Spinner.turn' });
  objects[1].addComponent('EventTrigger', { method: 'Spin.toggle' });
  const clip = scene.assets.addFieldAsset('clip', 'Walk') as ClipAsset;
  const keys = [{ time: 0, value: 1 }];
  clip.setData({
    tracks: ['Spin', 'Light'].map((component) => ({ path: '', component, field: 'rate', keys })),
    events: [],
  });
  const { prefab } = makePrefab(objects[1]);
  scene.prefabs.set(prefab);
  run(document, renameScript(scene, 'Spin', 'Turn'));
  expect([own, other].map((each) => each.getAuthored('method'))).toEqual(['Turn.turn', 'Spinner.turn']);
  expect(clip.clip.tracks.map(({ component }) => component)).toEqual(['Turn', 'Light']);
  const values = scene.prefabs.get(prefab.id)!.objects[0].components.map(({ values: { method } }) => method);
  expect(values).toContain('Turn.toggle');
});

it('adds components of a script, and keeps them when the script is deleted', () => {
  const { document, objects } = quietDocument();
  const { scene } = document;
  document.commands.run(addScript(scene, 'Spin').command);
  run(document, addScriptComponent(scene, [objects[0]], 'Spin'));
  run(document, deleteAsset(scene, 'Spin'));
  expect(typesOf(objects[0])).toEqual(['Transform', 'Spin']);
  scene.assets.addFieldAsset('script', 'helpers', { source: 'export const one = 1;' });
  expect(() => addScriptComponent(scene, objects, 'helpers')).toThrow('has no component');
});

it('keeps imports where they lead when scripts are renamed and moved, and what else the text says', () => {
  const { document } = quietDocument();
  const { assets } = document;
  const add = (name: string, source: string): unknown => assets.addFieldAsset('script', name, { source });
  add('Tools/ease.ts', 'export const ease = 1;');
  add('Tools/wave', "import { ease } from './ease';\nexport const wave = ease;");
  add(
    'Door',
    `import { ease } from "./Tools/ease.ts";\nexport * from './Tools/wave'; // './Tools/other'\nimport './gone';`,
  );
  run(document, renameScript(document.scene, 'Tools/ease.ts', 'Math/Curves/easing.ts'));
  expect(sourceOf(document, 'Tools/wave')).toContain("from '../Math/Curves/easing'");
  expect(sourceOf(document, 'Door')).toBe(
    `import { ease } from "./Math/Curves/easing.ts";\nexport * from './Tools/wave'; // './Tools/other'\nimport './gone';`,
  );
  run(document, moveAssets(document.scene, ['Door', 'Tools/wave'], 'Math'));
  expect(sourceOf(document, 'Math/wave')).toContain("from './Curves/easing'");
  expect(sourceOf(document, 'Math/Door')).toContain(`from "./Curves/easing.ts";\nexport * from './wave'`);
  run(document, renameFolder(document.scene, 'Math/Curves', 'Curves'));
  expect(sourceOf(document, 'Math/wave')).toContain("from '../Curves/easing'");
  run(document, renameFolder(document.scene, 'Math', 'Curves/Deep'));
  expect(sourceOf(document, 'Curves/Deep/Door')).toContain(`from "../easing.ts";\nexport * from './wave'`);
});
