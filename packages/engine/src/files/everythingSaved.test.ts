import { expect, test } from 'vitest';
import '../components/index';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { instantiatePrefab } from '../prefabs/instantiatePrefab';
import { makePrefab } from '../prefabs/makePrefab';
import { deserialize } from './deserialize';
import { FILE_VERSION, type FarolFile, type FileComponent, type FileObject, type Prefab } from './FarolFile';
import { serialize } from './serialize';

/** Names of a type's properties other than methods. */
type PropertyOf<T> = { [P in keyof T]: T[P] extends (...values: never) => unknown ? never : P }[keyof T];

/** A non-default value that files keep, or the reason why no file holds the property. */
type Row<P extends PropertyOf<GameObject>> = { readonly saved: GameObject[P] } | { readonly notSaved: string };

/** Every property of an object: a property that is added to GameObject and not listed here is a type error. */
const properties: { readonly [P in PropertyOf<GameObject>]: Row<P> } = {
  name: { saved: 'Lamp' },
  tags: { saved: ['lamp', 'far'] },
  prefabLink: { saved: { prefab: 'lantern', source: 'lantern', pinned: ['active'] } },
  active: { saved: false },
  locked: { saved: true },
  isStatic: { saved: true },
  id: { notSaved: 'given to the constructor: saved as `id`, see the whole file' },
  parent: { notSaved: 'cannot be assigned: saved as `parent`, see the whole file' },
  children: { notSaved: 'cannot be assigned: each child saves its parent' },
  components: { notSaved: 'cannot be assigned: saved as `components`, see the whole file' },
  transform: { notSaved: 'the first of the components' },
  scene: { notSaved: 'the scene that the file is loaded as' },
  lockedInHierarchy: { notSaved: 'follows from `locked`, here and above' },
  activeInHierarchy: { notSaved: 'follows from `active`, here and above' },
  object3D: { notSaved: 'made with the object' },
  threeParent: { notSaved: 'the `object3D`' },
  container: { notSaved: 'the parent or the scene' },
  sceneOf: { notSaved: 'the scene' },
  childList: { notSaved: 'the children' },
};

const saved = Object.entries(properties).flatMap(([name, row]) =>
  'saved' in row ? [[name as PropertyOf<GameObject>, row.saved] as const] : [],
);

/** Makes a scene with a lantern that is an instance of the prefab `lantern`. */
function makeLantern(): { scene: Scene; lantern: GameObject } {
  const scene = new Scene();
  const lantern = new GameObject('Lantern');
  scene.add(lantern);
  scene.prefabs.set(makePrefab(lantern, 'Lantern', 'lantern').prefab);
  return { scene, lantern };
}

test.each(saved)('%s of an object is kept by a file, a copy, a prefab and a reset', async (name, value) => {
  const { scene, lantern } = makeLantern();
  const initial = lantern[name];
  expect(initial, 'the value is no other than the default').not.toEqual(value);
  const told: string[] = [];
  scene.onChange((change) => told.push(change.kind));
  Object.assign(lantern, { [name]: value });
  expect(told, 'drafts and panels hear of it').toContain('object');

  const loaded = await deserialize(JSON.stringify(serialize(scene)));
  expect(loaded.roots[0][name], 'loaded').toEqual(value);
  expect(lantern.clone()[name], 'copied').toEqual(value);
  if (name !== 'prefabLink') {
    const { prefab } = makePrefab(lantern);
    expect(instantiatePrefab(prefab)[name], 'made of a prefab').toEqual(value);
  }
  Object.assign(lantern, { [name]: initial });
  scene.keepAuthored();
  Object.assign(lantern, { [name]: value });
  scene.reset();
  expect(lantern[name], 'reset').toEqual(initial);
});

const view = { name: 'Door', position: [1, 2, 3], target: [0, 0, 0.5], fov: 1, orthographic: true } as const;

const light: Required<FileComponent> = {
  type: 'Light',
  version: 1,
  id: 'lamp:Light',
  enabled: false,
  values: { intensity: 7 },
};

/** An object with every member that a file allows, none with its default. */
const lamp: Required<FileObject> = {
  id: 'lamp',
  name: 'Lamp',
  parent: 'eye',
  active: false,
  locked: true,
  static: true,
  tags: ['lamp', 'far'],
  prefab: { prefab: 'lantern', source: 'lantern', pinned: ['active'] },
  components: [{ type: 'Transform', version: 1, id: 'lamp:Transform', values: { position: [1, 2, 3] } }, light],
};

const prefab: Required<Prefab> = {
  id: 'lantern',
  name: 'Lantern',
  objects: [
    {
      ...{ id: 'lantern', name: 'Lantern', parent: null, active: false },
      components: [{ type: 'Transform', version: 1, id: 'lantern:Transform', values: {} }],
    },
  ],
};

/** A file with every member that is allowed, none with its default. */
const file: Required<FarolFile> = {
  format: 'farol-scene',
  version: FILE_VERSION,
  name: 'Everything',
  settings: { exposure: 2 },
  activeCamera: 'eye',
  assets: [{ name: 'Props/gold', type: 'material', values: { metalness: 1 } }],
  assetFolders: ['Props'],
  microShaders: { 'own/tint': 'vec3 tint;\n' },
  picture: { url: 'data:image/webp;base64,UklGRg==', chosen: true },
  views: [{ place: 7, ...view }],
  prefabs: [prefab],
  objects: [
    {
      ...{ id: 'eye', name: 'Eye', parent: null },
      components: [
        { type: 'Transform', version: 1, id: 'eye:Transform', values: {} },
        { type: 'Camera', version: 1, id: 'eye:Camera', values: { fov: 1 } },
      ],
    },
    lamp,
  ],
};

test('every member of a file is read and written again', async () => {
  expect(serialize(await deserialize(JSON.stringify(file)))).toEqual(file);
});
