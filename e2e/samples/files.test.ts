/** Examples of the API's pages: each runs here, and is shown with its result as a comment. */
import { builtinComponents, GameObject, Light, ObjectRenderer, Scene } from '@farol/engine';
import {
  AddressRefusedError,
  assetFields,
  assetInFile,
  assetUses,
  cancellable,
  containerContent,
  createId,
  decodedUri,
  deserialize,
  FILE_VERSION,
  FileError,
  fieldAssetFields,
  fileLimits,
  foreignAddresses,
  inlineAssets,
  isContainer,
  lightExtrasOf,
  makeObjects,
  packFbx,
  parseFile,
  preloadFileCode,
  readableEndings,
  restoreComponent,
  restoreLights,
  serialize,
  serializeHead,
  serializeObject,
  showWhole,
  typeOfUrl,
  unpackLimits,
  writeContainer,
} from '@farol/engine/files';
import {
  applyPrefabEdit,
  changePrefab,
  fieldOverride,
  instanceRootOf,
  instantiatePrefab,
  isInstanceRoot,
  makePrefab,
  planApplyAll,
  planApplyField,
  planPrefabChange,
  planRevertAll,
  planUnpack,
  PrefabError,
  withoutPin,
} from '@farol/engine/prefabs';
import { PointLight } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { expect, test } from 'vitest';

test('scene files', async () => {
  await preloadFileCode(); // what follows then fetches nothing
  const scene = new Scene();
  const lamp = new GameObject('Lamp');
  lamp.addComponent(Light, { type: 'point', intensity: 5 });
  scene.add(lamp);
  expect(serializeHead(scene).objects.length).toBe(0);
  expect(serialize(scene).version).toBe(FILE_VERSION);

  const data = serializeObject(lamp);
  const [again] = makeObjects([data]);
  expect(again.name).toBe('Lamp');

  const light = restoreComponent({ type: 'Light', version: 1, values: { intensity: 2 } }, builtinComponents);
  expect(light.typeName).toBe('Light');

  const gold = scene.assets.addMaterial('Gold', { metalness: 1 });
  expect(assetInFile(gold).name).toBe('Gold');
});

test('what a file says', () => {
  expect(() => parseFile('{')).toThrow(FileError);
  expect(fileLimits.objects).toBe(1_000_000);
  expect(createId().length).toBe(12);

  const scene = new Scene();
  const box = new GameObject('Box');
  box.addComponent(ObjectRenderer, { mesh: 'box' });
  scene.add(box);
  const uses = assetUses(serialize(scene), builtinComponents);
  expect(uses.map(({ name }) => name)).toContain('box');

  const named = assetFields(ObjectRenderer.fields);
  expect(named.map(({ name }) => name)).toContain('mesh');
  expect(Object.keys(fieldAssetFields)).toContain('material');

  const assets = [{ name: 'wall', type: 'texture' as const, url: 'https://example.com/wall.png' }];
  expect(foreignAddresses({ assets }, 'https://farol.example/').length).toBe(1);

  const refused = new AddressRefusedError('wall', 'https://example.com/wall.png', 'https://example.com');
  expect(refused.origin).toBe('https://example.com');
});

test('containers', async () => {
  const scene = new Scene();
  const bytes = await writeContainer(containerContent(scene));
  expect(isContainer(bytes)).toBe(true);

  const alone = await inlineAssets(containerContent(scene)); // plain JSON, without files
  expect(alone.version).toBe(3);
  expect(unpackLimits.ratio).toBe(20);
});

test('files of assets', async () => {
  expect(typeOfUrl('models/street-lamp.glb')).toBe('model');
  expect(readableEndings).toContain('.glb');
  expect(decodedUri('wall%20paper.png')).toBe('wall paper.png');

  const files = new Map([['house/a.fbx', new File(['no FBX'], 'a.fbx')]]);
  await expect(packFbx(files, 'house/a.fbx')).rejects.toThrow('export it again as FBX 7.4');

  const loader = new GLTFLoader();
  loader.register(showWhole as never);
});

test('lights of models', () => {
  const lamp = new PointLight(0xffffff, 5, 20, 1); // fades otherwise than glTF's
  const extras = lightExtrasOf(lamp);
  lamp.userData.farolLight = extras; // as a glTF file gives it back
  restoreLights(lamp);
  expect(lamp.decay).toBe(1);
});

test('work that a user may stop', async () => {
  const stop = new AbortController();
  const making = cancellable(deserialize(serialize(new Scene())), stop.signal, (late) => late.dispose());
  stop.abort(new Error('stopped'));
  await expect(making).rejects.toThrow('stopped');
});

test('prefabs', () => {
  const scene = new Scene();
  const lamp = new GameObject('Lamp');
  const light = lamp.addComponent(Light, { intensity: 5 });
  scene.add(lamp);
  const { prefab, links } = makePrefab(lamp);
  changePrefab(scene, prefab);
  for (const [object, link] of links) object.prefabLink = link; // the lamp is an instance now
  const other = instantiatePrefab(prefab);
  scene.add(other);
  expect(instanceRootOf(other)).toBe(other);
  expect(isInstanceRoot(other)).toBe(true);

  light.set('intensity', 8);
  expect(fieldOverride(light, 'intensity')?.base).toBe(5);
  const plan = planApplyField(light, 'intensity');
  for (const each of plan.prefabs) scene.prefabs.set(each);
  for (const edit of plan.edits) applyPrefabEdit(edit);
  expect(other.getComponent(Light)?.intensity).toBe(8);

  const all = planApplyAll(lamp);
  expect(all.edits.length).toBe(0);
  expect(planRevertAll(other).length).toBe(0);
  expect(planPrefabChange(scene, prefab).prefabs.length).toBe(1);
  const link = withoutPin(other.prefabLink!, 'Light.intensity');
  expect(link.prefab).toBe(prefab.id);

  for (const edit of planUnpack(other)) applyPrefabEdit(edit);
  expect(other.prefabLink).toBe(null);
  expect(() => planApplyAll(other)).toThrow(PrefabError);
});
