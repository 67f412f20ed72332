import {
  type DataTexture,
  type Mesh,
  MeshPhysicalMaterial,
  MeshStandardMaterial,
  NoColorSpace,
  SRGBColorSpace,
  type Texture,
} from 'three';
import { describe, expect, test } from 'vitest';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { createRandom } from '../base/createRandom';
import { randomFieldValue } from '../fields/randomFieldValue';
import { deserialize } from '../files/deserialize';
import { parseFile } from '../files/parseFile';
import { serialize } from '../files/serialize';
import { materialMapNames, materialMaps } from './materialMaps';

/** A scene of two objects that share the material 'Props/Brick'. */
function shared() {
  const scene = new Scene();
  const brick = scene.assets.addMaterial('Props/Brick', { kind: 'physical', map: 'brick' });
  const renderers = ['One', 'Two'].map((name) => {
    const object = new GameObject(name);
    scene.add(object);
    return object.addComponent(ObjectRenderer, { mesh: 'box', material: 'Props/Brick' });
  });
  const materialOf = (renderer: ObjectRenderer): MeshPhysicalMaterial => (renderer.three as Mesh).material as never;
  return { scene, brick, renderers, materialOf };
}

describe('a material of the library', () => {
  test('is one for all that use it, and changes on all of them', () => {
    const { brick, renderers, materialOf } = shared();
    const [one, two] = renderers.map(materialOf);
    expect(one).toBe(two);
    expect(one).toBeInstanceOf(MeshPhysicalMaterial);
    const { version } = one;
    brick.set('roughness', 0.25);
    brick.set('colour', [1, 0.5, 0]);
    expect(one.roughness).toBe(0.25);
    expect(one.color.toArray()).toEqual([1, 0.5, 0]);
    expect(one.version).toBe(version);
    brick.set('sheen', 0.5);
    brick.set('normalMap', 'brick-normal');
    expect(one.version).toBeGreaterThan(version);
  });

  test('of another kind is another one for three, on all that use it', () => {
    const { brick, renderers, materialOf } = shared();
    brick.set('kind', 'standard');
    const [one, two] = renderers.map(materialOf);
    expect(one).toBe(two);
    expect(one).toBe(brick.three);
    expect(one).not.toBeInstanceOf(MeshPhysicalMaterial);
    expect(one).toBeInstanceOf(MeshStandardMaterial);
  });

  test('has every map of the physical material, colours as sRGB and data as they are', () => {
    const { scene, brick } = shared();
    const material = new MeshPhysicalMaterial() as unknown as Record<string, unknown>;
    const known = Object.keys(material).filter((name) => /map$/i.test(name) && material[name] === null);
    const without = new Set(['envMap']);
    const properties = materialMapNames.map((name): string => materialMaps[name].property);
    expect(properties).toEqual(expect.arrayContaining(known.filter((name) => !without.has(name))));
    for (const name of materialMapNames) brick.set(name, 'brick');
    const made = brick.three as unknown as Record<string, Texture>;
    for (const name of materialMapNames) {
      const { property, kinds, isColour } = { isColour: false, ...materialMaps[name] };
      if (!(kinds as readonly string[]).includes('physical')) continue;
      expect(made[property].colorSpace, name).toBe(isColour ? SRGBColorSpace : NoColorSpace);
      expect(made[property].source).toBe(scene.assets.texture('brick').source);
    }
  });

  test('places each map by itself', () => {
    const { brick } = shared();
    const material = brick.three as MeshPhysicalMaterial;
    for (const [field, value] of Object.entries({ RepeatX: 4, RepeatY: 2, OffsetX: 0.5, Channel: 1, WrapX: 'clamp' })) {
      brick.set(`map${field}`, value);
    }
    brick.set('roughnessMap', 'brick');
    expect(material.map!.channel).toBe(1);
    const placeOf = (texture: Texture | null): number[] => texture!.matrix.elements.slice(0, 8).map((each) => each + 0);
    expect(placeOf(material.map)).toEqual([4, 0, 0, 0, 2, 0, 0.5, 0]);
    expect(material.map!.wrapS).not.toBe(material.map!.wrapT);
    expect(placeOf(material.roughnessMap)).toEqual([1, 0, 0, 0, 1, 0, 0, 0]);
  });

  test('refuses what its fields do not allow, and textures that nobody knows', () => {
    const { brick } = shared();
    expect(() => brick.set('roughness', 2)).toThrow('Props/Brick.roughness must be a finite number from 0 to 1');
    expect(() => brick.set('map', 'gone.png')).toThrow("names the texture 'gone.png', which is unknown");
    expect(() => brick.set('mesh', 'box')).toThrow('is unknown');
    expect(brick.get('map')).toBe('brick');
  });

  test('tells scenes of its changes', () => {
    const { scene, brick } = shared();
    const told: unknown[] = [];
    scene.onChange((change) => told.push(change));
    const { revision } = scene;
    brick.set('metalness', 1);
    expect(told).toEqual([{ kind: 'asset', asset: brick, field: 'metalness', before: 0 }]);
    expect(scene.revision).toBe(revision + 1);
  });

  test('leaves and comes back as it was', () => {
    const { scene, brick } = shared();
    const taken = scene.assets.take('Props/Brick');
    expect(scene.assets.list('material')).toEqual([]);
    scene.assets.restore(taken);
    expect(scene.assets.materialAsset('Props/Brick')).toBe(brick);
  });
});

describe('a name', () => {
  test('that changes takes the parts and the users along', () => {
    const { scene, brick, renderers, materialOf } = shared();
    expect([...scene.assets.rename('Props/Brick', 'Wall')]).toEqual([['Props/Brick', 'Wall']]);
    expect(brick.name).toBe('Wall');
    for (const renderer of renderers) renderer.material = 'Wall';
    brick.set('kind', 'basic');
    expect(materialOf(renderers[1])).toBe(brick.three);
  });

  test('that is taken, built in or unknown is refused', () => {
    const { scene } = shared();
    expect(() => scene.assets.rename('Props/Brick', 'box')).toThrow("'box' is there already");
    expect(() => scene.assets.rename('box', 'crate')).toThrow('came with Farol');
    expect(() => scene.assets.rename('gone', 'crate')).toThrow('is not in the library any more');
    expect(scene.assets.has('Props/Brick')).toBe(true);
  });
});

describe('in a file', () => {
  test('every field comes back, with folders', async () => {
    const { scene, brick } = shared();
    scene.assets.setFolder('Props/Empty', true);
    const random = createRandom(3);
    for (const [name, field] of Object.entries(brick.fields)) {
      if (name === 'surface') continue;
      brick.set(name, randomFieldValue(field, random, ['brick', 'stone-normal', 'wood']));
    }
    const file = serialize(scene);
    expect(file.assets.map(({ name, type }) => [name, type])).toContainEqual(['Props/Brick', 'material']);
    const copy = await deserialize(JSON.stringify(file));
    expect(serialize(copy)).toEqual(file);
    expect(copy.assets.materialAsset('Props/Brick')!.changedValues()).toEqual(brick.changedValues());
    expect(copy.assets.folders).toEqual(['Props/Empty']);
    const [renderer] = copy.componentsOf(ObjectRenderer);
    expect((renderer.three as Mesh).material).toBe(copy.assets.material('Props/Brick'));
  });

  test('what is wrong is told by its place', async () => {
    const { scene } = shared();
    const file = serialize(scene);
    const wrong = (values: Record<string, unknown>, folders?: unknown): unknown => ({
      ...file,
      ...(folders === undefined ? {} : { assetFolders: folders }),
      assets: [{ name: 'Props/Brick', type: 'material', values }],
    });
    expect(() => parseFile(wrong({ roughness: -1 }))).toThrow(/assets\[0\]\.values\.roughness must be a finite number/);
    expect(() => parseFile(wrong({ shine: 1 }))).toThrow(/assets\[0\]\.values\.shine is unknown/);
    expect(() => parseFile(wrong({}, ['a//b']))).toThrow(/assetFolders\[0\] must be a path/);
    await expect(deserialize(wrong({ map: 'gone.png' }))).rejects.toThrow(/assets\[0\]\.values\.map names the texture/);
    await expect(deserialize({ ...file, assets: [] })).rejects.toThrow(/material names the material 'Props\/Brick'/);
  });

  test('of before, with its materials in the objects, opens as it was', async () => {
    const scene = new Scene();
    const object = new GameObject('Old');
    scene.add(object);
    object.addComponent(ObjectRenderer, { kind: 'phong', map: 'stone', normalMap: 'stone-normal', repeat: 3 });
    const file = serialize(scene);
    expect(file).not.toHaveProperty('assetFolders');
    expect(file.assets).toEqual([]);
    expect(serialize(await deserialize(file))).toEqual(file);
  });
});

test('a colour picture as the normal map of an object is read as data', () => {
  const scene = new Scene();
  const picture = scene.assets.texture('stone') as DataTexture;
  const object = new GameObject('Wall');
  scene.add(object);
  const renderer = object.addComponent(ObjectRenderer, { map: 'stone', normalMap: 'stone' });
  const { map, normalMap } = (renderer.three as Mesh).material as MeshStandardMaterial;
  expect(map!.colorSpace).toBe(SRGBColorSpace);
  expect(normalMap!.colorSpace).toBe(NoColorSpace);
  expect(normalMap!.source).toBe(picture.source);
});
