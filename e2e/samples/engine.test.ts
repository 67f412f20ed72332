/** Examples of the API's pages: each runs here, and is shown with its result as a comment. */
import {
  bakeFields,
  bakeSources,
  isStaticWithoutLightmap,
  loadBakeCode,
  readBake,
  writeBake,
} from '@farol/engine/bake';
import {
  Animation,
  AssetError,
  AssetLibrary,
  CharacterController,
  ClipError,
  ClipPreview,
  Collider,
  effectFields,
  GameObject,
  Grabbable,
  importModel,
  Model,
  ModelRenderer,
  modelBelow,
  modelsBelow,
  morphField,
  objectOfPart,
  objectsByName,
  ParticleEmitter,
  parseClip,
  particlePreset,
  partsText,
  PhysicsSystem,
  isOfSubtree,
  Scene,
  shapeOf,
  ScriptAsset,
  type ShapeSource,
  sourceOfMaterial,
  subtreeOf,
  targetOfTrack,
  techniqueAbilities,
  trackTarget,
  Wall,
  whatKeepsTogether,
  XRRig,
} from '@farol/engine';
import { colliderShape, loadRapier } from '@farol/engine/physics';
import {
  materialAssetFields,
  type MaterialMap,
  type MaterialMapName,
  materialMaps,
  surfaceMaps,
  surfaceValueFields,
  uvFieldEndings,
} from '@farol/engine/fields';
import { resolveScript, givenScripts, takeGiven, typeNameOf } from '@farol/engine/scripts';
import { transformScript } from '@farol/engine/scripts/transform';
import { AnimationClip, ConeGeometry, Group, Mesh, MeshBasicMaterial, Object3D, VectorKeyframeTrack } from 'three';
import { expect, test } from 'vitest';

test('components', async () => {
  const scene = new Scene();
  const walker = new GameObject('Walker');
  walker.addComponent(CharacterController, { height: 1.8 });
  walker.addComponent(Animation, { clip: null, wrap: 'ping-pong', speed: 0.5 });
  scene.add(walker);
  expect(scene.componentsOf(CharacterController).length).toBe(1);

  const ball = new GameObject('Ball');
  ball.addComponent(Grabbable, { reach: 0.2 });
  scene.add(ball);

  const floor = new GameObject('Floor');
  floor.addComponent(XRRig, { speed: 2, turnStep: Math.PI / 4 });
  scene.add(floor);

  const fire = new GameObject('Fire');
  fire.addComponent(ParticleEmitter, await particlePreset('fire'));
  scene.add(fire);
});

test('shapes and physics', async () => {
  const scene = new Scene();
  const wall = new GameObject('Wall');
  const shape = shapeOf([wall.addComponent(Wall)]);
  expect(shape?.isBufferGeometry).toBe(true);

  const tent: ShapeSource = { shapeGeometry: new ConeGeometry(1, 1, 4) }; // of a component of yours
  expect(tent.shapeGeometry?.type).toBe('ConeGeometry');

  const box = wall.addComponent(Collider, { shape: 'box', fit: false, size: [1, 2, 0.2] });
  scene.add(wall);
  expect(colliderShape(box)?.kind).toBe('box');

  await loadRapier(); // the first simulated frame then has physics
  expect(scene.system(PhysicsSystem).steps).toBe(0);
});

test('objects and models', () => {
  const street = new GameObject('Street');
  const lamp = new GameObject('Lamp');
  street.add(lamp);
  expect(objectsByName(street).get('Lamp')).toBe(lamp);

  const root = new Group();
  const head = new Mesh();
  head.name = 'Head';
  root.add(head);
  const model = new Model(root, []);
  expect(whatKeepsTogether(model)).toBe(null);
  expect(objectOfPart([head])).toBe('Head');
  expect(partsText(root, [head])).toBe('Head');
  const subtree = subtreeOf(root, 'Head')!;
  expect(isOfSubtree(head, subtree)).toBe(true);

  const assets = new AssetLibrary();
  assets.register('robot', model);
  const scene = new Scene({ assets });
  const robot = new GameObject('Robot');
  robot.addComponent(ModelRenderer, { model: 'robot' });
  scene.add(robot);
  expect(modelBelow(robot, model)?.drawnModel).toBe(model);
  expect(modelsBelow(robot, model).length).toBe(1);

  const parts = importModel(model, assets, 'robot');
  expect(parts.children.length).toBe(1);
});

test('clips', () => {
  const node = new Object3D();
  node.name = 'Arm';
  const track = new VectorKeyframeTrack('Arm.position', [0, 1], [0, 0, 0, 0, 1, 0]);
  const model = new Model(new Group().add(node), [new AnimationClip('Raise', 1, [track])]);
  const [clip] = model.clips;
  expect(targetOfTrack(clip, track)?.property).toBe('position');

  const arm = new GameObject('Arm');
  const rise = { path: '', component: 'Transform', field: 'position', keys: [{ time: 0, value: [0, 2, 0] as const }] };
  expect(trackTarget(arm, rise).problem).toBe(null);

  const preview = new ClipPreview(arm);
  preview.show({ tracks: [rise], events: [] }, 0);
  expect(arm.object3D.position.y).toBe(2);

  expect(() => parseClip('{')).toThrow(ClipError);
});

test('assets', () => {
  const assets = new AssetLibrary();
  expect(() => assets.get('no such mesh')).toThrow(AssetError);

  const material = new MeshBasicMaterial();
  expect(sourceOfMaterial(material)).toBe(material);
  assets.addMaterial('Gold', { metalness: 1 });
  const spin = assets.addFieldAsset('script', 'Spin', { source: 'export default class {}' });
  expect(spin instanceof ScriptAsset).toBe(true);
});

test('tables of fields', () => {
  expect(Object.keys(effectFields)).toContain('ambientOcclusion');
  expect(Object.keys(bakeFields)).toContain('bakedLight');
  expect(Object.keys(materialAssetFields)).toContain('roughness');
  expect(Object.keys(materialMaps)).toContain('normalMap');
  const name: MaterialMapName = 'normalMap';
  const map: MaterialMap = materialMaps[name];
  expect(map.property).toBe('normalMap');
  expect(surfaceMaps.length).toBe(4);
  expect(Object.keys(surfaceValueFields)).toContain('surfaceMap1');
  expect(uvFieldEndings).toContain('RepeatX');
  expect(morphField('smile')).toBe('morph.smile');
});

test('techniques', () => {
  expect(techniqueAbilities({}, 'of a plugin')).toEqual({ depth: true, gbuffer: true, samples: true });
});

test('baked light', async () => {
  const sources = bakeSources(new Scene()); // what takes part in a bake
  expect(sources.lights.length).toBe(0);

  await loadBakeCode();
  const lightmap = { width: 1, height: 1, data: new Uint16Array(4) };
  const rest = { signature: '', lights: [], hasSky: false, channel: 1, meshes: [], probes: null };
  const bytes = await writeBake({ ...rest, lightmaps: [lightmap] });
  const baked = await readBake(bytes.buffer);
  expect(baked.data.lightmaps.length).toBe(1);
  expect(isStaticWithoutLightmap(new Object3D())).toBe(false);
});

test('scripts', () => {
  const names = new Set(['lamps/flicker', 'tools/helpers']);
  const has = (name: string): boolean => names.has(name);
  expect(resolveScript('../tools/helpers', 'lamps/flicker', has)).toBe('tools/helpers');
  expect(typeNameOf('lamps/flicker.ts')).toBe('flicker');

  givenScripts()['lamps/flicker'] = () => {};
  expect(takeGiven('lamps/flicker').length).toBe(0);

  const script = transformScript('Spin', 'export const turns: number = 2;');
  expect(script).toMatchObject({ name: 'Spin' });
});
