import { Animation, type ClipData, GameObject, Model, ModelRenderer, valueAt } from '@farol/engine';
import type { EulerField, Vector3Field, Vector3Tuple } from '@farol/engine/fields';
import {
  AnimationClip,
  BoxGeometry,
  Euler,
  InterpolateDiscrete,
  Mesh,
  MeshBasicMaterial,
  NumberKeyframeTrack,
  Object3D,
  Quaternion,
  QuaternionKeyframeTrack,
  SkinnedMesh,
  VectorKeyframeTrack,
} from 'three';
import { describe, expect, test } from 'vitest';
import { copyModelClip, makeEditableCopy, whyNotCopy } from './copyModelClip';
import { EditorDocument } from './EditorDocument';

const euler = { kind: 'euler', default: [0, 0, 0], unit: 'rad', help: '' } as EulerField;
const vector = { kind: 'vector3', default: [0, 0, 0], help: '' } as Vector3Field;

/** A track of rotations about changing axes, which linear angles cannot follow. */
function turns(): { times: number[]; values: number[] } {
  const times = [0, 0.5, 1.2, 2];
  const values = [
    [0.1, 0.2, 0.3],
    [1.4, 0.9, -0.6],
    [-2.8, 0.4, 2.9],
    [3.1, -0.8, -3],
  ].flatMap(([x, y, z]) => new Quaternion().setFromEuler(new Euler(x, y, z)).toArray());
  return { times, values };
}

function model(...more: Object3D[]): Model {
  const root = new Object3D();
  const arm = new Object3D();
  const hand = new Mesh(new BoxGeometry(), new MeshBasicMaterial());
  arm.name = 'Arm';
  hand.name = 'Hand';
  arm.add(hand);
  root.add(arm, ...more);
  const { times, values } = turns();
  return new Model(root, [
    new AnimationClip('Wave', -1, [
      new VectorKeyframeTrack('Arm.position', [0, 1], [0, 0, 0, 1, 2, 3]),
      new VectorKeyframeTrack('Hand.scale', [0, 1], [1, 1, 1, 2, 2, 2], InterpolateDiscrete),
      new QuaternionKeyframeTrack('Hand.quaternion', times, values),
      new NumberKeyframeTrack('Hand.morphTargetInfluences', [0, 1], [0, 1]),
    ]),
  ]);
}

describe('a copy of a clip of a model', () => {
  const source = model();
  const { data, lost } = copyModelClip(source.clips[0]);

  test('names objects by their path and keeps lines and steps as they are; morph weights are named as lost', () => {
    expect(data.tracks.map(({ path, field }) => [path, field])).toEqual([
      ['Arm', 'position'],
      ['Arm/Hand', 'scale'],
      ['Arm/Hand', 'rotation'],
    ]);
    expect(data.tracks[0].keys).toEqual([
      { time: 0, value: [0, 0, 0] },
      { time: 1, value: [1, 2, 3] },
    ]);
    expect(data.tracks[1].keys.map(({ easing }) => easing)).toEqual(['step', 'step']);
    expect(lost).toEqual(['Hand.morphTargetInfluences']);
  });

  test('turns as the model does to a thousandth of a radian, without a jump between angles', () => {
    const { times, values } = turns();
    const [, , track] = data.tracks;
    const interpolant = new QuaternionKeyframeTrack('x.quaternion', times, values).InterpolantFactoryMethodLinear(
      new Float64Array(4) as never,
    );
    let before: Vector3Tuple | null = null;
    for (let time = 0; time <= 2; time += 0.01) {
      const angles = valueAt(track, euler, time) as Vector3Tuple;
      const turn = new Quaternion().setFromEuler(new Euler(...angles));
      const wanted = new Quaternion().fromArray(interpolant.evaluate(time) as never);
      expect(turn.angleTo(wanted.normalize())).toBeLessThan(1e-3);
      const last = before ?? angles;
      angles.forEach((angle, i) => expect(Math.abs(angle - last[i])).toBeLessThan(0.5));
      before = angles;
    }
    expect(track.keys.length).toBeLessThan(200);
    expect(valueAt(data.tracks[0], vector, 0.5)).toEqual([0.5, 1, 1.5]);
  });

  test('is none of skeletons, which says why', () => {
    const skinned = model(new SkinnedMesh(new BoxGeometry(), new MeshBasicMaterial()));
    expect(whyNotCopy(source.clips[0])).toBeNull();
    expect(whyNotCopy(skinned.clips[0])).toMatch(/stays one object when the model is unpacked/);
  });

  test('becomes an asset that the components play, in one step', () => {
    const document = new EditorDocument();
    const { assets, scene } = document;
    assets.register('Props/robot.glb', source);
    assets.register('Props/robot.glb/clip-1-Wave', source.clips[0]);
    const object = new GameObject('Robot');
    object.addComponent(ModelRenderer, { model: 'Props/robot.glb' });
    const animation = object.addComponent(Animation, { clip: 'Props/robot.glb/clip-1-Wave' });
    scene.add(object);
    const { command, name } = makeEditableCopy([animation], 'Props/robot.glb/clip-1-Wave');
    expect(assets.has(name)).toBe(false);
    document.commands.run(command);
    expect([animation.clip, document.commands.history.length]).toEqual([name, 1]);
    const clip = assets.clip(name) as unknown as { clip: ClipData; duration: number };
    expect([clip.clip.tracks.length, clip.duration]).toEqual([3, 2]);
    document.commands.undo();
    expect([animation.clip, assets.has(name)]).toEqual(['Props/robot.glb/clip-1-Wave', false]);
    document.commands.redo();
    expect(animation.clip).toBe(name);
  });
});
