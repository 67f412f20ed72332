import {
  AmbientLight,
  BackSide,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  DirectionalLight,
  GLBufferAttribute,
  HemisphereLight,
  InstancedMesh,
  LightProbe,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Object3D,
  PlaneGeometry,
  PointLight,
  RectAreaLight,
  Scene,
  SpotLight,
  Vector3,
} from 'three';
import { describe, expect, it } from 'vitest';
import { testOptions } from '../testing/testOptions';
import { collectLights } from './collectLights';
import { collectMeshes } from './collectMeshes';
import { mergeTriangles } from './mergeTriangles';

/** A scene of objects, with their matrices up to date. */
function sceneOf(...objects: Object3D[]): Scene {
  const scene = new Scene().add(...objects);
  scene.updateMatrixWorld(true);
  return scene;
}

const named = <T extends Object3D>(object: T, name: string): T => Object.assign(object, { name });
const lit = new MeshStandardMaterial();

describe('collectMeshes', () => {
  it('names what it leaves out, and why', () => {
    const noPositions = new BufferGeometry();
    const notNumbers = new PlaneGeometry();
    notNumbers.attributes.position.setX(2, NaN);
    const wild = new PlaneGeometry();
    wild.setIndex([0, 1, 9]);
    const empty = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(6), 3));
    const freed = new PlaneGeometry();
    (freed.attributes.normal as { array: unknown }).array = null;
    const onGPU = new PlaneGeometry();
    onGPU.setAttribute('position', new GLBufferAttribute({}, 5126, 3, 4, 4) as never);
    const options = testOptions();
    const found = collectMeshes(
      sceneOf(
        named(new Mesh(noPositions, lit), 'A'),
        named(new Mesh(notNumbers, lit), 'B'),
        named(new Mesh(wild, lit), 'C'),
        named(new Mesh(empty, lit), 'D'),
        named(new InstancedMesh(new PlaneGeometry(), lit, 3), 'E'),
        named(new Mesh(new PlaneGeometry(), lit), 'F'),
        named(new Mesh(freed, lit), 'G'),
        named(new Mesh(onGPU, lit), 'H'),
      ),
      options,
    );
    expect(options.warnings).toEqual([
      'Mesh “A” is not baked: its geometry has no positions; give it some.',
      'Mesh “B” is not baked: the position of its vertex 2 is not a number; correct it.',
      'Mesh “C” is not baked: its index names a vertex that does not exist; correct it.',
      'Mesh “D” is not baked: it has no triangles.',
      'Mesh “E” gets no lightmap: its instances share one set of UVs. They cast shadows and reflect light; use single meshes to have them lit.',
      'Mesh “G” is not baked: its vertices are on the GPU alone; keep their arrays until it is baked.',
      'Mesh “H” is not baked: its vertices are on the GPU alone; keep their arrays until it is baked.',
    ]);
    expect(found.map(({ mesh, isLit, placements }) => [mesh.name, isLit, placements.length])).toEqual([
      ['E', false, 3],
      ['F', true, 1],
    ]);
  });

  it('takes what is seen and static; unlit materials get no lightmap', () => {
    const hidden = named(new Mesh(new PlaneGeometry(), lit), 'hidden');
    hidden.visible = false;
    const moving = named(new Mesh(new PlaneGeometry(), lit), 'moving');
    const unlit = named(new Mesh(new PlaneGeometry(), new MeshBasicMaterial()), 'unlit');
    const options = { ...testOptions(), isStatic: (object: Object3D) => object !== moving };
    const found = collectMeshes(sceneOf(hidden, moving, unlit), options);
    expect(found.map(({ mesh, isLit }) => [mesh.name, isLit])).toEqual([['unlit', false]]);
  });
});

describe('collectLights', () => {
  it('reads lights in world space as three has them', () => {
    const point = new PointLight(0xffffff, 2, 7, 1.5);
    point.userData.farol = { radius: 0.2 };
    const spot = new SpotLight(0xffffff, 1, 0, 0.5, 0.5);
    spot.position.set(0, 3, 0);
    const sun = new DirectionalLight(0xffffff, 3);
    sun.position.set(0, 0, 5);
    const rectangle = new RectAreaLight(0xffffff, 4, 2, 1);
    const group = new Object3D().add(point, rectangle);
    group.position.x = 4;
    group.scale.setScalar(3);
    const options = testOptions();
    const scene = sceneOf(group, spot, sun, new AmbientLight(0xffffff, 0.5), new HemisphereLight(), new LightProbe());
    const { traced, skies } = collectLights(scene, (light) => light !== spot || 'indirect', options.onWarning);
    const [p, r, s, d] = traced;
    expect(traced.map(({ kind }) => kind)).toEqual(['point', 'rectangle', 'spot', 'directional']);
    expect([p.position.x, p.range, p.decay, p.radius, p.colour.r]).toEqual([4, 7, 1.5, 0.2, 2]);
    expect([r.halfWidth.x, r.halfHeight.y, r.direction.z]).toEqual([1, 0.5, -1]);
    expect(s.direction.toArray()).toEqual([0, 1, 0]);
    expect([s.coneCosine, s.penumbraCosine]).toEqual([Math.cos(0.5), Math.cos(0.25)]);
    expect(traced.map(({ isIndirect }) => isIndirect)).toEqual([false, false, true, false]);
    expect(d.direction.toArray()).toEqual([0, 0, 1]);
    expect(skies.map(({ sky, ground }) => [sky.r, ground.r])).toEqual([
      [0.5, 0.5],
      [1, 1],
    ]);
    expect(options.warnings).toEqual([
      expect.stringMatching(/^LightProbe .* is not baked: lights of its kind are not supported/),
    ]);
  });

  it('leaves out lights that are not baked or not seen', () => {
    const hidden = new PointLight();
    hidden.visible = false;
    const live = new PointLight();
    const found = collectLights(sceneOf(hidden, live), (light) => light !== live, testOptions().onWarning);
    expect(found).toEqual({ traced: [], skies: [] });
  });
});

describe('mergeTriangles', () => {
  /** Face directions by corners, and normals of first corners, of all triangles. */
  function facesOf(...objects: Object3D[]): { faces: number[][]; normals: number[][]; count: number } {
    const meshes = collectMeshes(sceneOf(...objects), testOptions());
    const { positions, normals, count } = mergeTriangles(
      meshes,
      meshes.map(() => null),
    );
    const corner = (i: number) => new Vector3().fromArray(positions, 3 * i);
    const rounded = (vector: Vector3) => vector.toArray().map((value) => Math.round(value * 1e3) / 1e3 + 0);
    const faces = Array.from({ length: count }, (_, i) =>
      rounded(
        corner(3 * i + 1)
          .sub(corner(3 * i))
          .cross(corner(3 * i + 2).sub(corner(3 * i)))
          .normalize(),
      ),
    );
    return { faces, normals: faces.map((_, i) => rounded(new Vector3().fromArray(normals, 9 * i))), count };
  }

  it('turns fronts the way they are lit, of mirrored meshes and of those seen from behind', () => {
    const plane = new Mesh(new PlaneGeometry(), lit);
    const up = { faces: [0, 1].map(() => [0, 0, 1]), normals: [0, 1].map(() => [0, 0, 1]), count: 2 };
    const down = { faces: [0, 1].map(() => [0, 0, -1]), normals: [0, 1].map(() => [0, 0, -1]), count: 2 };
    expect(facesOf(plane)).toEqual(up);
    plane.scale.set(-1, 2, 1);
    expect(facesOf(plane)).toEqual(up);
    const behind = new Mesh(new PlaneGeometry(), new MeshStandardMaterial({ side: BackSide }));
    expect(facesOf(behind)).toEqual(down);
    behind.scale.x = -1;
    expect(facesOf(behind)).toEqual(down);
  });

  it('does without index and normals, and without triangles that have no area', () => {
    const geometry = new BoxGeometry().toNonIndexed();
    geometry.deleteAttribute('normal');
    geometry.attributes.position.setXYZ(1, ...(geometry.attributes.position.array.slice(0, 3) as never as [0, 0, 0]));
    const { faces, normals, count } = facesOf(new Mesh(geometry, lit));
    expect(count).toBe(11);
    expect(normals).toEqual(faces);
  });

  it('places each copy of an instanced mesh', () => {
    const copies = new InstancedMesh(new PlaneGeometry(), lit, 2);
    copies.setMatrixAt(0, new Matrix4());
    copies.setMatrixAt(1, new Matrix4().makeTranslation(5, 0, 0));
    const above = new Object3D().add(copies);
    above.position.set(0, 40, 300);
    above.scale.setScalar(2);
    const meshes = collectMeshes(sceneOf(above), testOptions());
    const { count, positions, ranges } = mergeTriangles(meshes, [null]);
    expect(count).toBe(4);
    const bounds = [0, 1, 2].map((axis) => {
      const values = [...positions].filter((_, i) => i % 3 === axis);
      return [Math.min(...values), Math.max(...values)];
    });
    // instances at 0 and 5, sides of 1, everything scaled by 2
    expect(bounds).toEqual([
      [-1, 11],
      [39, 41],
      [300, 300],
    ]);
    expect(ranges).toEqual([expect.objectContaining({ lightmap: -1, first: 0, count: 4 })]);
  });
});
