import { BoxGeometry, Float32BufferAttribute, Group, Mesh, MeshBasicMaterial } from 'three';
import { expect, test } from 'vitest';
import './index';
import { clipText } from '../assets/clips/clipText';
import { Model } from '../assets/Model';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { Animation } from './Animation';
import { ModelRenderer } from './ModelRenderer';

/** A mesh with morph targets of these names and weights. */
function face(name: string, weights: Readonly<Record<string, number>>): Mesh {
  const geometry = new BoxGeometry();
  geometry.morphAttributes.position = Object.keys(weights).map((target) => {
    const attribute = new Float32BufferAttribute(geometry.attributes.position.array, 3);
    attribute.name = target;
    return attribute;
  });
  const mesh = new Mesh(geometry, new MeshBasicMaterial());
  mesh.name = name;
  mesh.updateMorphTargets();
  Object.values(weights).forEach((weight, i) => (mesh.morphTargetInfluences![i] = weight));
  return mesh;
}

const source = (): Model =>
  new Model(new Group().add(face('Face', { Smile: 0, Blink: 0.25 }), face('Teeth', { 'Jaw.open': 0, Smile: 0 })));

function stage(model = source()): { scene: Scene; renderer: ModelRenderer; weights: () => Record<string, number[]> } {
  const scene = new Scene();
  scene.assets.register('face.glb', model);
  const object = new GameObject('Head');
  scene.add(object);
  const renderer = object.addComponent(ModelRenderer, { model: 'face.glb' });
  const weights = (): Record<string, number[]> => {
    const found: Record<string, number[]> = {};
    renderer.three?.traverse((node) => {
      if (node instanceof Mesh) found[node.name] = [...node.morphTargetInfluences!];
    });
    return found;
  };
  return { scene, renderer, weights };
}

/**
 * Adds a clip of two seconds in which a smile grows from 0 to 1. @returns messages on components from now on
 * @returns what is told of components from now on
 */
function addGrin(scene: Scene): readonly string[] {
  const keys = [
    { time: 0, value: 0 },
    { time: 2, value: 1 },
  ];
  const data = clipText({ tracks: [{ path: '', component: 'ModelRenderer', field: 'morph.Smile', keys }], events: [] });
  scene.assets.addFieldAsset('clip', 'Grin', { data, duration: 2 });
  const told: string[] = [];
  scene.onComponentError = (_component, error) => told.push((error as Error).message);
  return told;
}

const names = ({ fields }: ModelRenderer): string[] => Object.keys(fields).filter((name) => name.startsWith('morph.'));

test('the weight of each morph target is a field, of all meshes that have one of the name', async () => {
  const model = source();
  const { scene, renderer, weights } = stage(model);
  expect(names(renderer)).toEqual(['morph.Smile', 'morph.Blink', 'morph.Jaw.open']);
  expect(weights()).toEqual({ Face: [0, 0.25], Teeth: [0, 0] });
  renderer.set('morph.Smile', 0.5);
  renderer.set('morph.Jaw.open', 1);
  expect(weights()).toEqual({ Face: [0.5, 0.25], Teeth: [1, 0.5] });
  expect(model.scene.children.map((mesh) => (mesh as Mesh).morphTargetInfluences)).toEqual([
    [0, 0.25],
    [0, 0],
  ]);
  expect(() => renderer.set('morph.Smile', 1.5)).toThrow(/morph\.Smile/);
  expect(() => renderer.set('morph.Frown', 1)).toThrow(/morph\.Frown is unknown/);

  // weights that differ from the model's are saved and restored
  const saved = serialize(scene);
  expect(saved.objects[0].components[1].values).toMatchObject({ morphWeights: '{"Jaw.open":1,"Smile":0.5}' });
  const copy = await deserialize(JSON.stringify(saved), { assets: scene.assets });
  const [again] = copy.componentsOf(ModelRenderer);
  expect([again.get('morph.Smile'), again.get('morph.Blink')]).toEqual([0.5, 0.25]);
  expect((again.three!.getObjectByName('Teeth') as Mesh).morphTargetInfluences).toEqual([1, 0.5]);
  renderer.set('morph.Smile', 0);
  renderer.set('morph.Jaw.open', 0);
  expect(renderer.morphWeights).toBe('');
  expect(weights()).toEqual({ Face: [0, 0.25], Teeth: [0, 0] });
});

test('weights that are simulated are taken back; what a file holds of others, or no numbers, counts for nothing', () => {
  const { scene, renderer, weights } = stage();
  renderer.simulate('morph.Blink', 1);
  expect(weights().Face).toEqual([0, 1]);
  scene.reset();
  expect(weights().Face).toEqual([0, 0.25]);
  renderer.morphWeights = '{"Smile":"much","Blink":0.75,"Gone":1,"__proto__":3}';
  expect(weights().Face).toEqual([0, 0.75]);
  renderer.morphWeights = '{"Smile":';
  expect(weights().Face).toEqual([0, 0.25]);
});

test('parts have the morph targets that they draw, and another model its own', () => {
  const { scene, renderer, weights } = stage();
  renderer.parts = 'Teeth';
  expect(names(renderer)).toEqual(['morph.Jaw.open', 'morph.Smile']);
  renderer.set('morph.Smile', 1);
  expect(weights()).toEqual({ Teeth: [0, 1] });
  scene.assets.register('box.glb', new Model(new Mesh(new BoxGeometry(), new MeshBasicMaterial())));
  renderer.model = 'box.glb';
  expect(names(renderer)).toEqual([]);
  renderer.model = null;
  expect(names(renderer)).toEqual([]);
});

test('a clip of one’s own animates weights, also of a model that is chosen after it began', () => {
  const { scene, renderer, weights } = stage();
  const told = addGrin(scene);
  renderer.model = null;
  renderer.gameObject.addComponent(Animation, { clip: 'Grin' });
  scene.update(0.5);
  expect(told).toEqual([expect.stringContaining("has no field 'morph.Smile'")]);
  renderer.model = 'face.glb';
  scene.update(0.5);
  expect(weights()).toEqual({ Face: [0.5, 0.25], Teeth: [0, 0.5] });
  expect(renderer.morphWeights).toBe('');
  scene.reset();
  expect(weights()).toEqual({ Face: [0, 0.25], Teeth: [0, 0] });
  expect(told).toHaveLength(1);
});

test('a scene is reset where the model of a weight that is animated has gone meanwhile', () => {
  const { scene, renderer, weights } = stage();
  const told = addGrin(scene);
  renderer.gameObject.addComponent(Animation, { clip: 'Grin' });
  scene.update(0.5);
  renderer.model = null;
  scene.reset();
  expect(told).toEqual([]);
  renderer.model = 'face.glb';
  expect(weights()).toEqual({ Face: [0, 0.25], Teeth: [0, 0] });
  scene.update(0.5);
  renderer.model = null;
  scene.update(0.5);
  scene.update(0.5);
  expect(told).toEqual([expect.stringContaining("has no field 'morph.Smile'")]);
});
