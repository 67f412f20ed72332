import {
  Color,
  Matrix4,
  MeshPhongMaterial,
  Raycaster,
  Vector3,
  type InstancedMesh,
  type MeshStandardMaterial,
} from 'three';
import { beforeEach, describe, expect, test } from 'vitest';
import { AssetLibrary } from '../assets/AssetLibrary';
import { GameObject } from '../core/GameObject';
import { gameObjectOf } from '../core/gameObjectOf';
import { Scene } from '../core/Scene';
import { ObjectRenderer } from './ObjectRenderer';

let scene: Scene;
let assets: AssetLibrary;

beforeEach(() => {
  assets = new AssetLibrary();
  scene = new Scene({ assets });
});

function thing(values: Parameters<GameObject['addComponent']>[1] = {}): ObjectRenderer {
  const gameObject = new GameObject('Thing');
  scene.add(gameObject);
  return gameObject.addComponent(ObjectRenderer, values);
}

const materialOf = (renderer: ObjectRenderer): MeshStandardMaterial => renderer.three!.material as MeshStandardMaterial;

describe('materials', () => {
  test('are shared by objects of equal values', () => {
    const [a, b] = [thing({ roughness: 0.2, map: 'checker' }), thing({ roughness: 0.2, map: 'checker' })];
    expect(materialOf(a)).toBe(materialOf(b));
    expect(assets.materials.size).toBe(1);
  });

  test('of one object change alone, and are shared again when they become equal', () => {
    const [a, b] = [thing(), thing()];
    a.roughness = 0.1;
    expect(materialOf(b).roughness).toBe(0.6);
    expect(materialOf(a).roughness).toBe(0.1);
    const own = materialOf(a);
    a.roughness = 0.15;
    expect(materialOf(a)).toBe(own);
    b.roughness = 0.15;
    expect(materialOf(a)).toBe(materialOf(b));
    expect(assets.materials.size).toBe(1);
  });

  test('do not differ by fields that their kind has not', () => {
    expect(materialOf(thing({ shininess: 5 }))).toBe(materialOf(thing({ shininess: 80 })));
  });

  test('are of the kind that is asked for, with all its values', () => {
    const renderer = thing({ kind: 'phong', colour: [0.1, 0.2, 0.3], specular: [1, 0, 0], shininess: 12 });
    const material = renderer.three!.material as MeshPhongMaterial;
    expect(material).toBeInstanceOf(MeshPhongMaterial);
    expect(material.color.toArray()).toEqual([0.1, 0.2, 0.3]);
    expect(material.specular.toArray()).toEqual([1, 0, 0]);
    expect(material.shininess).toBe(12);
  });

  test('answer ambient light in a colour of its own, and as three does when it is white', () => {
    const renderer = thing({ kind: 'phong', ambient: [1, 0.5, 0] });
    const material = materialOf(renderer);
    const compile = (): { uniforms: Record<string, { value: unknown }>; fragmentShader: string } => {
      const shader = { uniforms: {}, fragmentShader: '#include <aomap_fragment>' };
      material.onBeforeCompile(shader as never, null as never);
      return shader;
    };
    const { uniforms, fragmentShader } = compile();
    expect(fragmentShader).toContain('indirectDiffuse *= ambientReflection');
    expect(fragmentShader).toContain('#define FAROL_AMBIENT_FACTOR ambientReflection\n');
    const { version } = material;
    renderer.ambient = [0, 1, 0];
    expect(uniforms.ambientReflection.value).toEqual(new Color(0, 1, 0));
    expect(material.version).toBe(version);
    renderer.ambient = [1, 1, 1];
    expect(material.version).toBeGreaterThan(version);
    expect(compile().fragmentShader).toBe('#include <aomap_fragment>');
  });

  test('ask for another program only when one is needed', () => {
    const renderer = thing();
    const material = materialOf(renderer);
    const { version } = material;
    renderer.colour = [1, 0, 0];
    expect(material.version).toBe(version);
    renderer.shading = 'flat';
    renderer.map = 'checker';
    expect(materialOf(renderer)).toBe(material);
    expect(material.version).toBe(version + 2);
  });

  test('are disposed with their last user', () => {
    const [a, b] = [thing(), thing()];
    let disposed = 0;
    materialOf(a).addEventListener('dispose', () => disposed++);
    scene.remove(a.gameObject);
    expect(disposed).toBe(0);
    scene.remove(b.gameObject);
    expect(disposed).toBe(1);
    scene.add(a.gameObject);
    expect(a.three).not.toBeNull();
  });

  test('of the library are used as they are, and never disposed', () => {
    const own = new MeshPhongMaterial();
    let disposed = 0;
    own.addEventListener('dispose', () => disposed++);
    assets.register('glass', own);
    const renderer = thing({ material: 'glass' });
    expect(renderer.three!.material).toBe(own);
    expect(assets.materials.size).toBe(0);
    renderer.material = null;
    expect(renderer.three!.material).not.toBe(own);
    renderer.gameObject.dispose();
    expect(disposed).toBe(0);
  });

  test('share one texture for each repeat', () => {
    const [a, b] = [thing({ map: 'checker', repeat: 4 }), thing({ map: 'checker', repeat: 4, roughness: 0 })];
    expect(materialOf(a).map).toBe(materialOf(b).map);
    expect(materialOf(a).map!.repeat.x).toBe(4);
    expect(materialOf(a).map!.source).toBe(assets.texture('checker').source);
  });
});

describe('meshes', () => {
  test('share geometry, which is freed with its last user', () => {
    const [a, b] = [thing(), thing()];
    expect(a.geometry).toBe(b.geometry);
    let freed = 0;
    a.geometry!.addEventListener('dispose', () => freed++);
    a.mesh = 'sphere';
    expect(freed).toBe(0);
    b.mesh = null;
    expect(freed).toBe(1);
    expect(b.three).toBeNull();
  });

  test('are shown and hidden by render, enabled and the flags of shadows', () => {
    const renderer = thing({ castShadow: true });
    expect(renderer.three).toMatchObject({ visible: true, castShadow: true, receiveShadow: false });
    renderer.render = false;
    expect(renderer.three!.visible).toBe(false);
    renderer.render = true;
    renderer.enabled = false;
    expect(renderer.three!.visible).toBe(false);
  });
});

describe('instances', () => {
  const groups = (): InstancedMesh[] => {
    scene.three.updateMatrixWorld();
    return scene.three.children.filter((child): child is InstancedMesh => 'isInstancedMesh' in child);
  };

  test('are one call for all of a mesh, in places and colours of their own', () => {
    const renderers = Array.from({ length: 40 }, (_, i) =>
      thing({ instanced: true, colour: [i / 40, 0, 1], mesh: 'bulb' }),
    );
    renderers.forEach((renderer, i) => (renderer.gameObject.transform.position = [i, 0, 0]));
    expect(groups()).toHaveLength(1);
    const [group] = groups();
    expect(group.count).toBe(40);
    const matrix = new Matrix4();
    group.getMatrixAt(7, matrix);
    expect(matrix.elements[12]).toBe(7);
    expect(group.instanceColor!.getX(20)).toBeCloseTo(0.5, 6);
    expect(renderers[0].three).toBeNull();
    expect(assets.materials.size).toBe(1);
  });

  test('are found by a ray, and left out while they are not active', () => {
    const renderers = [0, 1, 2].map(() => thing({ instanced: true }));
    renderers.forEach((renderer, i) => (renderer.gameObject.transform.position = [i * 3, 0, 0]));
    renderers[0].gameObject.active = false;
    const [group] = groups();
    expect(group.count).toBe(2);
    const [hit] = new Raycaster(new Vector3(6, 0, 5), new Vector3(0, 0, -1)).intersectObject(group);
    expect(gameObjectOf(hit.object, hit.instanceId)).toBe(renderers[2].gameObject);
  });

  test('are culled together, by a sphere around all of them', () => {
    const renderers = [0, 1, 2].map(() => thing({ instanced: true }));
    const [near, far] = renderers.map((renderer) => renderer.gameObject.transform);
    near.position = [-3, 0, 0];
    far.position = [3, 4, 0];
    far.scale = [1, 2, 1];
    const [group] = groups();
    const { center, radius } = group.boundingSphere!;
    const size = assets.mesh('box').boundingSphere!.radius;
    expect(group.frustumCulled).toBe(true);
    expect(center.distanceTo(new Vector3(-3, 0, 0)) + size).toBeLessThanOrEqual(radius);
    expect(center.distanceTo(new Vector3(3, 4, 0)) + 2 * size).toBeLessThanOrEqual(radius);
    expect(radius).toBeLessThan(8);
    renderers[1].gameObject.active = false;
    groups();
    expect(radius).toBeGreaterThan(group.boundingSphere!.radius);
  });

  test('go away one by one, and into meshes of their own', () => {
    const renderers = [0, 1].map(() => thing({ instanced: true }));
    expect(groups()).toHaveLength(1);
    renderers[0].instanced = false;
    expect(renderers[0].three).not.toBeNull();
    expect(groups()[0].count).toBe(1);
    renderers[1].gameObject.dispose();
    expect(groups()).toHaveLength(0);
  });
});

test('normals that a mesh lacks are computed, once for each crease angle', () => {
  const bare = assets.mesh('box').clone();
  bare.deleteAttribute('normal');
  assets.register('bare', bare);
  const [a, b, c] = [thing({ mesh: 'bare' }), thing({ mesh: 'bare' }), thing({ mesh: 'bare', creaseAngle: Math.PI })];
  expect(a.geometry!.getAttribute('position').count).toBe(24);
  expect(a.geometry).toBe(b.geometry);
  expect(c.geometry).not.toBe(a.geometry);
  expect(bare.getAttribute('normal')).toBeUndefined();
});
