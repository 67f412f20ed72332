import {
  AnimationClip,
  BoxGeometry,
  ClampToEdgeWrapping,
  DataTexture,
  DirectionalLight,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  type Object3D,
  PerspectiveCamera,
  PointLight,
  RectAreaLight,
  SkinnedMesh,
  SpotLight,
  SRGBColorSpace,
  type Texture,
  VectorKeyframeTrack,
} from 'three';
import { expect, test } from 'vitest';
import { AssetLibrary } from '../assets/AssetLibrary';
import { MaterialAsset } from '../assets/MaterialAsset';
import { materialValuesOf } from '../assets/materialValuesOf';
import { Model } from '../assets/Model';
import { modelParts } from '../assets/modelParts';
import { createRandom } from '../base/createRandom';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { materialAssetFields } from '../assets/materialAssetFields';
import { randomFieldValue } from '../fields/randomFieldValue';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { Animator } from './Animator';
import { Light } from './Light';
import { ModelRenderer } from './ModelRenderer';
import { objectsOfModel, whatKeepsTogether } from './objectsOfModel';

/**
 * A model in the form of a glTF: a lamp on a rotated, mirrored arm, two meshes of one geometry, a camera, a sun, a
 * clip.
 */
function lampModel(): Model {
  const scene = new Group();
  const texture = new DataTexture(new Uint8Array(16), 2, 2);
  texture.name = 'Wood';
  texture.colorSpace = SRGBColorSpace;
  texture.repeat.set(2, 3);
  texture.offset.set(0.25, 0.5);
  texture.rotation = 0.3;
  texture.wrapS = ClampToEdgeWrapping;
  texture.channel = 1;
  const normals = texture.clone();
  normals.colorSpace = '';
  const wood = new MeshStandardMaterial({ name: 'Wood', map: texture, normalMap: normals, roughness: 0.3 });
  wood.normalScale.set(0.8, -0.8);
  const glass = new MeshPhysicalMaterial({
    name: 'Glass',
    transmission: 0.9,
    thickness: 0.2,
    attenuationDistance: 3,
    attenuationColor: 0x88ffcc,
    iridescence: 0.4,
    iridescenceThicknessMinimum: 150,
    iridescenceThicknessMaximum: 320,
    side: DoubleSide,
    transparent: true,
    opacity: 0.7,
    depthWrite: false,
  });
  const geometry = new BoxGeometry();
  const arm = new Group();
  arm.name = 'Arm';
  arm.position.set(1, 2, 3);
  arm.rotation.set(0.4, -0.9, 1.3);
  arm.scale.set(1, -2, 1);
  const head = new Mesh(geometry, glass);
  head.name = 'Head';
  head.position.set(0, 1, 0);
  const base = new Mesh(geometry, wood);
  base.name = 'Base';
  const bulb = new SpotLight(0xffcc88, 30, 12, 0.6, 0.4, 2);
  bulb.name = 'Bulb';
  bulb.target.position.set(0, 0, -1);
  bulb.add(bulb.target);
  const glow = new PointLight(0x88ccff, 4, 5, 2);
  const sun = new DirectionalLight(0xffffff, 2);
  sun.target.position.set(0, 0, -1);
  sun.add(sun.target);
  const camera = new PerspectiveCamera(40, 1.5, 0.2, 90);
  camera.name = 'Eye';
  arm.add(head, bulb, glow);
  scene.add(arm, base, sun, camera);
  const track = new VectorKeyframeTrack('Arm.position', [0, 1], [1, 2, 3, 5, 2, 3]);
  return new Model(scene, [new AnimationClip('Swing', 1, [track])]);
}

/** A scene, and a library with the loaded model. */
function placed() {
  const model = lampModel();
  const assets = new AssetLibrary();
  assets.register('Props/lamp.glb', model);
  for (const [asset, name] of modelParts(model, 'Props/lamp.glb')) assets.register(name, asset);
  return { model, assets, scene: new Scene({ assets }) };
}

interface Drawn {
  readonly matrix: number[];
  readonly what: unknown;
}

const rounded = (list: readonly number[]): number[] => list.map((each) => Math.round(each * 1e5) / 1e5 + 0);

const textureFacts = (texture: Texture): unknown => {
  if (texture.matrixAutoUpdate) texture.updateMatrix();
  const { source, colorSpace, wrapS, wrapT, channel, flipY, magFilter, minFilter } = texture;
  const shared = { source: source.uuid, colorSpace, wrapS, wrapT, channel, flipY, magFilter, minFilter };
  return { ...shared, matrix: rounded(texture.matrix.elements) };
};

/** All values of a material that its shader reads. */
function materialFacts(material: object): Record<string, unknown> {
  const facts: Record<string, unknown> = {};
  const skipped = /^(uuid|name|version|id|userData|_listeners|opacity|blend|forceSinglePass|envMap)/;
  for (const [key, value] of Object.entries(material)) {
    if (skipped.test(key) || typeof value === 'function') continue;
    const any = value as { isTexture?: boolean; toArray?: () => number[] } | null;
    if (any?.isTexture) facts[key] = textureFacts(value as Texture);
    else facts[key] = any?.toArray ? rounded(any.toArray().filter((each) => typeof each === 'number')) : value;
  }
  const { transparent, opacity } = material as MeshStandardMaterial;
  return { ...facts, opacity: transparent ? opacity : 1 };
}

/** Everything drawn or lit below an object, with its position. */
function drawn(root: Object3D): Drawn[] {
  root.updateWorldMatrix(true, true);
  const list: Drawn[] = [];
  root.traverseVisible((object) => {
    const matrix = rounded(object.matrixWorld.elements);
    if (object instanceof Mesh) {
      const { geometry, castShadow, receiveShadow } = object as Mesh;
      list.push({
        matrix,
        what: [geometry.uuid, castShadow, receiveShadow, materialFacts(object.material as MeshBasicMaterial)],
      });
    }
    if ('isLight' in object) {
      const { type, color, intensity, distance, angle, penumbra, decay, target } = object as SpotLight;
      const aim = target ? rounded(target.matrixWorld.elements.slice(12, 15)) : null;
      list.push({ matrix, what: [type, color.getHex(), intensity, distance, angle, penumbra, decay, aim] });
    }
  });
  return list;
}

function unpackInto(object: GameObject, { model, assets }: { model: Model; assets: AssetLibrary }): void {
  const { objects, materials } = objectsOfModel(model, assets, 'Props/lamp.glb', { materialFolder: 'Props/lamp/' });
  for (const { name, values } of materials) assets.addMaterial(name, values);
  for (const each of objects) object.add(each);
}

test('a model is drawn and lights the same as objects', () => {
  const { model, assets, scene } = placed();
  const object = new GameObject('Lamp');
  object.transform.position = [4, 0, -2];
  object.transform.rotation = [0, 0.7, 0];
  scene.add(object);
  const renderer = object.addComponent(ModelRenderer, { model: 'Props/lamp.glb' });
  const before = drawn(object.object3D);
  expect(before).toHaveLength(5);
  object.removeComponent(renderer);
  unpackInto(object, { model, assets });
  const after = drawn(object.object3D);
  const sorted = (list: Drawn[]): string[] => list.map((each) => JSON.stringify(each)).toSorted();
  expect(sorted(after)).toEqual(sorted(before));
  expect(assets.materialAssets.map(({ name }) => name)).toEqual(['Props/lamp/Glass', 'Props/lamp/Wood']);
  expect(object.find('Eye')!.getComponent('Camera')!.get('fov')).toBeCloseTo((40 * Math.PI) / 180, 10);
});

test('unpacked twice it shares its materials, and a material of that name that differs is left alone', () => {
  const { model, assets, scene } = placed();
  const [one, two] = ['One', 'Two'].map((name) => {
    const object = new GameObject(name);
    scene.add(object);
    unpackInto(object, { model, assets });
    return object;
  });
  const used = (object: GameObject): unknown => object.find('Base')!.getComponent('ObjectRenderer')!.get('material');
  expect(used(one)).toBe(used(two));
  assets.materialAsset('Props/lamp/Wood')!.set('roughness', 1);
  const three = new GameObject('Three');
  scene.add(three);
  unpackInto(three, { model, assets });
  expect(used(three)).toBe('Props/lamp/Wood 2');
});

test('what only a whole model can be is told', () => {
  expect(whatKeepsTogether(lampModel())).toBeNull();
  const skinned = lampModel();
  skinned.scene.add(new SkinnedMesh(new BoxGeometry(), new MeshBasicMaterial()));
  expect(whatKeepsTogether(skinned)).toBe('a skeleton');
});

test('a clip plays on the objects, found by name, and leaves them where they were', () => {
  const { model, assets, scene } = placed();
  const object = new GameObject('Lamp');
  scene.add(object);
  unpackInto(object, { model, assets });
  const animator = object.addComponent(Animator, { model: 'Props/lamp.glb', animation: 'Swing' });
  expect(animator.animations).toEqual(['Swing']);
  const arm = object.find('Arm')!;
  scene.update(0.5);
  expect(arm.transform.position[0]).toBeCloseTo(3, 5);
  expect(arm.transform.getAuthored('position')).toEqual([1, 2, 3]);
  scene.reset();
  expect(arm.transform.position).toEqual([1, 2, 3]);
});

test('saved and opened it is the same', async () => {
  const { model, assets, scene } = placed();
  const object = new GameObject('Lamp');
  scene.add(object);
  unpackInto(object, { model, assets });
  const file = serialize(scene);
  const copy = await deserialize(JSON.stringify(file), { assets });
  expect(serialize(copy)).toEqual(file);
  const sorted = (root: Object3D): string[] =>
    drawn(root)
      .map((each) => JSON.stringify(each))
      .toSorted();
  expect(sorted(copy.three)).toEqual(sorted(scene.three));
});

test.each([1, 2, 3, 4, 5])('any material of fields gives its fields back, seed %i', (seed) => {
  const random = createRandom(seed);
  const assets = new AssetLibrary();
  const kind = (['standard', 'phong', 'lambert', 'basic', 'physical'] as const)[seed - 1];
  const material = new MaterialAsset(assets, 'Any', { kind });
  for (const [name, field] of Object.entries(materialAssetFields)) {
    if (name === 'kind' || name === 'ambient') continue;
    if (field.kind === 'asset' && field.assetType !== 'texture') continue;
    material.set(name, randomFieldValue(field, random, ['brick', 'stone', 'wood']));
  }
  material.set('transparent', true);
  const textures = new Map(['brick', 'stone', 'wood'].map((name) => [assets.texture(name).source, name]));
  const values = materialValuesOf(material.three, (texture) => textures.get(texture.source) ?? null)!;
  const again = new MaterialAsset(assets, 'Again', values);
  expect(materialFacts(again.three)).toEqual(materialFacts(material.three));
});

test('a RectAreaLight and the extras of an exported light become lights with a shape; other extras do not', () => {
  const rectangle = new RectAreaLight(0xff0000, 3, 2, 0.5);
  const exported = new Group();
  exported.userData.farolLight = { type: 'tube', width: 1.5, height: -1, intensity: 8, other: 1 };
  const stray = new Group();
  stray.userData.farolLight = { type: 'spot', intensity: 'bright' };
  const model = new Model(new Group().add(rectangle, exported, stray), []);
  const lights = objectsOfModel(model, new AssetLibrary(), 'm').objects.map((each) => each.getComponent(Light));
  expect(lights[0]).toMatchObject({ type: 'rectangle', diffuse: [1, 0, 0], intensity: 3, width: 2, height: 0.5 });
  // invalid values are replaced by those of a new light
  expect(lights[1]).toMatchObject({ type: 'tube', width: 1.5, height: 1, intensity: 8 });
  expect(lights[2]).toBeNull();
});
