import {
  Animation,
  clipText,
  type ClipKey,
  type ClipTrack,
  GameObject,
  Light,
  Model,
  ModelRenderer,
  ObjectRenderer,
  Scene,
  valueAt,
} from '@farol/engine';
import type { FieldValue, Vector3Field } from '@farol/engine/fields';
import {
  AnimationClip,
  AnimationMixer,
  Bone,
  BoxGeometry,
  Float32BufferAttribute,
  Group,
  InterpolateDiscrete,
  Mesh,
  MeshStandardMaterial,
  NumberKeyframeTrack,
  Object3D,
  QuaternionKeyframeTrack,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
  VectorKeyframeTrack,
} from 'three';
import { afterAll, beforeAll, describe, expect, test, vi } from 'vitest';
import { exportInTest, PageFileReader, partsOfGlb } from './testing/exportInTest';

beforeAll(() => void vi.stubGlobal('FileReader', PageFileReader));
afterAll(() => void vi.unstubAllGlobals());

interface Channel {
  readonly node: string;
  readonly path: string;
  readonly interpolation: string;
  readonly times: Uint8Array;
  readonly values: Uint8Array;
}

/** Animation channels of a GLB by name, with the bytes of their accessors. */
async function animationsOf(blob: Blob): Promise<Record<string, Channel[]>> {
  const { json, bytes, start } = await partsOfGlb<any>(blob);
  const read = (index: number): Uint8Array => {
    const { bufferView, byteOffset = 0, count, type, componentType } = json.accessors[index];
    expect(componentType).toBe(5126);
    const size = { SCALAR: 1, VEC3: 3, VEC4: 4 }[type as 'SCALAR']!;
    const offset = start + (json.bufferViews[bufferView].byteOffset ?? 0) + byteOffset;
    return new Uint8Array(bytes.slice(offset, offset + count * size * 4));
  };
  return Object.fromEntries(
    (json.animations ?? []).map(({ name, channels, samplers }: any) => [
      name,
      channels.map(({ sampler, target }: any): Channel => {
        const { input, output, interpolation } = samplers[sampler];
        const node = json.nodes[target.node].name;
        return { node, path: target.path, interpolation, times: read(input), values: read(output) };
      }),
    ]),
  );
}

const floats = (bytes: Uint8Array): Float32Array => new Float32Array(bytes.buffer);
async function export_(scene: Scene): Promise<{ blob: Blob; leftOut: readonly string[] }> {
  scene.settings.backgroundColour = [0, 0, 0];
  return exportInTest(scene);
}

/** A scene with an object that draws a model, given as GLB. */
async function sceneOf(blob: Blob, name = 'Robot'): Promise<Scene> {
  const scene = new Scene();
  scene.assets.registerFile('robot.glb', blob);
  await scene.assets.load('robot.glb');
  const object = new GameObject(name);
  object.addComponent(ModelRenderer, { model: 'robot.glb' });
  scene.add(object);
  return scene;
}

function skinnedModel(): Model {
  const root = new Group();
  const hip = new Bone();
  const knee = new Bone();
  hip.name = 'Hip';
  knee.name = 'Knee';
  hip.add(knee);
  knee.position.set(0, 1, 0);
  const geometry = new BoxGeometry();
  const { count } = geometry.getAttribute('position');
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(new Uint16Array(count * 4), 4));
  const weights = new Float32Array(count * 4).map((_, i) => (i % 4 === 0 ? 1 : 0));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
  const skin = new SkinnedMesh(geometry, new MeshStandardMaterial());
  skin.name = 'Skin';
  skin.bind(new Skeleton([hip, knee]));
  const face = new Mesh(new BoxGeometry(), new MeshStandardMaterial());
  face.name = 'Face';
  face.geometry.morphAttributes.position = [0, 1].map(
    () => new Float32BufferAttribute(new Float32Array(count * 3).fill(0.1), 3),
  );
  face.geometry.morphTargetsRelative = true;
  face.updateMorphTargets();
  root.add(hip, skin, face);
  const s = Math.SQRT1_2;
  return new Model(root, [
    new AnimationClip('Walk', -1, [
      new VectorKeyframeTrack('Hip.position', [0, 0.3, 1.1], [0, 0.1, 1 / 3, 1, -0, 1e-9, 0, 4, 0]),
      new QuaternionKeyframeTrack('Knee.quaternion', [0, 2], [0, 0, 0, 1, 0, s, 0, s]),
      new VectorKeyframeTrack('Knee.scale', [0, 2], [1, 1, 1, 3, 3, 3], InterpolateDiscrete),
      new NumberKeyframeTrack('Face.morphTargetInfluences', [0, 1], [0, 0.7, 1, 0.5]),
    ]),
    new AnimationClip('Idle', -1, [new VectorKeyframeTrack('Hip.position', [0, 1], [0, 0, 0, 0, 0.01, 0])]),
  ]);
}

describe('clips of models', () => {
  test('go out with their bytes, of skeletons and morph weights too, and come in and go out again bit-equal', async () => {
    const scene = new Scene();
    const model = skinnedModel();
    scene.assets.register('robot', model);
    const object = new GameObject('Robot');
    object.addComponent(ModelRenderer, { model: 'robot' });
    scene.add(object);
    const first = await export_(scene);
    const out = await animationsOf(first.blob);
    expect(Object.keys(out)).toEqual(['Walk', 'Idle']);
    expect(out.Walk.map(({ node, path, interpolation }) => [node, path, interpolation])).toEqual([
      ['Hip', 'translation', 'LINEAR'],
      ['Knee', 'rotation', 'LINEAR'],
      ['Knee', 'scale', 'STEP'],
      ['Face', 'weights', 'LINEAR'],
    ]);
    out.Walk.forEach(({ times, values }, i) => {
      const track = model.animations[0].tracks[i];
      expect(times).toEqual(new Uint8Array(Float32Array.from(track.times).buffer));
      expect(values).toEqual(new Uint8Array(Float32Array.from(track.values).buffer));
    });
    const second = await export_(await sceneOf(first.blob));
    expect(await animationsOf(second.blob)).toEqual(out);
    const third = await export_(await sceneOf(second.blob));
    expect(await animationsOf(third.blob)).toEqual(out);
    expect(first.leftOut).toEqual([]);
  });

  test('of a model that stands there twice go out for each, under names of their own', async () => {
    const scene = new Scene();
    scene.assets.register('robot', skinnedModel());
    for (const name of ['One', 'Two']) {
      const object = new GameObject(name);
      object.addComponent(ModelRenderer, { model: 'robot' });
      scene.add(object);
    }
    const { blob } = await export_(scene);
    expect(Object.keys(await animationsOf(blob))).toEqual(['Walk', 'Idle', 'Walk (Two)', 'Idle (Two)']);
  });
});

const keys = (...pairs: [number, FieldValue, Partial<ClipKey>?][]): ClipKey[] =>
  pairs.map(([time, value, rest]) => ({ time, value, ...rest }));
const track = (field: string, list: ClipKey[], path = '', component = 'Transform'): ClipTrack => ({
  path,
  component,
  field,
  keys: list,
});

function clipScene(tracks: ClipTrack[], events: { time: number; method: string }[] = []): Scene {
  const scene = new Scene();
  scene.assets.addFieldAsset('clip', 'Clips/Open', { data: clipText({ tracks, events }), duration: 2 });
  const door = new GameObject('Door');
  const leaf = new GameObject('Leaf');
  leaf.addComponent(ObjectRenderer, { mesh: 'box' });
  leaf.addComponent(Light);
  door.add(leaf);
  door.addComponent(Animation, { clip: 'Clips/Open' });
  scene.add(door);
  return scene;
}

describe("clips of one's own", () => {
  test('go out as steps and lines with their numbers, and come in and go out again bit-equal', async () => {
    const scene = clipScene([
      track('position', keys([0, [0.1, 0, 0]], [0.7, [1 / 3, 2, 3]], [1.5, [0, 0, 0]]), 'Leaf'),
      track('scale', keys([0, [1, 1, 1], { easing: 'step' }], [1, [2, 2, 2]])),
      track('rotation', keys([0, [0.5, 0, 1]], [1.25, [0.5, 1, 1]]), 'Leaf'),
    ]);
    const { blob, leftOut } = await export_(scene);
    const out = await animationsOf(blob);
    expect(Object.keys(out)).toEqual(['Open']);
    const [position, scale, rotation] = out.Open;
    expect([position.interpolation, scale.interpolation, rotation.interpolation]).toEqual(['LINEAR', 'STEP', 'LINEAR']);
    expect([position.node, scale.node]).toEqual(['Leaf', 'Door']);
    expect(floats(position.times)).toEqual(Float32Array.of(0, 0.7, 1.5, 2));
    expect(floats(position.values)).toEqual(Float32Array.of(0.1, 0, 0, 0.333333333, 2, 3, 0, 0, 0, 0, 0, 0));
    expect(floats(rotation.times)).toEqual(Float32Array.of(0, 1.25));
    expect(leftOut).toEqual([]);
    const again = await animationsOf((await export_(await sceneOf(blob))).blob);
    expect(again).toEqual(out);
  });

  /** Pose that three shows for an exported clip at a time. */
  async function shownAt(tracks: ClipTrack[], time: number): Promise<{ node: Object3D; leftOut: readonly string[] }> {
    const { blob, leftOut } = await export_(clipScene(tracks));
    const scene = await sceneOf(blob);
    const model = scene.assets.model('robot.glb');
    const mixer = new AnimationMixer(model.scene);
    mixer.clipAction(model.animations[0]).play();
    mixer.setTime(time);
    return { node: model.scene.getObjectByName('Leaf')!, leftOut };
  }

  const field = { kind: 'vector3', default: [0, 0, 0], help: '' } as Vector3Field;

  test('with curves that are cubics of the time and holds among them are exact', async () => {
    const curve = track(
      'position',
      keys(
        [0, [0, 1, 2], { easing: 'bezier', control: [1 / 3, 1.4, 2 / 3, -0.3] }],
        [0.5, [3, 1, -2], { easing: 'step' }],
        [1, [4, 4, 4]],
        [1.5, [5, 0, 1], { easing: 'bezier' }],
        [1.9, [0, 0, 0]],
      ),
      'Leaf',
    );
    for (const time of [0.1, 0.3, 0.5, 0.7, 0.99, 1, 1.2, 1.6, 1.85]) {
      const { node, leftOut } = await shownAt([curve], time);
      const wanted = valueAt(curve, field, time) as [number, number, number];
      node.position.toArray().forEach((value, i) => expect(value).toBeCloseTo(wanted[i], 5));
      expect(leftOut).toEqual([]);
    }
    const out = await animationsOf((await export_(clipScene([curve]))).blob);
    expect(out.Open[0].interpolation).toBe('CUBICSPLINE');
  });

  test('with turns about one axis are exact, however far they go', async () => {
    const turn = track('rotation', keys([0, [0.3, 0, 0]], [1.9, [0.3, 0, 11]]), 'Leaf');
    for (const time of [0.2, 0.95, 1.4]) {
      const { node, leftOut } = await shownAt([turn], time);
      const object = new Object3D();
      object.rotation.set(0.3, 0, (11 * time) / 1.9);
      const sign = Math.sign(node.quaternion.dot(object.quaternion));
      const wanted = object.quaternion.toArray();
      node.quaternion.toArray().forEach((value, i) => expect(value * sign).toBeCloseTo(wanted[i], 6));
      expect(leftOut).toEqual([]);
    }
  });

  test('with other curves are sampled, which is told, as is what cannot go along', async () => {
    const eased = track(
      'position',
      keys([0, [0, 0, 0], { easing: 'bezier', control: [0.42, 0, 0.58, 1] }], [1.9, [1, 0, 0]]),
      'Leaf',
    );
    const sampled = 'Curves and turns that glTF does not have are sampled at the frame rate (1)';
    const { node, leftOut } = await shownAt([eased], 0.5);
    expect(leftOut).toEqual([sampled]);
    const wanted = valueAt(eased, field, 0.5) as [number, number, number];
    expect(node.position.x).toBeCloseTo(wanted[0], 3);
    const scene = clipScene(
      [eased, track('intensity', keys([0, 1]), 'Leaf', 'Light'), track('position', keys([0, [0, 0, 0]]), 'Gone')],
      [{ time: 0, method: 'onOpen' }],
    );
    scene.assets.addFieldAsset('clip', 'Unused', {});
    expect((await export_(scene)).leftOut).toEqual([
      'Events of clips are left out (1)',
      sampled,
      'glTF animates places, turns, sizes and morph weights only: left out are tracks of Light.intensity (1)',
      'Tracks of clips without a target are left out (1)',
      'Clips that no Animation plays are left out (1)',
    ]);
  });

  test('of morph targets are the weights of each mesh, and come in and go out again bit-equal', async () => {
    const scene = new Scene();
    scene.assets.register('robot', skinnedModel());
    const object = new GameObject('Robot');
    object.addComponent(ModelRenderer, { model: 'robot' });
    scene.add(object);
    const [renderer] = scene.componentsOf(ModelRenderer);
    renderer.set('morph.1', 0.25);
    const clip = (...tracks: ClipTrack[]): void => {
      const text = clipText({ tracks, events: [] });
      if (scene.assets.has('Grin')) scene.assets.fieldAsset('Grin')!.set('data', text);
      else scene.assets.addFieldAsset('clip', 'Grin', { data: text, duration: 2 });
    };
    const morph = (index: number, list: ClipKey[]): ClipTrack => track(`morph.${index}`, list, '', 'ModelRenderer');
    clip(morph(0, keys([0, 0], [1, 1])));
    object.addComponent(Animation, { clip: 'Grin' });
    const first = await export_(scene);
    const { json } = await partsOfGlb<any>(first.blob);
    expect(json.meshes.find(({ weights }: any) => weights)).toMatchObject({ weights: [0, 0.25] });
    const out = await animationsOf(first.blob);
    const [weights] = out.Grin;
    expect([weights.node, weights.path, weights.interpolation]).toEqual(['Face', 'weights', 'LINEAR']);
    // extended to the clip's end; the other weight stays constant
    expect(floats(weights.times)).toEqual(Float32Array.of(0, 1, 2));
    expect(floats(weights.values)).toEqual(Float32Array.of(0, 0.25, 1, 0.25, 1, 0.25));
    expect(await animationsOf((await export_(await sceneOf(first.blob))).blob)).toEqual(out);

    // steps and lines of two targets are exact; curves are sampled, and this is reported
    clip(morph(0, keys([0, 0], [2, 1])), morph(1, keys([0, 0, { easing: 'step' }], [1, 1], [2, 1])));
    const steps = await export_(scene);
    const [both] = (await animationsOf(steps.blob)).Grin;
    const before = 1 - 2 ** -24;
    expect(floats(both.times)).toEqual(Float32Array.of(0, before, 1, 2));
    expect(floats(both.values)).toEqual(Float32Array.of(0, 0, before / 2, 0, 0.5, 1, 1, 1));
    expect(steps.leftOut).toEqual([]);
    clip(morph(0, keys([0, 0, { easing: 'bezier', control: [0.42, 0, 0.58, 1] }], [2, 1])));
    expect((await export_(scene)).leftOut).toEqual([
      'Curves and turns that glTF does not have are sampled at the frame rate (1)',
    ]);
  });
});
