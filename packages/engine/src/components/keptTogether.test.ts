import {
  AnimationClip,
  BoxGeometry,
  Color,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  NumberKeyframeTrack,
  Object3D,
  PointLight,
  Quaternion,
  QuaternionKeyframeTrack,
  Vector3,
  VectorKeyframeTrack,
} from 'three';
import { describe, expect, test } from 'vitest';
import { AssetLibrary } from '../assets/AssetLibrary';
import { Model } from '../assets/Model';
import { partsText, pathOfNode, subtreeOf } from '../assets/modelNodes';
import { modelParts } from '../assets/modelParts';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { Animation } from './Animation';
import { isUnpackable, keptTogether } from './keptTogether';
import { ModelRenderer } from './ModelRenderer';
import { ObjectRenderer } from './ObjectRenderer';
import { objectsOfModel } from './objectsOfModel';
import { armature, skinnedBox } from './testing/skinnedBox';

const named = <T extends Object3D>(object: T, name: string): T => Object.assign(object, { name });

const material = new MeshStandardMaterial({ name: 'Plain' });

/**
 * A rotated hall: table, lamp with a morphing shade, instanced chairs, man (mesh beside his bones), dog (mesh within).
 */
function hall(): Model {
  const scene = new Group();
  const room = named(new Group(), 'Hall');
  room.position.set(1, 2, 3);
  room.rotation.set(0.2, 0.5, -0.1);
  const table = named(new Mesh(new BoxGeometry(2, 1, 1), material), 'Table');
  const lamp = named(new Group(), 'Lamp');
  lamp.position.set(0, 3, 0);
  const shadeGeometry = new BoxGeometry();
  shadeGeometry.morphAttributes.position = [shadeGeometry.getAttribute('position').clone()];
  const shade = named(new Mesh(shadeGeometry, material), 'Shade');
  shade.position.set(0.5, 0, 0);
  lamp.add(shade, new PointLight(0xffffff, 3));
  const chairs = named(new InstancedMesh(new BoxGeometry(0.4, 1, 0.4), material, 3), 'Chairs');
  for (let i = 0; i < 3; i++)
    chairs.setMatrixAt(
      i,
      new Matrix4().compose(
        new Vector3(i, 0, -i),
        new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), i),
        new Vector3(1, 1 + i, 1),
      ),
    );
  const man = armature('Man');
  const manMesh = skinnedBox('ManBody', man.bones);
  const dog = armature('Dog');
  dog.top.position.set(-2, 0, 1);
  dog.top.scale.setScalar(0.5);
  scene.updateMatrixWorld(true);
  dog.top.add(skinnedBox('DogBody', dog.bones));
  man.bones[1].add(named(new Mesh(new BoxGeometry(0.1, 0.1, 0.1), material), 'Hat'));
  room.add(table, lamp, chairs, man.top, manMesh, dog.top);
  scene.add(room);
  const half = Math.SQRT1_2;
  return new Model(scene, [
    new AnimationClip('Live', 1, [
      new QuaternionKeyframeTrack('Man-head.quaternion', [0, 1], [0, 0, 0, 1, 0, half, 0, half]),
      new VectorKeyframeTrack('Dog.position', [0, 1], [-2, 0, 1, 2, 0, 1]),
      new VectorKeyframeTrack('Dog-hip.position', [0, 1], [0, 0, 0, 0, 0.3, 0]),
      new NumberKeyframeTrack('Shade.morphTargetInfluences', [0, 1], [0, 1]),
      new VectorKeyframeTrack('Hall.position', [0, 1], [1, 2, 3, 1, 4, 3]),
    ]),
  ]);
}

/** World coordinates (m) of vertices as drawn, with bones, morph targets and instances, by mesh and instance. */
function drawnVertices(scene: Scene): number[][] {
  const root = scene.three;
  root.updateMatrixWorld(true);
  const meshes: number[][] = [];
  const point = new Vector3();
  const matrix = new Matrix4();
  root.traverseVisible((object) => {
    if (!(object instanceof Mesh)) return;
    const mesh = object as Mesh;
    const count = object instanceof InstancedMesh ? object.count : 1;
    for (let n = 0; n < count; n++) {
      const vertices: number[] = [];
      matrix.identity();
      if (object instanceof InstancedMesh) object.getMatrixAt(n, matrix);
      for (let i = 0; i < mesh.geometry.getAttribute('position').count; i++) {
        mesh.getVertexPosition(i, point).applyMatrix4(matrix).applyMatrix4(mesh.matrixWorld);
        vertices.push(...point.toArray());
      }
      meshes.push(vertices);
    }
  });
  return meshes;
}

/** Greatest difference (m) of a mesh's coordinates to the most similar mesh; Infinity for different counts. */
function difference(meshes: readonly number[][], others: readonly number[][]): number {
  if (meshes.length !== others.length) return Infinity;
  const between = (a: number[], b: number[]): number =>
    a.length === b.length ? Math.max(...a.map((each, i) => Math.abs(each - b[i]))) : Infinity;
  return Math.max(...meshes.map((mesh) => Math.min(...others.map((other) => between(mesh, other)))));
}

/** Tolerance: matrices of instances are in single precision. */
const ROUNDING = 1e-5;

function placed(isUnpacked: boolean) {
  const model = hall();
  const assets = new AssetLibrary();
  assets.register('hall.glb', model);
  for (const [asset, name] of modelParts(model, 'hall.glb')) assets.register(name, asset);
  const scene = new Scene({ assets });
  const object = new GameObject('Hall place');
  object.transform.position = [5, 0, 1];
  object.addComponent(Animation, { clip: assets.nameOf(model.clips[0]) });
  if (isUnpacked) {
    const { objects, materials } = objectsOfModel(model, assets, 'hall.glb');
    for (const { name, values } of materials) assets.addMaterial(name, values);
    for (const each of objects) object.add(each);
  } else object.addComponent(ModelRenderer, { model: 'hall.glb' });
  scene.add(object);
  return { scene, object, assets, model };
}

test('what a skeleton, morph targets and too many or coloured instances hold together is found', () => {
  const model = hall();
  const found = keptTogether(model).map(({ nodes, reason }) => [partsText(model.scene, nodes), reason]);
  expect(found).toEqual([
    ['Hall/Lamp/Shade', 'morph targets'],
    ['Hall/ManBody;Hall/Man/Man-hip', 'a skeleton'],
    ['Hall/Dog', 'a skeleton'],
  ]);
  expect(isUnpackable(model)).toBe(true);
  const coloured = new InstancedMesh(new BoxGeometry(), material, 2);
  coloured.setColorAt(0, new Color(1, 0, 0));
  const alone = new Model(new Group().add(coloured));
  expect(keptTogether(alone)).toMatchObject([{ reason: 'instances of a mesh' }]);
  expect(isUnpackable(alone)).toBe(false);
});

test('paths name nodes of equal, odd and missing names', () => {
  const scene = new Group();
  const odd = named(new Group(), 'a/b;c#1%');
  const twin = named(new Group(), odd.name);
  const nameless = new Group();
  scene.add(odd, twin);
  twin.add(nameless);
  for (const node of [odd, twin, nameless]) expect(subtreeOf(scene, pathOfNode(scene, node))!.nodes).toEqual([node]);
  expect(pathOfNode(scene, twin)).toBe('a%2fb%3bc%231%25#2');
  expect(subtreeOf(scene, '')).toBeNull();
  expect(subtreeOf(scene, 'gone;Gone/too')).toBeNull();
  expect(subtreeOf(scene, `${pathOfNode(scene, odd)};${pathOfNode(scene, nameless)}`)!.root).toBe(scene);
});

describe('unpacked', () => {
  test('a hall has objects for what can be one, and draws the same at every time of its clip', () => {
    const whole = placed(false);
    const apart = placed(true);
    const names: string[] = [];
    apart.object.traverse(({ name, components }) => names.push(`${name}: ${components.map((each) => each.typeName)}`));
    expect(names.map((each) => each.replace('Transform,', ''))).toEqual([
      'Hall place: Animation',
      'Hall: Transform',
      'Table: ObjectRenderer',
      'Lamp: Transform',
      'Shade: ModelRenderer',
      'PointLight: Light',
      'Chairs: Transform',
      'Chairs 1: ObjectRenderer',
      'Chairs 2: ObjectRenderer',
      'Chairs 3: ObjectRenderer',
      'Man: Transform',
      'Dog: ModelRenderer',
      'ManBody: ModelRenderer',
    ]);
    expect(apart.object.find('Chairs 2')!.getComponent(ObjectRenderer)!.instanced).toBe(true);
    expect(difference(drawnVertices(apart.scene), drawnVertices(whole.scene))).toBeLessThan(ROUNDING);
    const atRest = drawnVertices(apart.scene);
    for (const seconds of [0.25, 0.5, 0.2]) {
      whole.scene.update(seconds);
      apart.scene.update(seconds);
      const moved = drawnVertices(apart.scene);
      expect(difference(moved, drawnVertices(whole.scene))).toBeLessThan(ROUNDING);
      expect(difference(moved, atRest)).toBeGreaterThan(0.1);
    }
    for (const { scene } of [whole, apart]) scene.reset();
    expect(difference(drawnVertices(apart.scene), atRest)).toBeLessThan(ROUNDING);
  });

  test('saved and opened it draws the same', async () => {
    const { scene, assets } = placed(true);
    const copy = await deserialize(JSON.stringify(serialize(scene)), { assets });
    expect(serialize(copy)).toEqual(serialize(scene));
    expect(drawnVertices(copy)).toEqual(drawnVertices(scene));
  });

  test('other parts are drawn once they are named', () => {
    const { object } = placed(true);
    const renderer = object.find('Dog')!.getComponent(ModelRenderer)!;
    renderer.set('parts', 'Hall/Table;Hall/Lamp/Shade');
    const drawn: string[] = [];
    renderer.three!.traverse((each) => each instanceof Mesh && drawn.push(each.name));
    expect(drawn).toEqual(['Table', 'Shade']);
    renderer.set('parts', '');
    expect(renderer.partsRoot).toBeNull();
  });
});
