import { getSurfaces } from '@farol/renderer/surfaces';
import { BoxGeometry, type Color, Group, Mesh, MeshStandardMaterial, ShaderMaterial, Texture } from 'three';
import { beforeAll, describe, expect, test } from 'vitest';
import { Model } from '../assets/Model';
import { surfaceCode } from '../assets/surfaceCode';
import type { SurfaceAsset } from '../assets/SurfaceAsset';
import { lightmappedMaterial } from '../core/baked/lightmappedMaterial';
import { Animation } from './Animation';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { ModelRenderer } from './ModelRenderer';
import { ObjectRenderer } from './ObjectRenderer';
import type { ClipAsset } from '../assets/clips/ClipAsset';

const RUST = `uniform float amount; // = 0.25 [0, 1, 0.01] Amount
uniform vec3 rustColor; // = #ff0000 Rust
uniform vec2 way; // = 1, 0 Way
void surface(inout SurfaceData s) { s.color = mix(s.color, rustColor, amount * way.x); }
`;
const WAVES = `uniform float height; // = 0.5 [0, 2] Height
// reach: 0.25 + 2 * height
void displace(inout VertexData v) { v.positionOS.y += height; }
`;

function made() {
  const scene = new Scene();
  const { assets } = scene;
  const rust = assets.addFieldAsset('surface', 'Rust', { source: RUST }) as SurfaceAsset;
  const waves = assets.addFieldAsset('surface', 'Waves', { source: WAVES }) as SurfaceAsset;
  const box = (name: string, values = {}): ObjectRenderer => {
    const object = new GameObject(name);
    scene.add(object);
    return object.addComponent(ObjectRenderer, { mesh: 'box', ...values });
  };
  return { scene, assets, rust, waves, box };
}

const materialOf = (renderer: ObjectRenderer) => renderer.three!.material as MeshStandardMaterial;
const wornBy = (renderer: ObjectRenderer) => getSurfaces(materialOf(renderer));

beforeAll(() => surfaceCode.load());

describe('an object that wears a surface by itself', () => {
  test('has its uniforms as fields; nothing of its material is changed, and others of it keep theirs', () => {
    const { assets, box, scene } = made();
    const steel = assets.addMaterial('Steel', { colour: [0.2, 0.2, 0.2] });
    const [one, other] = [box('One', { material: 'Steel' }), box('Other', { material: 'Steel' })];
    one.surface = 'Rust';
    expect(Object.keys(one.fields).filter((name) => name.startsWith('surface.'))).toEqual([
      'surface.amount',
      'surface.rustColor',
      'surface.way.x',
      'surface.way.y',
    ]);
    expect(materialOf(other)).toBe(steel.three);
    expect(getSurfaces(steel.three)).toEqual([]);
    expect(wornBy(one)[0].uniforms.amount.value).toBe(0.25);
    one.set('surface.amount', 0.75);
    one.set('surface.rustColor', [0, 1, 0]);
    one.set('surface.way.y', 3);
    expect(wornBy(one)[0].uniforms.amount.value).toBe(0.75);
    expect(wornBy(one)[0].uniforms.rustColor.value).toMatchObject({ r: 0, g: 1, b: 0 });
    expect(wornBy(one)[0].uniforms.way.value).toMatchObject({ x: 1, y: 3 });
    expect(() => one.set('surface.amount', 2)).toThrow(
      'ObjectRenderer.surface.amount must be a finite number from 0 to 1',
    );
    expect(() => one.set('surface.gone', 2)).toThrow('surface.gone is unknown');
    expect(() => one.simulate('surface.gone', 2)).toThrow('surface.gone is unknown');
    // all other values follow the material
    steel.set('colour', [1, 0, 0]);
    expect(materialOf(one).color).toMatchObject({ r: 1, g: 0, b: 0 });
    one.surface = null;
    expect(materialOf(one)).toBe(steel.three);
    expect(assets.layered.size).toBe(0);
    scene.dispose();
  });

  test('objects of equal values share a material, which is disposed of with the last one', () => {
    const { assets, box, scene } = made();
    const boxes = ['a', 'b', 'c'].map((name) => box(name, { surface: 'Rust' }));
    expect(new Set(boxes.map(materialOf)).size).toBe(1);
    let disposed = 0;
    materialOf(boxes[0]).addEventListener('dispose', () => disposed++);
    boxes[0].set('surface.amount', 0.5);
    expect(materialOf(boxes[0])).not.toBe(materialOf(boxes[1]));
    expect(assets.layered.size).toBe(2);
    // a material of a single user is changed in place
    const own = materialOf(boxes[0]);
    boxes[0].set('surface.amount', 0.625);
    expect(materialOf(boxes[0])).toBe(own);
    boxes[0].set('surface.amount', 0.25);
    expect(new Set(boxes.map(materialOf)).size).toBe(1);
    expect(assets.layered.size).toBe(1);
    expect(disposed).toBe(0);
    for (const { gameObject } of boxes) gameObject.dispose();
    expect(disposed).toBe(1);
    expect(assets.layered.size).toBe(0);
    expect(assets.materials.size).toBe(0);
    scene.dispose();
  });

  test('goes over what the material wears, which keeps its own values; the same surface takes the place of that one', () => {
    const { assets, box } = made();
    const sea = assets.addMaterial('Sea', { surface: 'Waves' });
    const one = box('One', { material: 'Sea', surface: 'Rust' });
    expect(wornBy(one).map(({ surface }) => surface.name)).toEqual(['Waves', 'Rust']);
    sea.set('surface.height', 1.5);
    expect(wornBy(one)[0].uniforms.height.value).toBe(1.5);
    one.surface = 'Waves';
    expect(wornBy(one).map(({ surface }) => surface.name)).toEqual(['Waves']);
    expect(wornBy(one)[0].uniforms.height.value).toBe(0.5);
    expect(getSurfaces(sea.three)[0].uniforms.height.value).toBe(1.5);
    one.surface = 'Rust';
    sea.set('surface', null);
    expect(wornBy(one).map(({ surface }) => surface.name)).toEqual(['Rust']);
    sea.set('kind', 'phong');
    expect(materialOf(one).type).toBe('MeshPhongMaterial');
    expect(wornBy(one)).toHaveLength(1);
  });

  test('follows the text of its surface; a material that cannot wear one is drawn as it is', () => {
    const { assets, box, rust } = made();
    assets.register('own', new ShaderMaterial());
    const one = box('One', { surface: 'Rust' });
    one.set('surface.amount', 0.5);
    rust.set('source', `uniform float more; // = 4\n${RUST}`);
    expect(one.get('surface.more')).toBe(4);
    expect(wornBy(one)[0].uniforms.more.value).toBe(4);
    expect(wornBy(one)[0].uniforms.amount.value).toBe(0.5);
    rust.set('source', 'void surface(');
    expect(rust.problem).not.toBe(null);
    expect(wornBy(one)[0].uniforms.amount.value).toBe(0.5);
    one.shader = 'own';
    expect(materialOf(one)).toBe(assets.shader('own'));
  });

  test('is drawn where its vertices may lie: the bounds grow by the reach that the text declares', () => {
    const { assets, box, waves } = made();
    const one = box('One', { surface: 'Waves' });
    const mesh = one.three as Mesh & { boundingSphere?: { radius: number } };
    const radius = (mesh.geometry.computeBoundingSphere(), mesh.geometry.boundingSphere!.radius);
    expect(mesh.frustumCulled).toBe(true);
    expect(mesh.boundingSphere!.radius).toBeCloseTo(radius + 1.25, 9);
    one.set('surface.height', 2);
    expect(mesh.boundingSphere!.radius).toBeCloseTo(radius + 4.25, 9);
    one.simulate('surface.height', 1);
    expect(mesh.boundingSphere!.radius).toBeCloseTo(radius + 2.25, 9);
    one.endSimulation();
    waves.set('source', WAVES.replace('// reach', '// no reach'));
    expect(mesh.frustumCulled).toBe(false);
    one.surface = null;
    expect(mesh.frustumCulled).toBe(true);
    expect(mesh.boundingSphere ?? null).toBe(null);
    waves.set('source', WAVES);
    assets.addMaterial('Sea', { surface: 'Waves' });
    one.material = 'Sea';
    expect(mesh.boundingSphere!.radius).toBeCloseTo(radius + 1.25, 9);
    assets.materialAsset('Sea')!.set('surface.height', 2);
    expect(mesh.boundingSphere!.radius).toBeCloseTo(radius + 4.25, 9);
  });

  test('is copied, and goes through files', async () => {
    const { scene, box } = made();
    const one = box('One', { surface: 'Rust' });
    one.set('surface.amount', 0.75);
    const copy = one.gameObject.clone();
    scene.add(copy);
    const again = copy.getComponent(ObjectRenderer)!;
    expect(again.get('surface.amount')).toBe(0.75);
    expect(materialOf(again)).toBe(materialOf(one));
    const file = serialize(scene);
    const values = file.objects[0].components.find(({ type }) => type === 'ObjectRenderer')!.values;
    expect(values).toEqual({ surface: 'Rust', surfaceValues: '{"amount":0.75}' });
    const read = await deserialize(JSON.stringify(file));
    const opened = read.roots[0].getComponent(ObjectRenderer)!;
    expect(opened.get('surface.amount')).toBe(0.75);
    expect(wornBy(opened)[0].uniforms.amount.value).toBe(0.75);
  });

  test('wears it with a lightmap too', () => {
    const { assets, box } = made();
    const sea = assets.addMaterial('Sea', { surface: 'Waves' });
    const one = box('One', { material: 'Sea', surface: 'Rust' });
    const lightmapped = [sea.three, materialOf(one)].map((each) => lightmappedMaterial(each, new Texture()));
    expect(lightmapped.map((each) => getSurfaces(each).length)).toEqual([1, 2]);
  });

  test('instances of equal values are one group', () => {
    const { scene, box } = made();
    for (const name of ['a', 'b', 'c']) box(name, { surface: 'Rust', instanced: true });
    scene.three.updateMatrixWorld();
    const groups = scene.three.children.filter((each) => 'isInstancedMesh' in each) as unknown as Mesh[];
    expect(groups).toHaveLength(1);
    expect(getSurfaces(groups[0].material as MeshStandardMaterial)[0].surface.name).toBe('Rust');
    expect(groups[0].frustumCulled).toBe(true);
  });

  test('instances whose vertices may lie elsewhere are drawn wherever they are', () => {
    const { scene, box } = made();
    box('a', { surface: 'Waves', instanced: true });
    scene.three.updateMatrixWorld();
    expect(scene.three.children.find((each) => 'isInstancedMesh' in each)!.frustumCulled).toBe(false);
  });
});

describe('a model that wears a surface', () => {
  const model = () => {
    const root = new Group();
    const body = new MeshStandardMaterial({ name: 'Body' });
    const glass = new MeshStandardMaterial({ name: 'Glass' });
    root.add(new Mesh(new BoxGeometry(), body), new Mesh(new BoxGeometry(), glass), new Mesh(new BoxGeometry(), body));
    return { model: new Model(root, []), body, glass };
  };

  test('all parts wear it, or those of one material; the materials of the asset stay as they are', () => {
    const { scene, assets } = made();
    const { model: car, body, glass } = model();
    assets.register('car', car);
    const object = new GameObject('Car');
    scene.add(object);
    const renderer = object.addComponent(ModelRenderer, { model: 'car', surface: 'Rust' });
    const names = (): string[][] =>
      renderer.three!.children.map((child) =>
        getSurfaces((child as Mesh).material as MeshStandardMaterial).map(({ surface }) => surface.name),
      );
    expect(names()).toEqual([['Rust'], ['Rust'], ['Rust']]);
    expect(renderer.materials).toEqual(['Body', 'Glass']);
    renderer.surfaceMaterial = 'Glass';
    expect(names()).toEqual([[], ['Rust'], []]);
    expect((renderer.three!.children[0] as Mesh).material).toBe(body);
    renderer.set('surface.amount', 1);
    renderer.simulate('surface.amount', 0.5);
    const [worn] = getSurfaces((renderer.three!.children[1] as Mesh).material as MeshStandardMaterial);
    expect(worn.uniforms.amount.value).toBe(0.5);
    expect(getSurfaces(glass)).toEqual([]);
    renderer.surface = null;
    expect(names()).toEqual([[], [], []]);
    expect(assets.layered.size).toBe(0);
  });
});

test('objects and models share their materials again after a simulation gave one of them values of its own', () => {
  const { scene, assets, box } = made();
  const cube = new Group();
  cube.add(new Mesh(new BoxGeometry(), new MeshStandardMaterial()));
  assets.register('cube', new Model(cube, []));
  const modelOf = (name: string): ModelRenderer => {
    const object = new GameObject(name);
    scene.add(object);
    return object.addComponent(ModelRenderer, { model: 'cube', surface: 'Rust' });
  };
  const models = ['One', 'Two'].map(modelOf);
  const boxes = ['Three', 'Four'].map((name) => box(name, { surface: 'Rust' }));
  const drawnBy = (renderer: ModelRenderer | ObjectRenderer): unknown =>
    ((renderer.three!.children[0] ?? renderer.three) as Mesh).material;
  for (const [one, other] of [models, boxes]) {
    const shared = drawnBy(one);
    expect(drawnBy(other)).toBe(shared);
    // the second value is the authored one
    for (const last of [0.75, 0.25]) {
      for (const amount of [0.5, last]) one.simulate('surface.amount', amount);
      expect(drawnBy(one)).not.toBe(shared);
      one.endSimulation();
      expect(drawnBy(one)).toBe(shared);
      expect(getSurfaces(shared as MeshStandardMaterial)[0].uniforms.amount.value).toBe(0.25);
    }
  }
  scene.dispose();
});

describe('tracks of uniforms', () => {
  const COUNT = 1000;

  test('1,000 objects play values of their own: the materials are made once, and written to', () => {
    const { scene, assets, box } = made();
    const keys = (from: unknown, to: unknown) => [
      { time: 0, value: from },
      { time: 2, value: to },
    ];
    const clip = JSON.stringify({
      tracks: [
        { path: '', component: 'ObjectRenderer', field: 'surface.amount', keys: keys(0, 1) },
        { path: '', component: 'ObjectRenderer', field: 'surface.way.x', keys: keys(2, 4) },
        { path: '', component: 'ObjectRenderer', field: 'surface.rustColor', keys: keys([0, 0, 0], [1, 0, 0]) },
      ],
    });
    const data = assets.addFieldAsset('clip', 'Rusts') as ClipAsset;
    data.set('duration', 2);
    data.set('data', clip);
    const boxes = Array.from({ length: COUNT }, (_, i) => box(`Box ${i}`, { surface: 'Rust' }));
    boxes.forEach(({ gameObject }, i) =>
      gameObject.addComponent(Animation, { clip: 'Rusts', startTime: (i % 10) * 0.1 }),
    );
    expect(assets.layered.size).toBe(1);
    scene.update(0.5);
    scene.update(0.25);
    expect(assets.layered.size).toBe(COUNT);
    const materials = boxes.map(materialOf);
    const versions = materials.map(({ version }) => version);
    const amounts = (): number[] => boxes.map((each) => wornBy(each)[0].uniforms.amount.value as number);
    const before = amounts();
    const vectors = boxes.map((each) => wornBy(each)[0].uniforms.way.value);
    scene.update(0.25);
    expect(boxes.map(materialOf).every((material, i) => material === materials[i])).toBe(true);
    expect(materials.map(({ version }) => version)).toEqual(versions);
    expect(boxes.every((each, i) => wornBy(each)[0].uniforms.way.value === vectors[i])).toBe(true);
    expect(boxes[0].get('surface.amount')).toBeCloseTo(0.5, 9);
    expect(amounts()[0]).toBeCloseTo(0.5, 9);
    expect(wornBy(boxes[0])[0].uniforms.way.value).toMatchObject({ x: expect.closeTo(3, 9), y: 0 });
    expect((wornBy(boxes[0])[0].uniforms.rustColor.value as Color).r).toBeCloseTo(0.5, 9);
    expect(new Set(before.map((each) => each.toFixed(3))).size).toBe(10);
    scene.reset();
    expect(assets.layered.size).toBe(1);
    expect(amounts().every((each) => each === 0.25)).toBe(true);
  });
});
