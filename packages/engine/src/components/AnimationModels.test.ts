import {
  AnimationClip,
  Bone,
  Mesh,
  BufferGeometry,
  NumberKeyframeTrack,
  Object3D,
  QuaternionKeyframeTrack,
  VectorKeyframeTrack,
  AnimationMixer,
} from 'three';
import { describe, expect, test } from 'vitest';
import './index';
import { Model } from '../assets/Model';
import { GameObject } from '../core/GameObject';
import { ModelRenderer } from './ModelRenderer';
import { stage, type Stage } from './testing/clipStage';

describe('clips of models', () => {
  function makeModel(): Model {
    const root = new Object3D();
    const hip = new Bone();
    hip.name = 'Hip';
    const nameless = new Object3D();
    const face = new Mesh(new BufferGeometry());
    face.name = 'Face';
    face.morphTargetInfluences = [0.25, 0];
    face.morphTargetDictionary = { smile: 0, frown: 1 };
    root.add(hip, face);
    hip.add(nameless);
    hip.position.set(1, 2, 3);
    hip.quaternion.set(0.1, 0.2, 0.3, 0.9).normalize();
    const s = Math.SQRT1_2;
    return new Model(root, [
      new AnimationClip('Walk', 2, [
        new VectorKeyframeTrack('Hip.position', [0, 1, 2], [0, 0, 0, 1, 1, 1, 0, 4, 0]),
        new QuaternionKeyframeTrack('Hip.quaternion', [0, 2], [0, 0, 0, 1, 0, s, 0, s]),
        new VectorKeyframeTrack(`${nameless.uuid}.scale`, [0, 2], [1, 1, 1, 3, 3, 3]),
        new NumberKeyframeTrack('Face.morphTargetInfluences', [0, 1], [0, 0, 1, 0.5]),
      ]),
      new AnimationClip('Idle', 1, [new VectorKeyframeTrack('Hip.position', [0], [0, 0, 0])]),
    ]);
  }

  function modelStage(): Stage & { renderer: ModelRenderer; hip: Object3D; face: Mesh } {
    const made = stage({});
    made.scene.assets.register('robot.glb', makeModel());
    for (const clip of made.scene.assets.model('robot.glb').clips)
      made.scene.assets.register(`robot.glb/clip-${clip.name}`, clip);
    const renderer = made.object.addComponent(ModelRenderer, { model: 'robot.glb' });
    const hip = renderer.three!.getObjectByName('Hip')!;
    const face = renderer.three!.getObjectByName('Face') as Mesh;
    made.animation.clip = 'robot.glb/clip-Walk';
    return { ...made, renderer, hip, face };
  }

  test("show to the bit what three's mixer shows: bones, morph weights, nodes without a name", () => {
    const { scene, hip, face, errors } = modelStage();
    const model = scene.assets.model('robot.glb');
    const source = model.scene.clone();
    const mixer = new AnimationMixer(source);
    // three's mixer cannot find the copy of a nameless node
    const [position, quaternion, , weights] = model.animations[0].tracks;
    mixer.clipAction(new AnimationClip('Walk', 2, [position, quaternion, weights])).play();
    for (const time of [0.25, 1, 1.75, 2.5]) {
      scene.setTime(time);
      mixer.setTime(time);
      expect(hip.position.toArray()).toEqual(source.getObjectByName('Hip')!.position.toArray());
      expect(hip.quaternion.toArray()).toEqual(source.getObjectByName('Hip')!.quaternion.toArray());
      expect(face.morphTargetInfluences).toEqual((source.getObjectByName('Face') as Mesh).morphTargetInfluences);
    }
    expect(hip.children[0].scale.x).toBeCloseTo(1.5, 6);
    expect(errors).toEqual([]);
  });

  test('are put back exactly when the scene is reset, and fade from and to it', () => {
    const { scene, hip, face, animation } = modelStage();
    const rest = () =>
      JSON.stringify([hip.position, hip.quaternion.toArray(), hip.rotation.toArray(), face.morphTargetInfluences]);
    const before = rest();
    scene.update(1.5);
    expect(rest()).not.toBe(before);
    scene.reset();
    expect(rest()).toBe(before);
    scene.update(0.5);
    animation.play('Idle', { fade: 1 });
    scene.update(0.5);
    expect(hip.position.x).toBeCloseTo(0.5, 6);
    expect(animation.playing).toBe('robot.glb/clip-Idle');
    scene.reset();
    expect(rest()).toBe(before);
  });

  test('move objects of the same names where the model was unpacked, and say which are gone', () => {
    const { scene, object, renderer, errors } = modelStage();
    object.removeComponent(renderer);
    const hip = new GameObject('Hip');
    object.add(hip);
    hip.transform.rotation = [0.1, 0.2, 0.3];
    scene.update(1);
    expect(hip.object3D.position.toArray()).toEqual([1, 1, 1]);
    expect(hip.object3D.quaternion.y).toBeCloseTo(Math.sin(Math.PI / 8), 6);
    expect(errors).toHaveLength(2);
    expect(errors[1]).toMatch(/'Robot\/Face' is gone/);
    scene.reset();
    expect(hip.object3D.rotation.toArray().slice(0, 3)).toEqual([0.1, 0.2, 0.3]);
  });

  test('are drawn anew with their model', () => {
    const { scene, renderer } = modelStage();
    scene.update(1);
    scene.assets.register('other.glb', scene.assets.model('robot.glb'));
    renderer.model = 'other.glb';
    scene.update(0.5);
    expect(renderer.three!.getObjectByName('Hip')!.position.y).toBeCloseTo(2.5, 6);
  });
});
