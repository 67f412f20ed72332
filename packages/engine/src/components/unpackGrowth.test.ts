import { BufferAttribute, BufferGeometry, Group, Mesh, MeshStandardMaterial, Object3D, Points } from 'three';
import { describe, expect, test } from 'vitest';
import { AssetLibrary } from '../assets/AssetLibrary';
import { Model } from '../assets/Model';
import { isOfSubtree, partsText, subtreeOf } from '../assets/modelNodes';
import { modelParts } from '../assets/modelParts';
import { Scene } from '../core/Scene';
import { armature, skinnedBox } from './testing/skinnedBox';
import { isUnpackable, keptTogether } from './keptTogether';
import { ModelRenderer } from './ModelRenderer';
import { objectsOfModel } from './objectsOfModel';
import '../components/index';

const triangle = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(9), 3));
const smiling = triangle.clone();
smiling.morphAttributes.position = [new BufferAttribute(new Float32Array(9), 3)];
const material = new MeshStandardMaterial();

/** Makers of models with `count` parts that stay together. */
const models: Readonly<Record<string, (count: number) => Object3D>> = {
  'points of one name': (count) => new Group().add(...Array.from({ length: count }, () => new Points(triangle))),
  'morph targets, each in a group': (count) =>
    new Group().add(...Array.from({ length: count }, () => new Group().add(new Mesh(smiling, material)))),
  'skeletons beside their meshes': (count) =>
    new Group().add(
      ...Array.from({ length: count }, (_, i) => {
        const { top, bones } = armature(`man ${i}`);
        return [skinnedBox(`body ${i}`, bones), top];
      }).flat(),
    ),
  'points within one another': (count) => {
    const top = new Group();
    // ten levels deep
    for (let i = 0; i < count / 10; i++) {
      let at: Object3D = top;
      for (let depth = 0; depth < 10; depth++) {
        const next = new Points(triangle);
        at.add(next);
        at = next;
      }
    }
    return top;
  },
};

/** Counts accesses to names, parents and children of a model's nodes during `work`. */
function looksAt(top: Object3D, work: () => void): number {
  let looks = 0;
  top.traverse((node) => {
    for (const key of ['name', 'parent', 'children'] as const) {
      let value: unknown = node[key];
      Object.defineProperty(node, key, {
        get: () => {
          looks++;
          return value;
        },
        set: (next) => {
          value = next;
        },
      });
    }
  });
  looks = 0;
  work();
  return looks;
}

describe.each(Object.entries(models))('ten times as many parts of a model are ten times the work: %s', (_, make) => {
  test('to be found and named', () => {
    const looks = (count: number): number => {
      const model = new Model(make(count));
      return looksAt(model.scene, () => {
        const kept = keptTogether(model);
        isUnpackable(model, kept);
        const nodes = kept.flatMap((part) => part.nodes);
        const subtree = subtreeOf(model.scene, partsText(model.scene, nodes))!;
        expect(subtree.nodes).toHaveLength(nodes.length);
        for (const node of nodes) expect(isOfSubtree(node, subtree)).toBe(true);
      });
    };
    expect(looks(1000) / looks(100)).toBeLessThan(12);
  });

  test('to be unpacked and shown', () => {
    const looks = (count: number): number => {
      const model = new Model(make(count));
      const assets = new AssetLibrary();
      assets.register('hall.glb', model);
      for (const [part, name] of modelParts(model, 'hall.glb')) if (!assets.has(name)) assets.register(name, part);
      const scene = new Scene({ assets });
      return looksAt(model.scene, () => {
        for (const object of objectsOfModel(model, assets, 'hall.glb').objects) scene.add(object);
        for (const { parts } of scene.componentsOf(ModelRenderer)) expect(parts).not.toBe('');
      });
    };
    expect(looks(500) / looks(50)).toBeLessThan(12);
  });
});
