import { AssetLibrary, Light, ModelRenderer } from '@farol/engine';
import { deserialize, packObj, readSceneFile } from '@farol/engine/files';
import { scenes } from '@farol/scenes';
import { AnimationClip, BufferGeometry, Float32BufferAttribute, Group, Mesh, MeshStandardMaterial } from 'three';
import { describe, expect, it } from 'vitest';
import type { LoadedModel } from '../model/loadModel';
import { modelScene } from '../model/modelScene';
import { labFragment } from './labFragment';
import { sceneFile } from './sceneFile';

const defaultsOf = (scene: string) => scenes[scene].parameters;

describe('labFragment', () => {
  it('has the lights on show in the middle, or those of the scene where nothing is chosen', () => {
    expect(labFragment('temple', { lights: 100 }, defaultsOf('temple'))).toBe(
      '#preset=custom&series=temple:lights:25,50,100,200,400',
    );
    expect(labFragment('sponza', {}, defaultsOf('sponza'))).toBe(
      '#preset=custom&series=sponza:lights:13,25,50,100,200',
    );
    expect(labFragment('benchmarkLights', { n: 4, m: 10 }, defaultsOf('benchmarkLights'))).toBe(
      '#preset=custom&series=benchmarkLights:lights:25,50,100,200,400:n=4',
    );
    expect(labFragment('benchmarkLights', { n: 4, m: 20, mRows: 5 }, defaultsOf('benchmarkLights'))).toBe(
      '#preset=custom&series=benchmarkLights:lights:25,50,100,200,400:n=4',
    );
  });

  it('names each count once, within what the Lab measures', () => {
    expect(labFragment('temple', { lights: 0 }, {})).toBe('#preset=custom&series=temple:lights:1');
    expect(labFragment('temple', { lights: 20_000 }, {})).toBe('#preset=custom&series=temple:lights:5000,10000');
  });

  it('is null for scenes that the Lab does not build', () => {
    expect(labFragment('dragons', {}, defaultsOf('dragons'))).toBeNull();
  });
});

/** A dropped OBJ file of one triangle. */
async function triangle(): Promise<LoadedModel> {
  const files = new Map([['room.obj', new File(['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3'], 'room.obj')]]);
  const { glb, notes } = await packObj(files, 'room.obj');
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute([0, 0, 0, 1, 0, 0, 0, 1, 0], 3));
  const scene = new Group().add(new Mesh(geometry, new MeshStandardMaterial()));
  const gltf = { scene, animations: [new AnimationClip('Turn', 1, [])] } as unknown as LoadedModel['gltf'];
  return { name: 'room.obj', gltf, notes, pack: async () => new Blob([glb]) };
}

/** The scene that the Lab opens from a file's bytes. */
async function opened(bytes: Uint8Array) {
  const { text, fileOf } = await readSceneFile(bytes);
  return deserialize(text, { fileOf, mayFetch: () => false });
}

describe('sceneFile', () => {
  it('holds a dropped model with its lights, and the camera where it was moved to', async () => {
    const model = await triangle();
    const scene = modelScene(model, { lights: 3, seed: 1 }, new AssetLibrary());
    const { object3D } = scene.activeCamera!.gameObject;
    object3D.position.set(1, 2, 3);
    object3D.rotation.set(0.1, 0.2, 0);
    const again = await opened(await sceneFile(scene, model));
    const [renderer] = again.componentsOf(ModelRenderer);
    expect(renderer.model).toBe('room.glb');
    expect(renderer.animation).toBe('Turn');
    let vertices = 0;
    renderer.three!.traverse((each) => {
      if (each instanceof Mesh) vertices += (each as Mesh).geometry.getAttribute('position').count;
    });
    expect(vertices).toBe(3);
    expect(again.componentsOf(Light).filter(({ type }) => type === 'point')).toHaveLength(3);
    const camera = again.activeCamera!.gameObject;
    expect(camera.transform.position).toEqual([1, 2, 3]);
    expect(camera.transform.rotation[0]).toBeCloseTo(0.1, 12);
    expect(camera.components.map(({ typeName }) => typeName)).toEqual(['Transform', 'Camera']);
    again.dispose();
    scene.dispose();
  });

  it('holds a scene of the engine', async () => {
    const scene = await scenes.benchmarkLightsObjects.build({}, new AssetLibrary());
    const count = [...scene.componentsOf(Light)].length;
    const again = await opened(await sceneFile(scene, null));
    expect([...again.componentsOf(Light)]).toHaveLength(count);
    again.dispose();
    scene.dispose();
  });
});
