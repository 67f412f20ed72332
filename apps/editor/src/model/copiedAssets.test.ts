import { builtinComponents, ComponentRegistry, GameObject, ObjectRenderer } from '@farol/engine';
import { serialize } from '@farol/engine/files';
import { instantiatePrefab, makePrefab } from '@farol/engine/prefabs';
import { expect, it } from 'vitest';
import type { ReadAsset } from './bringAssets';
import { assetsOfClip, copyObjects, pasteObjects } from './clip';
import { EditorDocument } from './EditorDocument';
import { scriptsInNode } from './testing/scriptsInNode';

const doorText = `import { asset, component, number, object } from '@farol/engine/fields';
import { speed } from './tools/speed';
export default class Door extends component({
  other: object(null, { help: 'Another object.' }),
  knob: asset('texture', null, { help: 'A texture.' }),
  rate: number(1, { help: 'A number.' }),
}) {
  get pace() {
    return speed * this.rate;
  }
}`;

const registry = (): ComponentRegistry =>
  new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });

const newDocument = (): EditorDocument => new EditorDocument(undefined, registry(), scriptsInNode());

const namesOf = ({ assets }: EditorDocument, type: 'script' | 'material'): string[] =>
  assets.fieldAssets(type).map(({ name }) => name);

/** A scene with a door that names another object, and a material with a file. */
async function doorScene(speed = 2): Promise<{ document: EditorDocument; objects: GameObject[] }> {
  const document = newDocument();
  const { assets, scene, scripts } = document;
  assets.addFieldAsset('script', 'tools/speed', { source: `export const speed = ${speed};` });
  assets.addFieldAsset('script', 'Door', { source: doorText });
  assets.registerFile('oak.png', new Blob(['oak']));
  assets.addMaterial('Wood', { map: 'oak.png', roughness: 0.7 });
  assets.addMaterial('Unused');
  await scripts.settled();
  const frame = new GameObject('Frame');
  frame.addComponent(ObjectRenderer, { material: 'Wood' });
  const door = new GameObject('Door');
  scene.add(frame);
  scene.add(door);
  door.addComponent('Door', { other: frame.id, knob: 'oak.png', rate: 3 });
  return { document, objects: [frame, door] };
}

/** Pastes copied objects into another document, then undoes and redoes it. */
async function paste(to: EditorDocument, copied: ReturnType<typeof copyObjects>): Promise<void> {
  const before = JSON.stringify(serialize(to.scene));
  const read = new Map<string, ReadAsset>();
  for (const { name, file } of assetsOfClip(copied.text)) {
    if (file === undefined || to.assets.has(name)) continue;
    to.assets.registerFile(name, copied.files.get(file)!);
    read.set(name, to.assets.take(name));
  }
  to.commands.run(pasteObjects(to.scene, copied.text, to.scene, [], { read }));
  const after = JSON.stringify(serialize(to.scene));
  to.commands.undo();
  expect(JSON.stringify(serialize(to.scene))).toBe(before);
  to.commands.redo();
  expect(JSON.stringify(serialize(to.scene))).toBe(after);
  await to.scripts.settled();
}

it('carries scripts, what they import, materials and files to another scene, where they run', async () => {
  const { document, objects } = await doorScene();
  const copied = copyObjects(document.scene, objects);
  expect([...assetsOfClip(copied.text)].map(({ name }) => name)).toEqual(['oak.png', 'Wood', 'tools/speed', 'Door']);
  expect(copied.files.size).toBe(1);
  // an unchanged file keeps its name on the clipboard
  expect([...copyObjects(document.scene, objects).files.keys()]).toEqual([...copied.files.keys()]);

  const other = newDocument();
  await paste(other, copied);
  expect(namesOf(other, 'script')).toEqual(['tools/speed', 'Door']);
  expect(namesOf(other, 'material')).toEqual(['Wood']);
  const door = other.scene.find('Door')!.getComponent('Door')!;
  expect(door).toBeInstanceOf(other.scripts.classOf('Door') as never);
  expect(door.authoredValues()).toMatchObject({ other: other.scene.find('Frame')!.id, knob: 'oak.png', rate: 3 });
  expect((door as unknown as { pace: number }).pace).toBe(6);
});

it('does not double what is equal, and gives what differs a name and a type of its own', async () => {
  const first = await doorScene();
  const other = newDocument();
  await paste(other, copyObjects(first.document.scene, first.objects));
  await paste(other, copyObjects(first.document.scene, first.objects));
  expect(namesOf(other, 'script')).toEqual(['tools/speed', 'Door']);
  expect(namesOf(other, 'material')).toEqual(['Wood']);

  const changed = await doorScene(10);
  changed.document.assets.materialAsset('Wood')!.set('roughness', 0.1);
  for (let i = 0; i < 2; i++) await paste(other, copyObjects(changed.document.scene, changed.objects));
  expect(namesOf(other, 'script')).toEqual(['tools/speed', 'Door', 'tools/speed 2', 'Door 2']);
  expect(namesOf(other, 'material')).toEqual(['Wood', 'Wood 2']);
  expect(other.assets.fieldAsset('Door 2')!.get('source')).toContain("from './tools/speed 2'");
  expect(other.assets.fieldAsset('Door 2')!.get('source')).toContain('class Door2 extends');
  const paces = ['Door', 'Door 2', 'Door 3', 'Door 4'].map((name) => {
    const door = other.scene.find(name)!.components[1];
    return [door.typeName, (door as unknown as { pace: number }).pace];
  });
  expect(paces).toEqual([
    ['Door', 6],
    ['Door', 6],
    ['Door 2', 30],
    ['Door 2', 30],
  ]);
  expect(other.scene.find('Frame 3')!.getComponent(ObjectRenderer)!.material).toBe('Wood 2');
});

it('a material is not the one of its name that has one change more, or one less', async () => {
  for (const opacities of [
    [1, 0.5],
    [0.5, 1],
  ]) {
    const { document, objects } = await doorScene();
    const other = newDocument();
    for (const opacity of opacities) {
      document.assets.materialAsset('Wood')!.set('opacity', opacity);
      await paste(other, copyObjects(document.scene, objects));
    }
    expect(namesOf(other, 'material')).toEqual(['Wood', 'Wood 2']);
  }
});

it('gives a declared type another name, too', async () => {
  const declared = doorText
    .replace("import { speed } from './tools/speed';\n", 'const speed = 1;')
    .replace('  get pace', "  static override readonly typeName: string = 'Gate';\n  get pace");
  const documents = [1, 2].map(() => newDocument());
  for (const [i, { assets, scene, scripts }] of documents.entries()) {
    assets.addFieldAsset('script', 'Door', { source: declared.replace('number(1', `number(${i + 1}`) });
    await scripts.settled();
    const door = new GameObject('Door');
    scene.add(door);
    door.addComponent('Gate');
  }
  const copied = copyObjects(documents[1].scene, [documents[1].scene.find('Door')!]);
  for (let i = 0; i < 2; i++) await paste(documents[0], copied);
  expect(namesOf(documents[0], 'script')).toEqual(['Door', 'Door 2']);
  const gates = documents[0].scene.roots.map(({ components }) => [components[1].typeName, components[1].get('rate')]);
  expect(gates).toEqual([
    ['Gate', 1],
    ['Gate 2', 2],
    ['Gate 2', 2],
  ]);
});

it('carries what components name whose scripts are off', async () => {
  const { document, objects } = await doorScene();
  document.scripts.isOn = false;
  const copied = copyObjects(document.scene, [objects[1], objects[0]]);
  expect([...assetsOfClip(copied.text)].map(({ name }) => name).toSorted()).toEqual(
    ['Door', 'Wood', 'oak.png', 'tools/speed'].toSorted(),
  );
  const other = newDocument();
  other.scripts.isOn = false;
  await paste(other, copied);
  const frame = other.scene.find('Frame')!;
  expect(other.scene.find('Door')!.getComponent('Door')!.get('other')).toBe(frame.id);
  expect(frame.id).not.toBe(objects[0].id);
});

it('leaves out what could not be read', async () => {
  const { document, objects } = await doorScene();
  const copied = copyObjects(document.scene, objects);
  const other = newDocument();
  other.commands.run(pasteObjects(other.scene, copied.text, other.scene, [], { read: new Map([['oak.png', null]]) }));
  await other.scripts.settled();
  expect(other.assets.materialAsset('Wood')!.changedValues()).toEqual({ roughness: 0.7 });
  expect(other.scene.find('Door')!.getComponent('Door')!.get('knob')).toBeNull();
});

it('carries prefabs, those within them and what they use; a scene that has them keeps its own', async () => {
  const from = newDocument();
  from.assets.addMaterial('Wood', { roughness: 0.7 });
  const lamp = new GameObject('Lamp');
  lamp.addComponent(ObjectRenderer, { material: 'Wood' });
  from.scene.add(lamp);
  const inner = makePrefab(lamp);
  from.scene.prefabs.set(inner.prefab);
  const post = new GameObject('Post');
  post.add(instantiatePrefab(inner.prefab, from.scene.registry));
  from.scene.add(post);
  const outer = makePrefab(post);
  from.scene.prefabs.set(outer.prefab);
  const instance = instantiatePrefab(outer.prefab, from.scene.registry);
  instance.name = 'Corner';
  from.scene.add(instance);
  const copied = copyObjects(from.scene, [instance]);

  const other = newDocument();
  other.assets.addMaterial('Wood', { roughness: 0.2 });
  await paste(other, copied);
  expect(other.scene.prefabs.list.map(({ name }) => name)).toEqual(['Lamp', 'Post']);
  const copy = other.scene.find('Corner')!;
  expect(copy.prefabLink?.prefab).toBe(outer.prefab.id);
  const [made] = instantiatePrefab(other.scene.prefabs.get(outer.prefab.id)!, other.scene.registry).children;
  // a different 'Wood' exists: prefab and instance use the pasted material's new name
  expect(made.getComponent(ObjectRenderer)!.material).toBe('Wood 2');
  expect(copy.children[0].getComponent(ObjectRenderer)!.material).toBe('Wood 2');

  const own = other.scene.prefabs.list;
  await paste(other, copied);
  expect(other.scene.prefabs.list).toEqual(own);
  const bad = JSON.parse(copied.text) as { prefabs: { id: string; objects: unknown[] }[] };
  bad.prefabs.push({ id: 'x', objects: [] });
  expect(() => pasteObjects(other.scene, JSON.stringify(bad), other.scene, [])).toThrow(/prefabs/);
});
