/**
 * CPU time of animation per frame: `npx vitest bench --run --config packages/vitest.config.ts
 * packages/engine/src/benchmarks`.
 */
import {
  AnimationClip,
  AnimationMixer,
  Bone,
  BoxGeometry,
  Float32BufferAttribute,
  Group,
  MeshStandardMaterial,
  QuaternionKeyframeTrack,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
  VectorKeyframeTrack,
} from 'three';
import { clone } from 'three/addons/utils/SkeletonUtils.js';
import { bench, describe } from 'vitest';
import { Model } from '../assets/Model';
import { Animation } from '../components/Animation';
import '../components/index';
import { ModelRenderer } from '../components/ModelRenderer';
import { createRandom } from '../base/createRandom';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { clipText } from '../assets/clips/clipText';

const FRAME = 1 / 60;

/** Objects that each play a clip of ten keys. */
function animatedObjects(count: number, easing: 'linear' | 'bezier', field: string): Scene {
  const scene = new Scene();
  const random = createRandom(1);
  const keys = Array.from({ length: 10 }, (_, i) => ({
    time: i / 3,
    value: [random(), random(), random()] as const,
    easing,
    control: [0.42, 0, 0.58, 1] as const,
  }));
  const data = clipText({ tracks: [{ path: '', component: 'Transform', field, keys }], events: [] });
  scene.assets.addFieldAsset('clip', 'Move', { data, duration: 3 });
  for (let i = 0; i < count; i++) {
    const object = new GameObject(`Object ${i}`);
    object.addComponent(Animation, { clip: 'Move', startTime: random() * 3 });
    scene.add(object);
  }
  scene.update(FRAME);
  return scene;
}

describe('1,000 animated objects of ten keys each', () => {
  for (const [easing, field] of [
    ['linear', 'position'],
    ['bezier', 'position'],
    ['linear', 'rotation'],
  ] as const) {
    const scene = animatedObjects(1000, easing, field);
    bench(`${field}, ${easing}`, () => scene.update(FRAME));
  }
  const empty = new Scene();
  for (let i = 0; i < 1000; i++) empty.add(new GameObject());
  bench('no animation', () => empty.update(FRAME));
});

const BONES = 65;

/** A character of 65 bones whose clip turns each, and moves the hip. */
function character(): Model {
  const bones = Array.from({ length: BONES }, (_, i) => {
    const bone = new Bone();
    bone.name = `Bone${i}`;
    return bone;
  });
  bones.slice(1).forEach((bone, i) => bones[Math.floor(i / 2)].add(bone));
  const geometry = new BoxGeometry();
  const { count } = geometry.getAttribute('position');
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(new Uint16Array(count * 4), 4));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(new Float32Array(count * 4).fill(0.25), 4));
  const skin = new SkinnedMesh(geometry, new MeshStandardMaterial());
  skin.add(bones[0]);
  skin.bind(new Skeleton(bones));
  const random = createRandom(2);
  const times = Float32Array.from({ length: 30 }, (_, i) => i / 15);
  const turns = (): Float32Array => Float32Array.from({ length: 120 }, () => random() - 0.5);
  const root = new Group();
  root.add(skin);
  return new Model(root, [
    new AnimationClip('Walk', 2, [
      ...bones.map(({ name }) => new QuaternionKeyframeTrack(`${name}.quaternion`, times as never, turns() as never)),
      ...bones.map(({ name }) => {
        const values = Float32Array.from({ length: 90 }, () => random());
        return new VectorKeyframeTrack(`${name}.position`, times as never, values as never);
      }),
    ]),
  ]);
}

describe('50 skinned characters of 65 bones and 130 tracks', () => {
  const model = character();
  const scene = new Scene();
  scene.assets.register('robot.glb', model);
  scene.assets.register('robot.glb/clip-1-Walk', model.clips[0]);
  for (let i = 0; i < 50; i++) {
    const object = new GameObject(`Robot ${i}`);
    object.addComponent(ModelRenderer, { model: 'robot.glb' });
    object.addComponent(Animation, { clip: 'robot.glb/clip-1-Walk', startTime: i / 25 });
    scene.add(object);
  }
  scene.update(FRAME);
  bench('Animation', () => scene.update(FRAME));
  const mixers = Array.from({ length: 50 }, (_, i) => {
    const mixer = new AnimationMixer(clone(model.scene));
    mixer.clipAction(model.animations[0]).play();
    mixer.setTime(i / 25);
    return mixer;
  });
  bench("three's mixer", () => mixers.forEach((mixer) => mixer.update(FRAME)));
});
